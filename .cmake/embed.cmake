# SPDX-License-Identifier: MIT
# A text file as a C++ function; long literals are cut, for compilers bound the length of one.
file(READ ${IN} text)
set(pieces "")
string(LENGTH "${text}" length)
set(at 0)
while(at LESS length)
  string(SUBSTRING "${text}" ${at} 12000 piece)
  string(APPEND pieces "R\"~~~(${piece})~~~\"\n")
  math(EXPR at "${at} + 12000")
endwhile()
file(WRITE ${OUT} "#include <string_view>\nnamespace ${SPACE} {\nstd::string_view ${STEM}();\nstd::string_view ${STEM}() {\n  return ${pieces};\n}\n}\n")
