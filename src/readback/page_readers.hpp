// page_readers: the equations to be read, by programs and by people, compared by value.
#pragma once

#include "readback/dialect.hpp"
#include "readback/equation_reader.hpp"

namespace elgen {

/// The sidecar of equations: everything in it but hashes and the line that says what made it.
void read_sidecar(const SourceText& source, const Origin& origin, EquationReader& equations);

/// The tables of a Markdown page: values of parameters, and operations. Its equations are LaTeX,
/// which is not read.
void read_page(const SourceText& source, const Origin& origin, EquationReader& equations);

/// The page that `show` prints as text; a function without a section has no entry but 0.
///
///     gravity
///       gravity[1] = 0
///       gravity[2] = -m*l*g*sin(theta)
void read_text(const SourceText& source, const Origin& origin, EquationReader& equations);

}  // namespace elgen
