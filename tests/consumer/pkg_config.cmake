# The consumer built by pkg-config alone, and refused beside another PCL.
set(ENV{PKG_CONFIG_PATH} "")
file(GLOB_RECURSE pc_file ${PREFIX}/tank_datum.pc)
get_filename_component(pc_dir ${pc_file} DIRECTORY)
get_filename_component(lib_dir ${pc_dir} DIRECTORY)
set(ENV{PKG_CONFIG_PATH} ${pc_dir})
execute_process(COMMAND pkg-config --cflags --libs tank_datum OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY
                OUTPUT_STRIP_TRAILING_WHITESPACE)
if(flags MATCHES "vtk|Qt[56]|mpi")
  message(FATAL_ERROR "pkg-config gives ${flags}")
endif()
separate_arguments(flags)
file(MAKE_DIRECTORY ${WORK})
execute_process(COMMAND ${CXX} -std=c++17 ${CMAKE_CURRENT_LIST_DIR}/main.cpp ${flags} -o ${WORK}/consumer
                COMMAND_ERROR_IS_FATAL ANY)
set(ENV{LD_LIBRARY_PATH} ${lib_dir})
execute_process(COMMAND ${WORK}/consumer ${SCAN} ${RADIUS} COMMAND_ERROR_IS_FATAL ANY)

file(WRITE ${WORK}/pcl_common.pc "Name: pcl_common\nDescription: another\nVersion: 1.99.0\n")
set(ENV{PKG_CONFIG_PATH} ${WORK}:${pc_dir})
execute_process(COMMAND pkg-config --libs tank_datum RESULT_VARIABLE status ERROR_VARIABLE message)
if(status EQUAL 0 OR NOT message MATCHES "1.99.0")
  message(FATAL_ERROR "another PCL was accepted: ${message}")
endif()
