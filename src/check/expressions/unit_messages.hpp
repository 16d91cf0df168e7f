// Hints on units beside an error: the number that wants a name, and where a name of the expression
// has its unit from; and notes where nothing is wrong.
#pragma once

#include <optional>
#include <string>

#include "check/names/context.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// A unit of what stands in a place, or in a part of it.
[[nodiscard]] std::string unit_text_in(const Place& place, const Unit& unit);

/// "" unless a number stands in the expression, beside names, that should have a unit.
[[nodiscard]] std::string unnamed_number_hint(const Model& model, ExpressionId expression);

/// A name and its unit, where it is declared.
struct UnitDeclaration {
  Span span = {};
  std::string message = {};  ///< "`k` is declared here, in N/m"
};

/// The first parameter of the expression has it, else its first coordinate or input.
[[nodiscard]] std::optional<UnitDeclaration> unit_declaration(const Model& model,
                                                              ExpressionId expression);

/// E405: the first value that names nothing, and how many more there are.
void note_plain_numbers(Context& context);

/// E520: names of what has no unit, each once, and where the first of them is declared.
void note_missing_units(Context& context);

}  // namespace elgen
