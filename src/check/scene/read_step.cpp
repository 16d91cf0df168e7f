// The method of a step: its number in the table, and how often it iterates.
#include "check/scene/read_step.hpp"

#include <cln/integer.h>
#include <fmt/format.h>

#include <algorithm>

#include "elgen/step_methods.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

std::string one_of_them() {
  std::vector<std::string_view> names;
  for (const StepMethodRow& row : step_methods) names.push_back(row.name);
  return fmt::format("one of {}, which are straight-line code", fmt::join(names, ", "));
}

void report_unknown(const ValueSyntax& value, Report& report) {
  std::vector<std::string> names;
  for (const StepMethodRow& row : step_methods) names.emplace_back(row.name);
  const std::string hint = suggestion(value.text, names);
  report.add(Code::E620, value.span, "`step` has no method " + in_backticks(value.text),
             hint.empty() ? one_of_them() : hint);
}

void refuse_keys(const ValueSyntax& entry, const OutputRequest& output, Report& report) {
  for (const std::string_view name : {"method", "iterations"}) {
    const KeySyntax* key = entry.find(name);
    if (key == nullptr) continue;
    report.add(Code::E103, key->key_span,
               fmt::format("`{}` has no `{}`: `step` has one", output.name, name));
  }
}

void read_iterations(const KeySyntax& key, OutputRequest& output, Report& report) {
  const StepMethodRow& method = step_methods[output.user];
  if (method.iterations == 0) {
    return report.add(Code::E626, key.key_span,
                      fmt::format("`{}` is explicit: it iterates nothing", method.name));
  }
  const cln::cl_RA& count = key.value.expression.value;
  if (count < 1 || count > most_step_iterations) {
    return report.add(Code::E626, key.value.span,
                      fmt::format("`iterations` {} is not one of 1 to {}",
                                  in_backticks(key.value.span), most_step_iterations));
  }
  output.iterations = cln::cl_I_to_uint(cln::floor1(count));
}

}  // namespace

void read_step(const ValueSyntax& entry, OutputRequest& output, Report& report) {
  if (!output_row(output.kind).steps) return refuse_keys(entry, output, report);
  const KeySyntax* method = entry.find("method");
  if (method == nullptr) {
    return report.add(Code::E105, output.span, "`step` needs a `method`, which a scene gives it",
                      one_of_them());
  }
  const auto found = std::ranges::find(step_methods, method->value.text, &StepMethodRow::name);
  if (found == step_methods.end()) return report_unknown(method->value, report);
  output.user = static_cast<std::uint32_t>(found - step_methods.begin());
  output.iterations = found->iterations;
  const KeySyntax* iterations = entry.find("iterations");
  if (iterations != nullptr) read_iterations(*iterations, output, report);
}

}  // namespace elgen
