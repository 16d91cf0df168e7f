// emission_checks: all languages have the same messages. Each value is correctly rounded to each
// scalar of the scene; the rounded value is checked.
#include "emit/text/emission_checks.hpp"

#include <fmt/format.h>

#include "elgen/emitted_files.hpp"
#include "emit/interface/code_interface.hpp"
#include "numbers/exact_number.hpp"
#include "numbers/scalar_literal.hpp"

namespace elgen {
namespace {

/// A value, its description in the message, and its span in the file.
struct CheckedNumber {
  const cln::cl_R& value;
  std::string name;
  Span span;
};

void check_number_range(const CheckedNumber& candidate, const Scene& scene,
                        Diagnostics& diagnostics) {
  for (const ScalarKind scalar : scene.numerics.computed_scalars()) {
    const ScalarFit result = scalar_fit(candidate.value, scalar);
    if (result == ScalarFit::fits) continue;
    const char* const fault = result == ScalarFit::too_large ? "overflows" : "vanishes";
    diagnostics.push_back(
        {Code::E702, candidate.span,
         fmt::format("`{}`{} {} in {}", literal_text(rounded_decimal(candidate.value, 6)),
                     candidate.name, fault, name_of(scalar))});
  }
}

/// The span of the first number in the model that equals `value` or -`value`; an empty span if
/// elgen computed `value`.
Span span_of_number(const Model& model, const cln::cl_R& value) {
  for (const Expression& expression : model.expressions) {
    const bool is_written = expression.kind == ExpressionKind::number;
    if (is_written && cln::abs(expression.number) == cln::abs(value)) return expression.span;
  }
  return {};
}

}  // namespace

Diagnostic reserved_name_error(const std::string& name, const char* what, const Span& span) {
  return {Code::E701, span,
          fmt::format("`{}` cannot name a {}: the emitted code uses this name", name, what)};
}

Diagnostic reserved_name_error(const Scene& scene, const Function& function) {
  const OutputRequest* request = find_request(scene, function.name);
  return reserved_name_error(function.name, "function",
                             request == nullptr ? Span{} : request->span);
}

Diagnostics check_scalar_range(const Model& model, const Scene& scene, const Program& program) {
  Diagnostics diagnostics;
  for (const ParameterArray& array : emitted_parameters(model, program)) {
    for (std::uint32_t i = 0; i < array.count; ++i) {
      const Parameter& parameter = model.parameters[array.first + i];
      check_number_range(
          {parameter.value, fmt::format(", the value of `{}`,", parameter.name), array.span}, scene,
          diagnostics);
    }
  }
  for (const Constant& constant : executed_constants(program)) {
    check_number_range(
        {constant.value, ", a constant of the equations,", span_of_number(model, constant.value)},
        scene, diagnostics);
  }
  sort_by_position(diagnostics);
  return diagnostics;
}

bool literals_fit(const Model& model, const Program& program, ScalarKind scalar) {
  Scene scene;
  scene.numerics.scalars = {scalar};
  return check_scalar_range(model, scene, program).empty();
}

}  // namespace elgen
