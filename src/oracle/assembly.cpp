// Assembly: Newton's method from any state to a state that meets the constraints.
//
//     q + N s x,   M x = A^T y,   A x = -f,   s = 1, 1/2, 1/4, ... until the errors shrink
//
// Here dq/dt = N v, and A is the Jacobian of the constraints f. The error of an equation is f
// divided by the length of its row of A: a distance in coordinates. Rows that depend linearly on
// earlier rows are dropped, so redundant but consistent equations can be solved. Every step is
// rounded to floats, since exact rationals would need twice as many digits after each step.
#include <numeric>
#include <utility>

#include "elgen/oracle.hpp"
#include "numbers/exact_number.hpp"
#include "oracle/constraints.hpp"
#include "oracle/real_functions.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_R;

constexpr unsigned most_newton_steps = 60;
constexpr unsigned most_halvings = 10;

/// The tolerance of independent_rows(): a row is dependent if its component orthogonal to earlier
/// rows has at most this share of the length of the row.
const cl_R& dependence_tolerance() {
  static const cl_R share = power_of_ten(-12);
  return share;
}

/// The tolerance of is_satisfied(), relative to 1 + the largest coordinate or rate.
const cl_R& residual_tolerance() {
  static const cl_R share = power_of_ten(-60);
  return share;
}

cl_R vector_norm(const Direction& row) {
  const cl_R square = std::inner_product(row.begin(), row.end(), row.begin(), cl_R(0));
  return cln::zerop(square) ? cl_R(0) : real_power(square, cln::cl_RA(1) / 2);
}

/// The rows that are linearly independent of earlier rows, by the Gram-Schmidt method. The entries
/// of a row at `fixed` velocities count as 0.
LinearisedConstraints independent_rows(const LinearisedConstraints& all,
                                       const std::vector<bool>& fixed) {
  LinearisedConstraints kept;
  std::vector<Direction> basis;
  for (std::size_t k = 0; k < all.rows.size(); ++k) {
    Direction rest = all.rows[k];
    for (std::size_t j = 0; j < fixed.size(); ++j) {
      if (fixed[j]) rest[j] = 0;
    }
    for (const Direction& unit : basis) {
      const cl_R share = std::inner_product(rest.begin(), rest.end(), unit.begin(), cl_R(0));
      for (std::size_t j = 0; j < rest.size(); ++j) rest[j] = rest[j] - share * unit[j];
    }
    const cl_R length = vector_norm(rest);
    if (length <= vector_norm(all.rows[k]) * dependence_tolerance()) continue;
    for (cl_R& entry : rest) entry = entry / length;
    basis.push_back(std::move(rest));
    kept.rows.push_back(all.rows[k]);
    kept.right_side.push_back(all.right_side[k]);
  }
  return kept;
}

/// The Newton step x (head of file); empty if the linear equations for x have no solution.
std::optional<Direction> newton_step(const Model& model, const State& state,
                                     const LinearisedConstraints& shortage,
                                     const std::vector<bool>& fixed) {
  std::optional<Direction> step = attempt([&] {
    return least_energy_correction(model, state, independent_rows(shortage, fixed), fixed);
  });
  if (!step) return std::nullopt;
  for (cl_R& entry : *step) {
    if (!cln::zerop(entry)) entry = as_float(entry);
  }
  return step;
}

/// The length of each row; 1 for a zero row.
std::vector<cl_R> row_lengths(const LinearisedConstraints& shortage) {
  std::vector<cl_R> lengths;
  for (const Direction& row : shortage.rows) {
    const cl_R length = vector_norm(row);
    lengths.push_back(cln::zerop(length) ? cl_R(1) : length);
  }
  return lengths;
}

/// True if every error is at most residual_tolerance() * (1 + max |at_i|). `at` holds the
/// coordinates or the rates that Newton's method corrects.
bool is_satisfied(const LinearisedConstraints& shortage, const std::vector<cl_R>& at) {
  const std::vector<cl_R> lengths = row_lengths(shortage);
  const cl_R share = residual_tolerance() * (1 + max_magnitude(at));
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    if (cln::abs(shortage.right_side[k]) > share * lengths[k]) return false;
  }
  return true;
}

/// The sum of (left_k / lengths_k)^2 over all entries of `lengths`. `left` may have further
/// entries, which are ignored.
cl_R squared_error(const std::vector<cl_R>& left, const std::vector<cl_R>& lengths) {
  cl_R sum = 0;
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    const cl_R error = left[k] / lengths[k];
    sum = sum + error * error;
  }
  return sum;
}

/// The state after the first step s = 1, 1/2, ... that shrinks the errors; empty if all s fail.
std::optional<State> damped_newton_step(const Model& model, const State& state,
                                        const LinearisedConstraints& shortage,
                                        const std::vector<bool>& fixed) {
  std::optional<Direction> step = newton_step(model, state, shortage, fixed);
  const std::vector<cl_R> lengths = row_lengths(shortage);
  const cl_R now = squared_error(shortage.right_side, lengths);
  for (unsigned halving = 0; step && halving <= most_halvings; ++halving) {
    State next = displaced_state(model, state, *step);
    const auto error =
        attempt([&] { return squared_error(constraint_residual(model, next), lengths); });
    if (error && *error < now) return next;
    for (cl_R& entry : *step) entry = entry / 2;
  }
  return std::nullopt;
}

/// Corrects the rates by at most one Newton step, because the constraints on rates are affine in v.
/// Sets `has_rates` of `at` to true if the rates then satisfy the constraints, else to false.
void assemble_rates(const Model& model, Assembly& at, const std::vector<bool>& fixed) {
  const LinearisedConstraints shortage = linearise_rates(model, at.state);
  if (!is_satisfied(shortage, at.state.v)) {
    const std::optional<Direction> step = newton_step(model, at.state, shortage, fixed);
    if (!step) return;
    for (std::size_t i = 0; i < step->size(); ++i) at.state.v[i] = at.state.v[i] + (*step)[i];
  }
  at.has_rates = is_satisfied(linearise_rates(model, at.state), at.state.v);
}

Assembly assemble(const Model& model, State state, const FixedVariables& fixed) {
  Assembly at{std::move(state)};
  at.state.q = normalize_quaternions(model, std::move(at.state.q));
  for (unsigned step = 0; step <= most_newton_steps; ++step) {
    const LinearisedConstraints shortage = linearise_positions(model, at.state);
    at.has_pose = is_satisfied(shortage, at.state.q);
    if (at.has_pose) break;
    std::optional<State> next = damped_newton_step(model, at.state, shortage, fixed.positions);
    if (!next) return at;
    at.state = std::move(*next);
  }
  if (at.has_pose) assemble_rates(model, at, fixed.rates);
  return at;
}

}  // namespace
}  // namespace elgen::oracle

namespace elgen {

std::optional<Assembly> oracle_assembly(const Model& model, const State& state,
                                        const FixedVariables& kept) {
  return oracle::attempt_with_enough_digits([&] { return oracle::assemble(model, state, kept); });
}

std::optional<State> oracle_assembled_state(const Model& model, State state) {
  if (model.constraints.empty()) return state;
  std::optional<Assembly> at = oracle_assembly(model, state);
  return at && at->has_rates ? std::optional(std::move(at->state)) : std::nullopt;
}

}  // namespace elgen
