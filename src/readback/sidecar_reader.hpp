// sidecar_reader: the equations as JSON, compared with the Program: names, shapes, entries and
// definitions by value, values of parameters, counts of operations.
#pragma once

#include "readback/dialect.hpp"
#include "readback/equation_reader.hpp"

namespace elgen {

void read_sidecar(const SourceText& source, const Origin& origin, EquationReader& equations);

}  // namespace elgen
