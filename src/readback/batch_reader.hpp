// batch_reader: the header of functions on arrays of states, from the first token to the last.
#pragma once

#include "readback/dialect.hpp"
#include "readback/token_reader.hpp"

namespace elgen {

/// Its polynomials are those of the table, and every function loads the arguments that the other
/// header wants and stores every field in its place.
void read_batch_header(TokenReader& tokens, const Origin& origin);

}  // namespace elgen
