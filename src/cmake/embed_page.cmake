# cmake -DPAGE=DIR -DLIBRARY=d3.min.js -DOUTPUT=page.cpp -P embed_page.cmake: the report's page as C++ text.
# The scripts of DIR/js run in the order of their names.
cmake_minimum_required(VERSION 3.25)
file(READ "${PAGE}/report.html" html)
file(READ "${PAGE}/report.css" styles)
file(READ "${PAGE}/licences.txt" licences)
file(READ "${LIBRARY}" library)
file(GLOB names "${PAGE}/js/*.js")
list(SORT names)
set(scripts "")
foreach(name IN LISTS names)
  file(READ "${name}" script)
  string(APPEND scripts "${script}\n")
endforeach()
# The words of the page, {"de":{...},"en":{...}}, one file a language
file(GLOB languages "${PAGE}/words/*.json")
list(SORT languages)
set(words "")
foreach(name IN LISTS languages)
  file(READ "${name}" spoken)
  string(FIND "${spoken}" "<" markup)
  if(NOT markup EQUAL -1)
    message(FATAL_ERROR "${name}: a < inside could end the page's data")
  endif()
  cmake_path(GET name STEM language)
  string(STRIP "${spoken}" spoken)
  string(APPEND words ",\"${language}\":${spoken}")
endforeach()
string(REGEX REPLACE "^," "{" words "${words}")
string(APPEND words "}")
foreach(part styles words licences library scripts)
  if(part STREQUAL "library" OR part STREQUAL "scripts")
    string(FIND "${${part}}" "</script" closing)
    if(NOT closing EQUAL -1)
      message(FATAL_ERROR "${part}: a </script inside would end the page's script")
    endif()
  endif()
  string(REPLACE "@${part}@" "${${part}}" html "${html}")
endforeach()

set(mark "@data@")
string(FIND "${html}" "${mark}" at)
if(at EQUAL -1)
  message(FATAL_ERROR "report.html: no ${mark}")
endif()
string(LENGTH "${mark}" length)
math(EXPR after "${at} + ${length}")
string(SUBSTRING "${html}" 0 ${at} before_data)
string(SUBSTRING "${html}" ${after} -1 after_data)
file(WRITE "${OUTPUT}" "#include \"report/report_template.h\"

namespace tank_datum {

const std::string_view kPageBeforeData = R\"PAGE(${before_data})PAGE\";
const std::string_view kPageAfterData = R\"PAGE(${after_data})PAGE\";
const std::string_view kWords = R\"PAGE(${words})PAGE\";

}  // namespace tank_datum
")
