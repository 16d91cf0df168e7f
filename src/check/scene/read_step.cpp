// The method of a step: its number in the table.
#include "check/scene/read_step.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "elgen/step_methods.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

std::string one_of_them() {
  std::vector<std::string_view> names;
  for (const StepMethodRow& row : step_methods) names.push_back(row.name);
  return fmt::format("one of {}: explicit methods, which are straight-line code",
                     fmt::join(names, ", "));
}

void report_unknown(const ValueSyntax& value, Report& report) {
  std::vector<std::string> names;
  for (const StepMethodRow& row : step_methods) names.emplace_back(row.name);
  const std::string hint = suggestion(value.text, names);
  report.add(Code::E620, value.span, "`step` has no method " + quoted(value.text),
             hint.empty() ? one_of_them() : hint);
}

}  // namespace

void read_step_method(const KeySyntax* method, OutputRequest& output, Report& report) {
  if (!output_row(output.kind).steps) {
    if (method == nullptr) return;
    return report.add(Code::E103, method->key_span,
                      fmt::format("`{}` has no `method`: `step` has one", output.name));
  }
  if (method == nullptr) {
    return report.add(Code::E105, output.span, "`step` needs a `method`, which a scene gives it",
                      one_of_them());
  }
  const auto found = std::ranges::find(step_methods, method->value.text, &StepMethodRow::name);
  if (found == step_methods.end()) return report_unknown(method->value, report);
  output.user = static_cast<std::uint32_t>(found - step_methods.begin());
}

}  // namespace elgen
