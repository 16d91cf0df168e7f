// The table of methods, and the checks of a run's options.
#include "run/steps/methods.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "elgen/wording.hpp"

namespace elgen {
namespace {

/// The shortest adapted step, as a fraction of the run: 1e12 steps would take days. The tolerance
/// requires shorter steps only near a state without an acceleration.
constexpr double shortest_share = 1e-12;

Diagnostic impossible(std::string message, std::string hint = {}) {
  return {Code::E621, {}, std::move(message), std::move(hint)};
}

/// The row of a method that runs the output `step`.
constexpr MethodRow row_by_program(StepMethod method) {
  const StepMethodRow& row = step_row(method);
  return {row.name, row.order, StepKind::fixed, method, &make_step_program};
}

}  // namespace

std::span<const MethodRow> method_table() {
  static constexpr std::array table{MethodRow{"rk4", 4, StepKind::fixed, {}, &make_rk4},
                                    MethodRow{"dopri5", 5, StepKind::adapted, {}, &make_dopri5},
                                    row_by_program(StepMethod::verlet),
                                    row_by_program(StepMethod::midpoint)};
  return table;
}

Result<MethodRow> find_method(const SimulationOptions& options) {
  const std::string& name = options.method;
  const std::span<const MethodRow> table = method_table();
  const auto found = std::ranges::find(table, name, &MethodRow::name);
  if (found != table.end()) {
    const std::vector<std::uint32_t> orders = step_orders(found->order);
    const bool is_known =
        !options.order || std::ranges::find(orders, *options.order) != orders.end();
    if (is_known) return *found;
    return Diagnostic{Code::E647,
                      {},
                      fmt::format("`{}` has no order {}", name, *options.order),
                      fmt::format("it has {}", fmt::join(orders, ", "))};
  }
  const std::vector<std::string> names = column_words(table, &MethodRow::name);
  return Diagnostic{Code::E620,
                    {},
                    fmt::format("unknown method `{}`", name),
                    suggestion(name, names, fmt::format("one of {}", fmt::join(names, ", ")))};
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
    return impossible("give `--step` or `--tolerance`, not both");
  }
  if (options.every && *options.every > options.time) {
    return impossible(fmt::format("`--every {}` is longer than the whole run, `--time {}`",
                                  *options.every, options.time));
  }
  if (method.step == StepKind::fixed && options.tolerance) {
    return impossible(fmt::format("`{}` does not choose its steps by a tolerance", method.name),
                      "give `--step`, or use `dopri5`");
  }
  if (method.step == StepKind::fixed && !options.step) {
    return impossible(fmt::format("`{}` needs a step", method.name), "give it `--step`");
  }
  if (options.through_singular && !options.step) {
    return impossible("`--through singular` needs fixed steps", "give it `--step`");
  }
  return StepRule{options.step, options.tolerance.value_or(default_tolerance),
                  shortest_share * options.time};
}

Diagnostics check_run_options(const SimulationOptions& options) {
  const Result<MethodRow> method = find_method(options);
  return method ? step_rule(*method, options).diagnostics : method.diagnostics;
}

std::optional<StepSpec> step_of_run(const SimulationOptions& options) {
  const Result<MethodRow> method = find_method(options);
  if (!method || !method->program) return std::nullopt;
  const std::uint32_t order = options.order.value_or(method->order);
  return default_step(*method->program, order == method->order ? 0 : order);
}

}  // namespace elgen
