// number_reader: a number as C++ headers write it for every scalar, compared with the exact one.
//
//     constant<Scalar>(0.5)
//     -constant<Scalar>(0.1F, 0.1, 0.1L, {1}, {10})
#pragma once

#include <cln/real.h>

#include "elgen/scene.hpp"
#include "readback/token_reader.hpp"

namespace elgen {

/// Reads it with its sign. Literals have to round to the number, chunks have to be the number: of
/// an irrational one its first 66 digits.
void read_cpp_number(TokenReader& tokens, const cln::cl_R& number);

/// "-9.81f": of C.
void read_c_number(TokenReader& tokens, const cln::cl_R& number, ScalarKind scalar);

}  // namespace elgen
