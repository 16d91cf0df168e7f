// Which methods there are for a system; what is separable is integrate's affair.
#include "simulate/method_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "elgen/integrate.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

constexpr double default_tolerance = 1e-9;

Diagnostic impossible(std::string message, std::string hint = {}) {
  return {Code::E621, {}, std::move(message), std::move(hint)};
}

/// The first input whose law depends on rates all the time.
const Input* damping_input(const CheckedModel& checked, const SimulationOptions& options) {
  if (options.hold) return nullptr;
  const Model& model = checked.model;
  const auto found = std::ranges::find_if(model.inputs, [&model](const Input& input) {
    return input.law && StateFunction(model, *input.law, {}).depends_on_rates();
  });
  return found == model.inputs.end() ? nullptr : &*found;
}

/// What keeps kick, drift, kick from being symplectic here; "" where nothing does.
std::string inseparable_run(const CheckedModel& checked, const Program& program,
                            const SimulationOptions& options) {
  const std::string reason = not_separable(checked, program);
  const Input* const input = reason.empty() ? damping_input(checked, options) : nullptr;
  return input == nullptr ? reason : fmt::format("the law of `{}` depends on rates", input->name);
}

Diagnostic refused(const MethodRow& method, const std::string& reason, const char* hint) {
  return {
      Code::E622, {}, fmt::format("`{}` is not for this system: {}", method.name, reason), hint};
}

}  // namespace

Result<MethodRow> find_method(const std::string& name) {
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
                      "give it `--step`, or take `dopri5` or `fehlberg78`");
  }
  if (method.step == StepKind::fixed && !options.step) {
    return impossible(fmt::format("`{}` needs a step", method.name), "give it `--step`");
  }
  return StepRule{options.step, options.tolerance.value_or(default_tolerance)};
}

Diagnostics refuse_run(const SimulationOptions& options) {
  const Result<MethodRow> method = find_method(options.method);
  return method ? step_rule(*method, options).diagnostics : method.diagnostics;
}

Diagnostics refuse_method(const MethodRow& method, const CheckedModel& checked,
                          const Program& program, const SimulationOptions& options) {
  if (method.domain == MethodDomain::any) return {};
  if (const auto& rotations = checked.model.rotations; !rotations.empty()) {
    return {refused(method, fmt::format("`{}` is a rotation", rotations.front().name),
                    "`rk4`, `dopri5` and `fehlberg78` take rotations")};
  }
  if (method.domain == MethodDomain::unturned) return {};
  const std::string reason = inseparable_run(checked, program, options);
  if (reason.empty()) return {};
  return {refused(method, reason, "`midpoint` is symplectic there too")};
}

}  // namespace elgen
