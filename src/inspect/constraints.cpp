// E536: an equation whose row of A = dr/dv is 0 at every sampled state. E538: Newton's method,
// begun at the start of the model, finds no pose. E537: an equation that follows from other
// equations.
//
// For E537, A is evaluated at several poses near the start that satisfy the constraints, because
// equations may be dependent only at these poses. A linear combination of rows that is 0 is a null
// vector of A^T. The equations are dependent if A^T has a null vector at every pose.
#include <fmt/format.h>

#include <algorithm>

#include "elgen/inspect.hpp"
#include "inspect/checks.hpp"
#include "inspect/null_space.hpp"
#include "inspect/readable.hpp"
#include "inspect/samples.hpp"
#include "inspect/singular_mass.hpp"
#include "model/output_units.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

using cln::cl_R;

constexpr std::size_t other_pose_count = 3;
constexpr unsigned pose_draws = 8;

/// True if a number is only rounding error, whatever its unit is.
bool is_rounding_error(const cl_R& x) { return cln::abs(x) < power_of_ten(-50); }

/// For each equation: true if its row of A is 0 at every sampled state at which A has a value.
std::vector<bool> mark_ineffective_equations(const InspectedModel& subject) {
  const std::size_t n = subject.model.velocities.size();
  std::vector<bool> marks(subject.model.constraints.size(), true);
  for (unsigned seed = 0; seed < pose_draws; ++seed) {
    const OracleValues a = oracle_values(subject.model, {.kind = OutputKind::constraint_jacobian},
                                         sample_state(subject, seed));
    for (std::size_t k = 0; a && k < a->size(); ++k) {
      if (!is_rounding_error((*a)[k])) marks[k / n] = false;
    }
  }
  return marks;
}

Diagnostics ineffective_equation_errors(const InspectedModel& subject) {
  Diagnostics errors;
  const std::vector<bool> marks = mark_ineffective_equations(subject);
  for (std::size_t k = 0; k < marks.size(); ++k) {
    const Constraint& constraint = subject.model.constraints[k];
    const auto value =
        oracle_expression_value(subject.model, constraint.value, sample_state(subject, 0));
    if (!marks[k] || !value) continue;
    const std::string hint = equation_hint(subject.model.constraints, marks, constraint);
    errors.push_back({Code::E536, constraint.equation_span,
                      fmt::format("`{}` constrains nothing: it is {} for all {}", constraint.name,
                                  is_rounding_error(*value) ? "0" : "the same",
                                  constraint.is_position ? "coordinates" : "rates"),
                      hint.empty() ? "remove it" : hint});
  }
  return errors;
}

/// True if Newton's method has come close to a pose without reaching the pose. Newton's method then
/// converges slowly, because A does not have full rank at the pose.
bool converges_slowly(const Model& model, const Assembly& at) {
  const OracleValues values =
      oracle_values(model, {.kind = OutputKind::constraint_residual}, at.state);
  const std::size_t rates = model.constraints.size();
  return values && !at.has_pose &&
         std::all_of(values->begin(), values->end() - static_cast<std::ptrdiff_t>(rates),
                     [](const cl_R& f) { return cln::abs(f) < power_of_ten(-12); });
}

/// The state at the start of the model, with random values of open functions.
State start_with_open_values(const InspectedModel& subject) {
  State state = start_state(subject.model, subject.scene);
  state.f = sample_state(subject, 0).f;
  return state;
}

Diagnostic assembly_error(const InspectedModel& subject, const std::optional<Assembly>& at) {
  const Model& model = subject.model;
  if (at && converges_slowly(model, *at)) {
    return {
        Code::E537, model.constraints.front().span,
        "near the start, the constraints hold only where A is rank-deficient, so the multipliers "
        "are not determined",
        "give another `start`, or an equation whose gradient does not vanish there"};
  }
  const std::string quotient = at ? "" : quotient_hint(model, start_with_open_values(subject));
  const std::string left = at ? residual_text(model, *at) : "undefined";
  return {Code::E538, model.constraints.front().span,
          fmt::format("no {} near the start meet the constraints: the residual is {}",
                      at && at->has_pose ? "rates" : "coordinates", left),
          quotient.empty() ? "give the coordinates a `start` near a pose that exists" : quotient};
}

