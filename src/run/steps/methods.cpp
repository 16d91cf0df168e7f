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
constexpr double min_step_fraction = 1e-12;

Diagnostic option_error(std::string message, std::string hint = {}) {
  return {Code::E621, {}, std::move(message), std::move(hint)};
}

/// The row of a method that runs the output `step`.
constexpr MethodRow step_program_row(StepMethod method) {
  const StepMethodRow& row = step_method_row(method);
  return {row.name, row.order, StepKind::fixed, method, &make_step_program};
}

}  // namespace

std::span<const MethodRow> method_table() {
  static constexpr std::array table{MethodRow{"rk4", 4, StepKind::fixed, {}, &make_rk4},
                                    MethodRow{"dopri5", 5, StepKind::adaptive, {}, &make_dopri5},
                                    step_program_row(StepMethod::verlet),
                                    step_program_row(StepMethod::midpoint)};
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
       std::array{Given{"time", options.duration}, Given{"step", options.step},
                  Given{"tolerance", options.tolerance}, Given{"every", options.row_interval},
                  Given{"hold", options.input_hold_time}}) {
    if (value && !(*value > 0 && std::isfinite(*value))) {
      return option_error(fmt::format("`--{} {}` is not a positive number", option, *value));
    }
  }
  if (!std::isfinite(options.from)) {
    return option_error(fmt::format("`--from {}` is not a number", options.from));
  }
  if (options.step && options.tolerance) {
    return option_error("give `--step` or `--tolerance`, not both");
  }
  if (options.row_interval && *options.row_interval > options.duration) {
    return option_error(fmt::format("`--every {}` is longer than the whole run, `--time {}`",
                                    *options.row_interval, options.duration));
  }
  if (method.step_kind == StepKind::fixed && options.tolerance) {
    return option_error(fmt::format("`{}` does not choose its steps by a tolerance", method.name),
                        "give `--step`, or use `dopri5`");
  }
  if (method.step_kind == StepKind::fixed && !options.step) {
    return option_error(fmt::format("`{}` needs a step", method.name), "give it `--step`");
  }
  if (options.continues_at_singularity && !options.step) {
    return option_error("`--through singular` needs fixed steps", "give it `--step`");
  }
  return StepRule{options.step, options.tolerance.value_or(default_tolerance),
                  min_step_fraction * options.duration};
}

Diagnostics check_run_options(const SimulationOptions& options) {
  const Result<MethodRow> method = find_method(options);
  return method ? step_rule(*method, options).diagnostics : method.diagnostics;
}

std::optional<StepSpec> step_for_run(const SimulationOptions& options) {
  const Result<MethodRow> method = find_method(options);
  if (!method || !method->step_method) return std::nullopt;
  const std::uint32_t order = options.order.value_or(method->order);
  return default_step(*method->step_method, order == method->order ? 0 : order);
}

}  // namespace elgen
