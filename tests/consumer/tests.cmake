# Tests of the installed package: an install of this build in the build tree, used by the project beside this file.
set(consumer_dir ${CMAKE_CURRENT_BINARY_DIR}/consumer)
set(consumer_prefix ${consumer_dir}/prefix)
set(consumer_scan ${CMAKE_CURRENT_SOURCE_DIR}/data/sample.pcd)
set(consumer_radius 5.0)

# consumer_test(<name> <needs> COMMAND...): a test that runs after what it needs
function(consumer_test name needs)
  add_test(NAME ${name} ${ARGN})
  set_tests_properties(${name} PROPERTIES LABELS consumer TIMEOUT 300 FIXTURES_REQUIRED "${needs}")
endfunction()

# consumer_configure(<name> <folder> [definitions...])
function(consumer_configure name folder)
  consumer_test(${name} consumer_prefix COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_SOURCE_DIR}/consumer
                -B ${consumer_dir}/${folder} --fresh -G ${CMAKE_GENERATOR} -DCMAKE_PREFIX_PATH=${consumer_prefix}
                -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} ${ARGN})
endfunction()

function(consumer_script name needs script)
  consumer_test(${name} "${needs}" COMMAND ${CMAKE_COMMAND} -DPREFIX=${consumer_prefix} -DBUILD=${consumer_dir}/build
                -DWORK=${consumer_dir}/${name} -DCXX=${CMAKE_CXX_COMPILER} -DSCAN=${consumer_scan}
                -DRADIUS=${consumer_radius} -DSHARED=${BUILD_SHARED_LIBS} -P ${CMAKE_CURRENT_SOURCE_DIR}/consumer/${script}.cmake)
endfunction()

consumer_test(consumer_install "" COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR}
              --prefix ${consumer_prefix} --component library)
set_tests_properties(consumer_install PROPERTIES FIXTURES_SETUP consumer_prefix)

consumer_configure(consumer_configure build -DCMAKE_BUILD_TYPE=Release -DWANTED_VERSION=${PROJECT_VERSION})
set_tests_properties(consumer_configure PROPERTIES FIXTURES_SETUP consumer_configured)
consumer_test(consumer_build consumer_configured COMMAND ${CMAKE_COMMAND} --build ${consumer_dir}/build)
set_tests_properties(consumer_build PROPERTIES FIXTURES_SETUP consumer_built)

consumer_test(consumer_runs consumer_built COMMAND ${consumer_dir}/build/consumer ${consumer_scan} ${consumer_radius})
consumer_test(consumer_runs_a_point_type_of_its_own consumer_built
              COMMAND ${consumer_dir}/build/custom_point ${consumer_scan} ${consumer_radius})
consumer_test(consumer_runs_the_documented_chain consumer_built
              COMMAND ${consumer_dir}/build/documented_chain ${consumer_scan} ${consumer_radius})
consumer_script(consumer_links_neither_VTK_nor_Qt consumer_built links)
consumer_script(consumer_through_pkg_config consumer_prefix pkg_config)
consumer_script(consumer_sees_public_symbols_only consumer_prefix symbols)

consumer_test(consumer_install_commands consumer_prefix COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR}
              --prefix ${consumer_prefix} --component commands)
set_tests_properties(consumer_install_commands PROPERTIES FIXTURES_SETUP consumer_commands)
consumer_script(consumer_runs_its_own_cases "consumer_prefix;consumer_commands" qa)

consumer_configure(consumer_is_refused_a_newer_version newer -DWANTED_VERSION=99.0)
set_tests_properties(consumer_is_refused_a_newer_version PROPERTIES PASS_REGULAR_EXPRESSION
                     "compatible with requested version \"99.0\"")

file(CONFIGURE OUTPUT consumer/other_pcl/pcl/pcl_config.h CONTENT "#define PCL_VERSION_PRETTY \"1.99.0\"\n")
consumer_configure(consumer_is_refused_another_PCL refused
                   -DTANK_DATUM_PCL_INCLUDE_DIR=${consumer_dir}/other_pcl)
set_tests_properties(consumer_is_refused_another_PCL PROPERTIES PASS_REGULAR_EXPRESSION
                     "cannot be used with PCL[ \n]+1[.]99[.]0")
