// Newton's method changes quaternions along their tangents and scales them to length 1.
#include "analyse/newton_refinement.hpp"

#include <algorithm>

#include "elgen/oracle.hpp"
#include "model/requests.hpp"
#include "numbers/dual.hpp"
#include "numbers/echelon.hpp"
#include "numbers/exact_number.hpp"
#include "program/evaluate/subject.hpp"
#include "sample/states.hpp"

namespace elgen {
namespace {

/// The column of N(q) for `velocity`: dq/dt if this velocity is 1 and all others are 0.
std::vector<Real> unit_velocity_rates(const Model& model, const Arguments<Real>& at,
                                      std::uint32_t velocity) {
  std::vector<Real> rates(at.q.size());
  const Velocity& moved = model.velocities[velocity];
  if (!moved.rotation) {
    rates[moved.coordinate] = Real(1);
    return rates;
  }
  State state = map_leaves([](const Real& x) -> cln::cl_R { return x.value(); }, at);
  std::ranges::fill(state.v, cln::cl_R(0));
  state.v[velocity] = 1;
  const OracleValues values =
      oracle_values(model, make_request(model, OutputKind::coordinate_rates, 0), state);
  for (std::size_t i = 0; values && i < rates.size(); ++i) rates[i] = Real((*values)[i]);
  return rates;
}

/// The derivatives of the entries of a function along `columns` directions, row-major.
/// point(k, direction) sets the k-th direction; all leaves of `direction` are 0 before the call.
template <class Point>
std::vector<Real> directional_slopes(const Program& program, const Function& function,
                                     const Arguments<Real>& at, std::size_t columns,
                                     const Point& point) {
  std::vector<Real> slopes(entry_count(function) * columns);
  for (std::size_t k = 0; k < columns; ++k) {
    Arguments<Real> direction = map_leaves([](const Real&) { return Real(); }, at);
    point(k, direction);
    const auto entries = evaluate(program, function, dual_leaves(at, direction));
    for (std::size_t i = 0; i < entries.size(); ++i) slopes[i * columns + k] = entries[i].slope;
  }
  return slopes;
}

constexpr int most_steps = 200;

}  // namespace

std::vector<Real> position_slopes(const Model& model, const Program& program,
                                  const Function& function, const Arguments<Real>& at,
                                  const std::vector<std::uint32_t>& velocities) {
  return directional_slopes(program, function, at, velocities.size(),
                            [&](std::size_t k, Arguments<Real>& direction) {
                              direction.q = unit_velocity_rates(model, at, velocities[k]);
                            });
}

std::vector<Real> velocity_slopes(const Program& program, OutputKind kind,
                                  const Arguments<Real>& at) {
  return directional_slopes(
      program, *find_function(program, kind), at, at.v.size(),
      [](std::size_t k, Arguments<Real>& direction) { direction.v[k] = Real(1); });
}

std::optional<Arguments<Real>> newton_solution(const Model& model, const Program& program,
                                               const Function& function, Arguments<Real> start,
                                               const std::vector<std::uint32_t>& along) {
  static const Real smallest_step(power_of_ten(-58));
  if (entry_count(function) != along.size()) return std::nullopt;
  for (int i = 0; i < most_steps; ++i) {
    std::vector<Real> values = evaluate(program, function, start);
    if (std::ranges::all_of(values, FieldOperations<Real>::is_zero)) return start;
    const auto step = solve_linear(position_slopes(model, program, function, start, along), values);
    if (!step) return std::nullopt;
    Real longest;
    Real largest(1);
    for (std::size_t k = 0; k < along.size(); ++k) {
      const std::vector<Real> rates = unit_velocity_rates(model, start, along[k]);
      for (std::size_t c = 0; c < rates.size(); ++c)
        start.q[c] = start.q[c] - rates[c] * (*step)[k];
      longest = max(longest, abs((*step)[k]));
    }
    normalize_quaternions(model, start);
    for (const Real& q : start.q) largest = max(largest, abs(q));
    if (!longest.is_defined() || !largest.is_defined()) return std::nullopt;
    if (!(longest > largest * smallest_step)) return start;
  }
  return std::nullopt;
}

}  // namespace elgen