/// Poses found from random states. Every second draw has the parameters of the start; the other
/// draws have random parameters. After every second draw, the distance of later states from the
/// start is halved.
std::vector<State> other_poses(const InspectedModel& subject, const State& start) {
  constexpr unsigned turns = 3;  // seeds that are multiples of 3 draw lengths up to 1
  std::vector<State> poses;
  cl_R share = 1;
  for (unsigned draw = 0; draw < pose_draws && poses.size() < other_pose_count; ++draw) {
    State state = sample_state(subject, turns * draw);
    for (std::size_t i = 0; i < state.q.size(); ++i) {
      state.q[i] = start.q[i] + (state.q[i] - start.q[i]) * share;
    }
    if (draw % 2 != 0) {
      state.parameters = start.parameters;
      share = share / 2;
    }
    if (auto pose = oracle_assembled_state(subject.model, std::move(state))) {
      poses.push_back(std::move(*pose));
    }
  }
  return poses;
}

using Combinations = std::vector<RealVector>;

/// A basis of the null space of A^T: the linear combinations of equations that vanish at a pose.
/// The last equation of each combination is in no other combination. Empty if A has no value.
Combinations zero_combinations(const Model& model, const State& pose) {
  const OracleValues a = oracle_values(model, {.kind = OutputKind::constraint_jacobian}, pose);
  if (!a) return {};
  const std::size_t n = model.velocities.size();
  const std::size_t m = model.constraints.size();
  RealVector columns(a->size());
  RealVector lengths;
  for (std::size_t k = 0; k < m; ++k) {
    cl_R largest = 0;
    for (std::size_t j = 0; j < n; ++j) largest = cln::max(largest, cln::abs((*a)[k * n + j]));
    lengths.push_back(is_rounding_error(largest) ? cl_R(1) : largest);
    for (std::size_t j = 0; j < n; ++j) columns[j * m + k] = (*a)[k * n + j] / lengths[k];
  }
  Combinations all = null_space(columns, RealVector(n, cl_R(1)));
  for (RealVector& factors : all) {
    for (std::size_t k = 0; k < m; ++k) factors[k] = factors[k] / lengths[k];
  }
  return all;
}

std::size_t last_nonzero_index(const RealVector& factors) {
  std::size_t last = factors.size() - 1;
  while (last > 0 && readable_number(factors[last]) == "0") --last;
  return last;
}

/// For a vanishing combination: the sum of other equations that equals the last equation, as
/// "2*rod - loop_x".
std::string equivalent_sum_text(const Model& model, const RealVector& factors) {
  const std::size_t last = last_nonzero_index(factors);
  std::string text;
  for (std::size_t k = 0; k < last; ++k) {
    const cl_R factor = -factors[k] / factors[last];
    const std::string size = readable_number(cln::abs(factor));
    if (size == "0") continue;
    if (!text.empty()) text += factor > 0 ? " + " : " - ";
    if (text.empty() && factor < 0) text = "-";
    text += (size == "1" ? "" : size + "*") + model.constraints[k].name;
  }
  return text.empty() ? "0" : text;
}

/// E537 for the vanishing combinations at the pose with the fewest combinations, because the other
/// poses may be dead centres. No error if a pose has no vanishing combination.
Diagnostics redundancy_errors(const Model& model, const std::vector<Combinations>& at_poses) {
  const auto fewest =
      std::ranges::min_element(at_poses, {}, [](const Combinations& all) { return all.size(); });
  Diagnostics errors;
  for (std::size_t i = 0; i < fewest->size(); ++i) {
    const Constraint& constraint = model.constraints[last_nonzero_index((*fewest)[i])];
    const std::string sum = equivalent_sum_text(model, (*fewest)[i]);
    const bool is_fixed = std::ranges::all_of(at_poses, [&](const Combinations& all) {
      return all.size() != fewest->size() || equivalent_sum_text(model, all[i]) == sum;
    });
    errors.push_back({Code::E537, constraint.span,
                      fmt::format("`{}` follows from other constraints: its row of A is {}{}",
                                  constraint.name, sum, is_fixed ? "" : " at one pose"),
                      "remove it: its multiplier is not determined"});
  }
  return errors;
}

