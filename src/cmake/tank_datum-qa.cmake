# tank_datum_add_qa(<cases file> [NAME <test>] [COMMAND <tank_datum>] [ARGS <argument>...])
# A test that runs the cases of a file as tank_datum_qa does: passed when all results are within tolerance. NAME is that
# of the test, by default the file's without its ending; COMMAND the program, by default the installed one; ARGS further
# arguments of tank_datum_qa, such as --junit FILE. The file is relative to the calling CMakeLists.txt.
function(tank_datum_add_qa cases)
  cmake_parse_arguments(PARSE_ARGV 1 qa "" "NAME;COMMAND" "ARGS")
  if(qa_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "tank_datum_add_qa: ${qa_UNPARSED_ARGUMENTS}, expected NAME, COMMAND or ARGS")
  endif()
  cmake_path(ABSOLUTE_PATH cases BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
  if(NOT EXISTS "${cases}")
    message(FATAL_ERROR "tank_datum_add_qa: ${cases}, expected a file of cases")
  endif()
  if(NOT qa_NAME)
    cmake_path(GET cases STEM qa_NAME)
  endif()
  if(NOT qa_COMMAND)
    set(qa_COMMAND ${tank_datum_COMMAND})
  endif()
  find_package(Python3 3.11 REQUIRED COMPONENTS Interpreter)
  add_test(NAME ${qa_NAME}
           COMMAND ${Python3_EXECUTABLE} -m tank_datum_qa ${cases} --command ${qa_COMMAND} ${qa_ARGS})
  set_tests_properties(${qa_NAME} PROPERTIES ENVIRONMENT "PYTHONPATH=${tank_datum_QA_DIR}")
endfunction()
