// header_reader: a header of each shape, from the first token to the last.
#pragma once

#include "readback/dialect.hpp"
#include "readback/equation_reader.hpp"
#include "readback/expression_reader.hpp"
#include "readback/token_reader.hpp"

namespace elgen {

/// Reads the header of the scene's language, and the equations in its comments. The scope of its
/// functions: what the header of Eigen may name as well.
[[nodiscard]] FileScope read_header(TokenReader& tokens, const Origin& origin,
                                    EquationReader& equations);

/// Reads the header of Eigen, which includes the other one.
void read_eigen_header(TokenReader& tokens, const FileScope& header);

}  // namespace elgen
