// text_reader: the page of equations that `show` prints as text, compared by value.
//
//     gravity
//       gravity[1] = 0
//       gravity[2] = -m*l*g*sin(theta)
#pragma once

#include "readback/dialect.hpp"
#include "readback/equation_reader.hpp"

namespace elgen {

/// A function without a section has no entry but 0.
void read_text(const SourceText& source, const Origin& origin, EquationReader& equations);

}  // namespace elgen