Diagnostics redundant_equation_errors(const InspectedModel& subject, const State& start) {
  std::vector<Combinations> at_poses{zero_combinations(subject.model, start)};
  if (at_poses.front().empty()) return {};
  for (const State& pose : other_poses(subject, start)) {
    at_poses.push_back(zero_combinations(subject.model, pose));
    if (at_poses.back().empty()) return {};
  }
  return redundancy_errors(subject.model, at_poses);
}

/// The first output of the scene whose row has this SingularFault; null if there is none.
const OutputRequest* find_output_by_fault(const Scene& scene, SingularFault fault) {
  const auto found = std::ranges::find(scene.outputs, fault, [](const OutputRequest& output) {
    return output_row(output.kind).singular_fault;
  });
  return found == scene.outputs.end() ? nullptr : &*found;
}

/// E603 if the scene requests constrained inverse dynamics, but the inputs are determined at no
/// pose.
Diagnostics undetermined_input_errors(const InspectedModel& subject, const State& start) {
  const OutputRequest* const wanted =
      find_output_by_fault(subject.scene, SingularFault::redundant_inputs);
  if (wanted == nullptr) return {};
  const auto has_value = [&](const State& pose) {
    return oracle_values(subject.model, *wanted, pose).has_value();
  };
  if (has_value(start) || std::ranges::any_of(other_poses(subject, start), has_value)) return {};
  return {redundant_inputs_error(*wanted)};
}

/// E603 if the scene requests `completed`, but the columns of the dependent velocities in A have
/// full rank at no pose. The message states the largest rank.
Diagnostics undetermined_velocity_errors(const InspectedModel& subject, const State& start) {
  const OutputRequest* const wanted =
      find_output_by_fault(subject.scene, SingularFault::undetermined_rest);
  if (wanted == nullptr) return {};
  const Model& model = subject.model;
  const std::size_t n = model.velocities.size();
  const auto rank_at = [&](const State& pose) {
    RealVector columns;
    const OracleValues a = oracle_values(model, {.kind = OutputKind::constraint_jacobian}, pose);
    for (std::size_t k = 0; a && k < a->size(); ++k) {
      const auto velocity = static_cast<std::uint32_t>(k % n);
      if (std::ranges::count(wanted->independent, velocity) == 0) columns.push_back((*a)[k]);
    }
    const std::size_t size = model.constraints.size();
    return size - null_space(columns, row_scales(columns, size)).size();
  };
  std::size_t rank = rank_at(start);
  for (const State& pose : other_poses(subject, start)) rank = std::max(rank, rank_at(pose));
  if (rank == model.constraints.size()) return {};
  Diagnostic error = undetermined_velocities_error(*wanted);
  error.message += fmt::format(": the others have columns of rank {} of {} in A", rank,
                               model.constraints.size());
  return {error};
}

}  // namespace

std::string residual_text(const Model& model, const Assembly& at) {
  const OracleValues values =
      oracle_values(model, {.kind = OutputKind::constraint_residual}, at.state);
  if (!values) return "undefined";
  const std::size_t first = at.has_pose ? values->size() - model.constraints.size() : 0;
  std::string text;
  std::size_t row = 0;
  for (const Constraint& constraint : model.constraints) {
    if (!at.has_pose && !constraint.is_position) continue;
    const std::string unit = unit_text_of_entry(
        model, {OutputKind::constraint_residual, at.has_pose ? "rate" : "position", row});
    const cl_R left = cln::abs((*values)[first + row++]);
    text += fmt::format("{}{:.3g}{} of `{}`", text.empty() ? "" : ", ",
                        is_rounding_error(left) ? 0.0 : cln::double_approx(left),
                        unit.empty() || unit == "1" ? "" : " " + unit, constraint.name);
  }
  return text;
}

Diagnostics inspect_constraints(const InspectedModel& subject) {
  const Model& model = subject.model;
  if (model.constraints.empty() || model.velocities.size() > most_coordinates_sampled) return {};
  Diagnostics errors = ineffective_equation_errors(subject);
  if (!errors.empty()) return errors;
  const std::optional<Assembly> start = oracle_assembly(model, start_with_open_values(subject));
  if (!start || !start->has_rates) return {assembly_error(subject, start)};
  errors = redundant_equation_errors(subject, start->state);
  if (errors.empty()) errors = undetermined_input_errors(subject, start->state);
  return errors.empty() ? undetermined_velocity_errors(subject, start->state) : errors;
}

}  // namespace elgen
