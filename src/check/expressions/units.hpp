// Units: reads unit texts such as `kg*m^2/s`, `N/(m*s)`, `m^(1/2)` and `1`. Infers the units of
// expressions from their leaves. Compares the units of the terms of a sum, and the unit of each
// value with the unit that its place expects. Writes hints and notes about units.
#pragma once

#include <optional>
#include <string>

#include "base/report.hpp"
#include "check/names/context.hpp"
#include "elgen/model.hpp"
#include "elgen/syntax.hpp"
#include "elgen/units.hpp"

namespace elgen {

/// The unit that a text denotes; none after E402. `*` and `/` associate to the left. `value`, if
/// known, is the value in this unit; the hint of E402 converts the value.
[[nodiscard]] std::optional<Unit> read_unit(const ValueSyntax& unit, Report& report,
                                            const ValueSyntax* value = nullptr);

/// True if a variable or parameter has a unit other than 1. If false, no unit is checked.
[[nodiscard]] bool uses_units(const FileSyntax& model);

/// Reports E401, E403, E404, a note E405 on values without names, and one note E520 that lists the
/// entries without a unit. The model must have no cycles.
void check_units(Context& context);

/// The text of a unit in messages about the place; kg*m^2/s^2 is N*m for forces, else J.
[[nodiscard]] std::string role_unit_text(const ExpressionRole& place, const Unit& unit);

/// Hint on the first non-zero number in the expression, which may lack a unit; "" if there is none.
[[nodiscard]] std::string unnamed_number_hint(const Model& model, ExpressionId expression);

/// The declaration of a name with a unit, as the related location of an error.
struct UnitDeclaration {
  Span span = {};
  std::string message = {};  ///< "`k` is declared here, in N/m"
};

/// The declaration of the first parameter with a unit; otherwise of the first coordinate, input or
/// open function with a unit.
[[nodiscard]] std::optional<UnitDeclaration> unit_declaration(const Model& model,
                                                              ExpressionId expression);

/// Reports the note E405 at the first value without names, with the number of further values.
void report_plain_numbers(Context& context);

/// Reports the note E520 at the first entry without a unit, with the names of all these entries.
void report_missing_units(Context& context);

}  // namespace elgen
