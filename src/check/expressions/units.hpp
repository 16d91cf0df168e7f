// Units: what `kg*m^2/s`, `N/(m*s)`, `m^(1/2)` and `1` mean; units of expressions, inferred from
// the leaves, compared where terms meet and where a place asks; and what messages say of them:
// hints beside an error, and notes where nothing is wrong.
#pragma once

#include <optional>
#include <string>

#include "base/report.hpp"
#include "check/names/context.hpp"
#include "elgen/model.hpp"
#include "elgen/syntax.hpp"
#include "elgen/units.hpp"

namespace elgen {

/// The unit a string names; nothing after E402. `*` and `/` bind from left to right. `value` is
/// what is given in it, where that is known.
[[nodiscard]] std::optional<Unit> read_unit(const ValueSyntax& unit, Report& report,
                                            const ValueSyntax* value = nullptr);

/// Whether a variable or parameter has a unit other than 1; otherwise units are not checked.
[[nodiscard]] bool uses_units(const FileSyntax& model);

/// E401, E403, E404, a note E405 of values that name nothing, and one E520 that lists what has no
/// unit. The model has no cycles.
void check_units(Context& context);

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
