# SPDX-License-Identifier: MIT
# A text file as a C++ function; it is cut into many literals, for compilers bound the length of one.
file(READ ${IN} text)
set(pieces "")
string(LENGTH "${text}" length)
set(at 0)
while(at LESS length)
  string(SUBSTRING "${text}" ${at} 12000 piece)
  string(APPEND pieces "      R\"~~~(${piece})~~~\",\n")
  math(EXPR at "${at} + 12000")
endwhile()
file(WRITE ${OUT} "#include <string>
#include <string_view>
namespace ${SPACE} {
std::string_view ${STEM}();
std::string_view ${STEM}() {
  static const std::string text = [] {
    std::string all;
    for (const char* piece : {
${pieces}        \"\"}) all += piece;
    return all;
  }();
  return text;
}
}
")
