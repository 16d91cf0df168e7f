// entry_units: the units of a field's entries as text.
#pragma once

#include <string>

#include "elgen/model.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// "kg, kg*m; kg*m, kg*m^2", or one unit where all are equal; empty where one is unknown or the
/// list is too long to help.
[[nodiscard]] std::string units_text(const Model& model, OutputKind kind, const Field& field);

}  // namespace elgen
