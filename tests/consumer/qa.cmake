# A project of its own that runs cases by tank_datum_add_qa, its CMakeLists.txt as src/doc/qa.md has it: they pass, and
# fail once the fixture is another.
file(REMOVE_RECURSE ${WORK})
file(READ ${CMAKE_CURRENT_LIST_DIR}/../../src/doc/qa.md page)
string(REGEX MATCH "```cmake\n([^`]*)```" block "${page}")
file(WRITE ${WORK}/CMakeLists.txt "${CMAKE_MATCH_1}")
file(WRITE ${WORK}/cases.toml "[[case]]\nname = \"spring\"\ninputs = [\"scan.pcd\"]\noptions = [\"--stations\", \"36\"]\n")
file(COPY_FILE ${SCAN} ${WORK}/scan.pcd)

# run(<status: 0 or other> <command>...)
function(run wanted)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE status OUTPUT_VARIABLE output
                  ERROR_VARIABLE output)
  if(wanted EQUAL 0 AND NOT status EQUAL 0 OR NOT wanted EQUAL 0 AND status EQUAL 0)
    message(FATAL_ERROR "${ARGN}: status ${status}, expected ${wanted}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

run(0 ${PREFIX}/bin/tank_datum_qa cases.toml --update)
run(0 ${CMAKE_COMMAND} -S . -B build -DCMAKE_PREFIX_PATH=${PREFIX} -DCMAKE_CXX_COMPILER=${CXX})
run(0 ${CMAKE_CTEST_COMMAND} --test-dir build --no-tests=error)
file(READ ${WORK}/spring/stations.csv stations)
string(REPLACE "measured" "missing" stations "${stations}")
file(WRITE ${WORK}/spring/stations.csv "${stations}")
run(1 ${CMAKE_CTEST_COMMAND} --test-dir build --output-on-failure)
if(NOT output MATCHES "stations.csv +flag +\"missing\" became \"measured\"")
  message(FATAL_ERROR "the failure does not say what moved:\n${output}")
endif()
