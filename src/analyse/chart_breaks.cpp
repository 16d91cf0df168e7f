// Compares the pivots of M at a state with the pivots of M after a shift of all coordinates.
#include "analyse/chart_breaks.hpp"

#include <algorithm>
#include <utility>

#include "analyse/formulas.hpp"
#include "analyse/newton_refinement.hpp"
#include "analyse/stability.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

using cln::cl_R;

/// Shifts one coordinate by 1/8, which is far from multiples of a quarter turn.
State shifted_state(State state, std::size_t coordinate) {
  state.q[coordinate] = state.q[coordinate] + cln::cl_RA(1) / 8;
  return state;
}

/// True if a pivot of M is 0 at the state, but not after a shift of all coordinates. A root has 58
/// digits, so a pivot that vanishes is computed as less than 1e-50 of its shifted value.
bool is_chart_broken(const RestProgram& rest, const State& state) {
  State moved = state;
  for (std::size_t i = 0; i < moved.q.size(); ++i) moved = shifted_state(std::move(moved), i);
  const std::vector<cl_R> reference = mass_matrix_at(rest, moved);
  return is_positive_definite(reference) &&
         !is_positive_definite(mass_matrix_at(rest, state), {}, reference);
}

}  // namespace

std::vector<cl_R> values_or_zero(const std::vector<Real>& values) {
  std::vector<cl_R> result;
  for (const Real& value : values) {
    result.push_back(value.is_defined() ? cl_R(value.value()) : cl_R(0));
  }
  return result;
}

std::vector<cl_R> mass_matrix_at(const RestProgram& rest, const State& state) {
  return values_or_zero(
      evaluate(rest.program, rest.program.functions[1], arguments_at<Real>(state)));
}

bool find_chart_breaks(const RestProgram& rest, const RestPoint& point,
                       std::vector<ChartSingularity>& breaks) {
  // A coordinate in no equation has its start value, at which the chart may break by chance.
  State elsewhere = point.state;
  for (std::uint32_t i = 0; i < point.coordinates.size(); ++i) {
    if (point.coordinates[i].is_arbitrary) elsewhere = shifted_state(std::move(elsewhere), i);
  }
  if (!is_chart_broken(rest, elsewhere)) return false;
  std::vector<std::uint32_t> held;
  std::vector<std::uint32_t> causes;
  for (std::uint32_t i = 0; i < point.coordinates.size(); ++i) {
    if (point.coordinates[i].is_arbitrary) continue;
    held.push_back(i);
    if (!is_chart_broken(rest, shifted_state(elsewhere, i))) causes.push_back(i);
  }
  for (const std::uint32_t i : causes.empty() ? held : causes) {
    const bool is_known = std::ranges::any_of(breaks, [&](const ChartSingularity& known) {
      return known.coordinate == i && is_near(Real(known.value.value), Real(point.state.q[i]));
    });
    if (!is_known) breaks.push_back({i, point.coordinates[i]});
  }
  return true;
}

}  // namespace elgen
