// The rows, each with what makes its steps, their names, and the numbers of a run.
#include "simulate/steps/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "elgen/wording.hpp"

namespace elgen {
namespace {

constexpr double default_tolerance = 1e-9;

Diagnostic impossible(std::string message, std::string hint = {}) {
  return {Code::E621, {}, std::move(message), std::move(hint)};
}

}  // namespace

std::span<const MethodRow> method_table() {
  static constexpr std::array table{
      MethodRow{"rk4", StepKind::fixed, {}, &make_rk4},
      MethodRow{"dopri5", StepKind::adapted, {}, &make_dopri5},
      MethodRow{"verlet", StepKind::fixed, StepMethod::verlet, &make_step_program},
      MethodRow{"midpoint", StepKind::fixed, StepMethod::midpoint, &make_step_program}};
  return table;
}

const MethodRow& reference_method() {
  static constexpr MethodRow row{"fehlberg78", StepKind::adapted, {}, &make_fehlberg78};
  return row;
}

Result<MethodRow> find_method(const SimulationOptions& options) {
  if (options.is_reference) return reference_method();
  const std::string& name = options.method;
  const std::span<const MethodRow> table = method_table();
  const auto found = std::ranges::find(table, name, &MethodRow::name);
  if (found != table.end()) return *found;
  std::vector<std::string> names;
  for (const MethodRow& row : table) names.emplace_back(row.name);
  const std::string hint = suggestion(name, names);
  return Diagnostic{Code::E620,
                    {},
                    fmt::format("unknown method `{}`", name),
                    hint.empty() ? fmt::format("one of {}", fmt::join(names, ", ")) : hint};
}

Result<StepRule> step_rule(const MethodRow& method, const SimulationOptions& options) {
  struct Given {
    const char* option;
    std::optional<double> value;
  };
  for (const auto& [option, value] :
       std::array{Given{"time", options.time}, Given{"step", options.step},
                  Given{"tolerance", options.tolerance}, Given{"every", options.every},
                  Given{"hold", options.hold}}) {
    if (value && !(*value > 0 && std::isfinite(*value))) {
      return impossible(fmt::format("`--{} {}` is not a positive number", option, *value));
    }
  }
  if (!std::isfinite(options.from)) {
    return impossible(fmt::format("`--from {}` is not a number", options.from));
  }
  if (options.step && options.tolerance) {
    return impossible("`--step` and `--tolerance` are given, but one follows from the other");
  }
  if (options.every && *options.every > options.time) {
    return impossible(fmt::format("`--every {}` is longer than the whole run, `--time {}`",
                                  *options.every, options.time));
  }
  if (method.step == StepKind::fixed && options.tolerance) {
    return impossible(fmt::format("`{}` does not choose its steps by a tolerance", method.name),
                      "give it `--step`, or take `dopri5`");
  }
  if (method.step == StepKind::fixed && !options.step) {
    return impossible(fmt::format("`{}` needs a step", method.name), "give it `--step`");
  }
  return StepRule{options.step, options.tolerance.value_or(default_tolerance)};
}

Diagnostics refuse_run(const SimulationOptions& options) {
  const Result<MethodRow> method = find_method(options);
  return method ? step_rule(*method, options).diagnostics : method.diagnostics;
}

std::optional<StepMethod> step_of_run(const SimulationOptions& options) {
  const Result<MethodRow> method = find_method(options);
  return method ? method->program : std::nullopt;
}

}  // namespace elgen
