// What helps beside a message about units: the number that wants a name, and where a name of the
// expression has its unit from.
#pragma once

#include <optional>
#include <string>

#include "elgen/model.hpp"

namespace elgen {

/// "" unless a number stands in the expression, beside names, that should have a unit.
[[nodiscard]] std::string unnamed_number_hint(const Model& model, ExpressionId expression);

/// A name and its unit, where it is declared.
struct UnitDeclaration {
  Span span = {};
  std::string message = {};  ///< "`k` is declared here, in N/m"
};

/// Of the first parameter of the expression, else of its first coordinate or input.
[[nodiscard]] std::optional<UnitDeclaration> unit_declaration(const Model& model,
                                                              ExpressionId expression);

}  // namespace elgen
