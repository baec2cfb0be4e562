# tank_datum_embed(<source> <text file> <name>): a source file with the function <name>() of embedded.h, which returns the
# file's text. In pieces, since compilers bound the length of a string literal.
function(tank_datum_embed source file name)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${file})
  file(READ ${file} text)
  string(LENGTH "${text}" length)
  set(pieces "")
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${text}" ${at} 8000 piece)
    string(APPEND pieces "\n      R\"embedded(${piece})embedded\"")
    math(EXPR at "${at} + 8000")
  endwhile()
  file(CONFIGURE OUTPUT ${source} @ONLY CONTENT "#include \"io/embedded.h\"

const std::string& tank_datum::embedded::@name@() {
  static const std::string text =@pieces@;
  return text;
}
")
endfunction()
