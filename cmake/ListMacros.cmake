# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DCXX=... -DOUTPUT=FILE -P ListMacros.cmake
#
# Lists the macros of the C and C++ libraries and of Eigen, for every standard of emitted code, and writes those that
# could be names of a model to OUTPUT. Omitted are names that begin with an underscore, contain two in a row, or have
# a reserved prefix (listed in reserved_names.cpp).
set(c_headers assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdalign stdarg
    stdbool stddef stdint stdio stdlib stdnoreturn string time uchar wchar wctype)
set(cpp_headers bits/stdc++.h Eigen/Core)

set(c_text "")
foreach(header IN LISTS c_headers)
  string(APPEND c_text "#include <${header}.h>\n")
endforeach()
set(cpp_text "")
foreach(header IN LISTS cpp_headers)
  string(APPEND cpp_text "#include <${header}>\n")
endforeach()

set(names)
# add_macros(LANGUAGE STANDARD TEXT): adds the macros that are defined after TEXT.
function(add_macros language standard text)
  file(WRITE ${OUTPUT}.input "${text}")
  execute_process(COMMAND ${CXX} -x ${language} -std=${standard} -isystem /usr/include/eigen3 -E -dM ${OUTPUT}.input
                  OUTPUT_VARIABLE defined COMMAND_ERROR_IS_FATAL ANY)
  file(REMOVE ${OUTPUT}.input)
  string(REGEX MATCHALL "#define [A-Za-z][A-Za-z0-9_]*" found "${defined}")
  list(TRANSFORM found REPLACE "#define " "")
  list(FILTER found EXCLUDE REGEX "__|^(M_|FP_|MATH_|DBL_|FLT_|LDBL_|INT_|EIGEN_)")
  set(names ${names} ${found} PARENT_SCOPE)
endfunction()

foreach(standard c99 gnu99 gnu17)
  add_macros(c ${standard} "${c_text}")
endforeach()
foreach(standard c++17 gnu++20)
  add_macros(c++ ${standard} "${cpp_text}")
endforeach()
list(REMOVE_DUPLICATES names)
list(SORT names)

set(text "// Macros of the C and C++ libraries and of Eigen, sorted; target library_macros writes this file.")
set(line "")
foreach(name IN LISTS names)
  string(LENGTH "${line} \"${name}\"," length)
  if(length GREATER 118)
    string(APPEND text "\n${line}")
    set(line "")
  endif()
  string(APPEND line "\"${name}\", ")
endforeach()
string(APPEND text "\n${line}\n")
string(REPLACE ", \n" ",\n" text "${text}")
file(WRITE ${OUTPUT} "${text}")
