// What methods need is read off the program: what an output does not depend on it does not read.
#include "simulate/method_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "elgen/wording.hpp"
#include "evaluate/subject.hpp"

namespace elgen {
namespace {

constexpr double default_tolerance = 1e-9;

Diagnostic impossible(std::string message, std::string hint = {}) {
  return {Code::E621, {}, std::move(message), std::move(hint)};
}

/// "theta", "dot(x)" or "t": the first leaf of one of these kinds that the output reads; "" where
/// it reads none.
std::string leaf_read(const Program& program, OutputKind kind,
                      std::initializer_list<Opcode> kinds) {
  const Function* const function = find_function(program, kind);
  if (function == nullptr) return {};
  for (const Instruction& instruction : function->instructions) {
    if (std::ranges::find(kinds, instruction.opcode) != kinds.end()) {
      return leaf_text(program.leaves, instruction.opcode, instruction.a);
    }
  }
  return {};
}

/// Whether p is more than M v, for an M that is constant.
bool has_linear_terms(const CheckedModel& checked, const Program& program) {
  constexpr OutputKind momentum = OutputKind::momentum;
  if (!leaf_read(program, momentum, {Opcode::coordinate, Opcode::time}).empty()) return true;
  const State resting = nominal_state(checked.model, checked.scene);
  const auto at_rest =
      evaluate(program, *find_function(program, momentum), arguments_at<double>(resting));
  return std::ranges::any_of(at_rest, [](double p) { return p != 0; });
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

/// What keeps kick, drift, kick from being symplectic; "" where nothing does.
std::string not_separable(const CheckedModel& checked, const Program& program,
                          const SimulationOptions& options) {
  const std::string of_mass = leaf_read(program, OutputKind::mass_matrix,
                                        {Opcode::coordinate, Opcode::time, Opcode::velocity});
  if (!of_mass.empty()) return fmt::format("M depends on `{}`", of_mass);
  if (has_linear_terms(checked, program)) return "L has terms linear in the rates";
  const std::string of_bias = leaf_read(program, OutputKind::bias, {Opcode::velocity});
  if (!of_bias.empty()) return fmt::format("a force depends on `{}`", of_bias);
  const Input* const input = damping_input(checked, options);
  return input == nullptr ? "" : fmt::format("the law of `{}` depends on rates", input->name);
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
  const std::string reason = not_separable(checked, program, options);
  if (reason.empty()) return {};
  return {refused(method, reason, "`midpoint` is symplectic there too")};
}

}  // namespace elgen
