// page_reader: the tables of a Markdown page: values of parameters, and operations. Its equations
// are LaTeX, which is not read.
#pragma once

#include "readback/dialect.hpp"
#include "readback/equation_reader.hpp"

namespace elgen {

void read_page(const SourceText& source, const Origin& origin, EquationReader& equations);

}  // namespace elgen
