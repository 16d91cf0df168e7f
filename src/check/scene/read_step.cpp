// Steps of a scene: method, order, iterations, and the models that a method does not support.
#include <cln/integer.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/report.hpp"
#include "check/scene/scene.hpp"
#include "elgen/step_methods.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

/// Hint: the method with the name nearest to the word, or all methods.
std::string method_hint(const std::string& word) {
  const std::vector<std::string> names = column_words(step_methods, &StepMethodRow::name);
  return suggestion(word, names,
                    fmt::format("one of {}, which are straight-line code", fmt::join(names, ", ")));
}

void read_iterations(const KeySyntax& key, StepSpec& step, Report& report) {
  const StepMethodRow& method = step_method_row(step.method);
  if (method.iterations == 0) {
    return report.add(Code::E626, key.key_span,
                      fmt::format("`{}` is explicit, so it has no iterations", method.name));
  }
  const cln::cl_RA& count = key.value.expression.value;
  if (count < 1 || count > max_step_iterations) {
    return report.add(Code::E626, key.value.span,
                      fmt::format("`iterations` {} is not one of 1 to {}",
                                  in_backticks(key.value.span), max_step_iterations));
  }
  step.iterations = cln::cl_I_to_uint(cln::floor1(count));
}

void read_order(const KeySyntax& key, StepSpec& step, Report& report) {
  const StepMethodRow& method = step_method_row(step.method);
  const std::vector<std::uint32_t> orders = step_orders(method.order);
  const auto found = std::ranges::find_if(orders, [&key](std::uint32_t order) {
    return key.value.expression.value == cln::cl_RA(order);
  });
  if (found == orders.end()) {
    return report.add(
        Code::E647, key.value.span,
        fmt::format("`{}` has no order {}", method.name, in_backticks(key.value.span)),
        fmt::format("it has {}", fmt::join(orders, ", ")));
  }
  if (*found != method.order) step.composed_order = *found;
}

/// Reads `projected`. E539 if the model has no constraints.
void read_projected(const Model& model, const KeySyntax& key, StepSpec& step, Report& report) {
  step.projects = key.value.boolean;
  if (!step.projects || !model.constraints.empty()) return;
  report.add(Code::E539, key.key_span,
             "`projected` needs a `[[constraint]]`, but the model has none");
}

}  // namespace

void read_step(const Model& model, const ValueSyntax& entry, OutputRequest& output,
               Report& report) {
  const KeySyntax* method = entry.find("method");
  if (method == nullptr) {
    return report.add(Code::E105, output.span,
                      fmt::format("`{}` needs a `method`: give it in a scene", output.name),
                      method_hint(""));
  }
  const auto found = std::ranges::find(step_methods, method->value.text, &StepMethodRow::name);
  if (found == step_methods.end()) {
    const std::string& word = method->value.text;
    return report.add(Code::E620, method->value.span,
                      fmt::format("`{}` has no method {}", output.name, quote_text(word)),
                      method_hint(word));
  }
  StepSpec& step = output.step.emplace(default_step(found->id));
  const KeySyntax* iterations = entry.find("iterations");
  if (iterations != nullptr) read_iterations(*iterations, step, report);
  const KeySyntax* order = entry.find("order");
  if (order != nullptr) read_order(*order, step, report);
  const KeySyntax* projected = entry.find("projected");
  const bool may_project = output_row(output.kind).options.has(OutputOption::projected);
  if (projected != nullptr && may_project) read_projected(model, *projected, step, report);
}

void check_steps(Context& context, const std::vector<OutputRequest>& outputs) {
  const Model& model = context.model;
  for (const OutputRequest& output : outputs) {
    if (!output.step) continue;
    const StepMethodRow& method = step_method_row(output.step->method);
    if (method.domain == StepDomain::any) continue;
    if (!model.constraints.empty()) {
      context.report.add({Code::E539, output.span,
                          fmt::format("`{}` does not support constraints", method.name),
                          "use `rk4` with `projected` after each step",
                          model.constraints.front().span, "constrained here"});
    } else if (!model.rotations.empty() && context.report.error_count() == 0) {
      // Only without earlier errors: after an error, rotations that the scene locks are still in
      // the model.
      context.report.add(Code::E622, output.span,
                         fmt::format("`{}` does not apply to this system: `{}` is a rotation",
                                     method.name, model.rotations.front().name),
                         "`rk4` takes any model");
    }
  }
}

}  // namespace elgen
