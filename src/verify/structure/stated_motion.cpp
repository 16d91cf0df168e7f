// Ranks are found at states of the motion, in 60 digits.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "elgen/references.hpp"
#include "inspect/null_space.hpp"
#include "numbers/exact_number.hpp"
#include "sample/states.hpp"
#include "verify/structure/stated.hpp"

namespace elgen {
namespace {

using cln::cl_R;

/// An equation contains accelerations at all states or at none, except at kinks, so few states
/// suffice.
constexpr std::size_t states_of_rank = 8;

/// Expected equations and their unknowns: all accelerations, then the multipliers in the equations.
struct StatedSystem {
  const Model& model;
  std::vector<ExpressionId> equations = {};
  std::vector<std::uint32_t> multipliers = {};

  [[nodiscard]] std::size_t accelerations() const { return model.velocities.size(); }
  [[nodiscard]] std::size_t unknowns() const { return accelerations() + multipliers.size(); }
  [[nodiscard]] cl_R& unknown(State& state, std::size_t i) const {
    return i < accelerations() ? state.a[i] : state.multipliers[multipliers[i - accelerations()]];
  }
  [[nodiscard]] std::vector<cl_R> values(State state) const {
    std::vector<cl_R> all;
    for (std::size_t i = 0; i < unknowns(); ++i) all.push_back(unknown(state, i));
    return all;
  }
};

StatedSystem stated_system(const Model& model, const Expectation& equations) {
  std::set<std::uint32_t> multipliers;
  for (const ExpressionId id : reachable_expressions(model, equations.entries)) {
    const Expression& e = model.expressions[id];
    if (is_leaf(e, Opcode::multiplier)) multipliers.insert(e.index);
  }
  return {model, equations.entries, {multipliers.begin(), multipliers.end()}};
}

/// motion_at(), for the first states_of_rank of `states` at which the motion exists.
std::vector<State> first_motions(const Model& model, const std::vector<State>& states) {
  std::vector<State> motions;
  for (std::size_t i = 0; i < states.size() && motions.size() < states_of_rank; ++i) {
    if (auto motion = motion_at(model, states[i])) motions.push_back(*std::move(motion));
  }
  return motions;
}

/// The rows d(left - right)/d(unknowns) of all equations, then the rows of A; empty if an equation
/// is undefined.
std::vector<cl_R> unknown_slopes(const StatedSystem& system, const State& motion) {
  std::vector<cl_R> slopes;
  State direction = map_leaves([](const cl_R&) { return cl_R(0); }, motion);
  for (const ExpressionId equation : system.equations) {
    for (std::size_t i = 0; i < system.unknowns(); ++i) {
      system.unknown(direction, i) = 1;
      const std::optional<cl_R> slope =
          oracle_directional_derivative(system.model, equation, motion, direction);
      if (!slope) return {};
      slopes.push_back(*slope);
      system.unknown(direction, i) = 0;
    }
  }
  if (system.model.constraints.empty()) return slopes;
  const OracleValues rows =
      oracle_values(system.model, {.kind = OutputKind::constraint_jacobian}, motion);
  for (std::size_t k = 0; rows && k < rows->size(); ++k) {
    slopes.push_back((*rows)[k]);
    const bool ends_row = (k + 1) % system.accelerations() == 0;
    if (ends_row) slopes.resize(slopes.size() + system.multipliers.size(), cl_R(0));
  }
  return slopes;
}

std::size_t rank_of(const std::vector<cl_R>& matrix, std::size_t columns) {
  return columns - null_space(matrix, row_scales(matrix, columns)).size();
}

/// The number of accelerations that the rows of unknown_slopes() determine.
std::size_t acceleration_rank(const StatedSystem& system, std::vector<cl_R> slopes) {
  const std::size_t columns = system.unknowns();
  const std::size_t rank = rank_of(slopes, columns);
  if (system.multipliers.empty()) return rank;
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    if (k % columns < system.accelerations()) slopes[k] = 0;
  }
  return rank - rank_of(slopes, columns);
}

/// The oracle has 60 digits; cancellation may cost 15.
const cl_R& equation_tolerance() {
  static const cl_R share = power_of_ten(-45);
  return share;
}

bool satisfies_all_equations(const StatedSystem& system, const State& motion,
                             const std::vector<cl_R>& slopes) {
  const std::size_t n = system.unknowns();
  const cl_R largest = max_magnitude(system.values(motion));
  for (std::size_t k = 0; k < system.equations.size(); ++k) {
    const auto row = slopes.begin() + static_cast<std::ptrdiff_t>(k * n);
    const cl_R scale = max_magnitude({row, row + static_cast<std::ptrdiff_t>(n)}) * largest;
    const auto value = oracle_expression_value(system.model, system.equations[k], motion);
    if (!value || cln::abs(*value) > scale * equation_tolerance()) return false;
  }
  return true;
}

/// Finds another acceleration that satisfies all equations, such as the other root of a square.
/// The search runs along lines on which all equations except one are constant to first order. On a
/// line, left - right of the remaining equation is f(s), with f(0) = 0. One candidate is the other
/// zero of a parabola, s = f'/(f' - f(1)). The other candidate reverses the sign of
/// d(left - right)/da . a, for an equation that is even in a. None if the motion itself does not
/// satisfy the equations: equations with a wrong sign may determine another acceleration.
std::optional<State> find_other_motion(const StatedSystem& system, const State& motion,
                                       const std::vector<cl_R>& slopes) {
  if (!satisfies_all_equations(system, motion, slopes)) return std::nullopt;
  const std::size_t n = system.unknowns();
  for (std::size_t k = 0; k < system.equations.size(); ++k) {
    std::vector<cl_R> others = slopes;
    const auto row = others.begin() + static_cast<std::ptrdiff_t>(k * n);
    const std::vector<cl_R> own(row, row + static_cast<std::ptrdiff_t>(n));
    std::fill_n(row, n, cl_R(0));
    const auto slope_along = [&own](const std::vector<cl_R>& x) {
      return std::inner_product(own.begin(), own.end(), x.begin(), cl_R(0));
    };
    for (const std::vector<cl_R>& along : null_space(others, row_scales(others, n))) {
      const auto moved = [&](const cl_R& s) {
        State state = motion;
        for (std::size_t i = 0; i < n; ++i)
          system.unknown(state, i) = system.unknown(state, i) + s * along[i];
        return state;
      };
      if (moved(1).a == motion.a) continue;  // only multipliers change
      const cl_R slope = slope_along(along);
      const auto one = oracle_expression_value(system.model, system.equations[k], moved(1));
      std::vector<cl_R> zeros{-2 * slope_along(system.values(motion)) / slope};
      const bool bends = one && cln::abs(*one - slope) > equation_tolerance() * cln::abs(slope);
      if (bends) zeros.push_back(slope / (slope - *one));
      for (const cl_R& s : zeros) {
        const bool is_other = cln::abs(s) > equation_tolerance() * max_magnitude(motion.a);
        if (is_other && satisfies_all_equations(system, moved(s), slopes)) return moved(s);
      }
    }
  }
  return std::nullopt;
}

/// The text of a second solution: "a = (1, -2) meets all equations, too".
std::string second_solution_text(const State& motion) {
  std::vector<std::string> values;
  for (const cl_R& a : motion.a) values.push_back(short_number_text(a));
  return fmt::format("a = ({}) meets all equations, too", fmt::join(values, ", "));
}

/// Counts the independent equations of an incomplete set. E540 if there are none.
void count_equations(ExpectationReport& report, CertificateRow& row, const StatedSystem& system,
                     const Span& span, const std::vector<State>& motions) {
  row.verdict = Verdict::skipped;
  row.worst_value = "no state of the motion was found";
  if (motions.empty()) return;
  const std::size_t constraints = system.model.constraints.size();
  std::size_t rank = constraints;
  for (const State& motion : motions) {
    const std::vector<cl_R> slopes = unknown_slopes(system, motion);
    if (!slopes.empty()) rank = std::max(rank, rank_of(slopes, system.unknowns()));
  }
  row.formula = "rank of d(left - right)/da and A, minus the rank of A";
  row.stated = StatedEquations{rank - constraints, system.unknowns() - constraints};
  row.worst_value = fmt::format("{} of {} stated", row.stated->stated, row.stated->needed);
  row.verdict = rank > constraints ? Verdict::noted : Verdict::fails;
  if (rank > constraints) return;
  report.diagnostics.push_back(
      {Code::E540, span,
       fmt::format("d(left - right)/da has rank 0{}, so no acceleration is determined",
                   constraints == 0 ? "" : " beyond the rows of A"),
       "an identity, such as 0 = 0, holds for any motion"});
}

}  // namespace

std::optional<State> motion_at(const Model& model, const State& start) {
  std::optional<State> state = move_onto_constraints(model, start);
  if (!state) return std::nullopt;
  const OracleValues solution =
      oracle_values(model, {.kind = OutputKind::forward_dynamics}, *state);
  if (!solution) return std::nullopt;
  const auto count = static_cast<std::ptrdiff_t>(state->a.size());
  std::copy_n(solution->begin(), count, state->a.begin());
  const auto constraints = static_cast<std::ptrdiff_t>(state->multipliers.size());
  std::copy(solution->end() - constraints, solution->end(), state->multipliers.begin());
  return state;
}

bool is_incomplete(const Model& model, const Expectation& equations) {
  return equations.entries.size() + model.constraints.size() <
         stated_system(model, equations).unknowns();
}

std::optional<CertificateRow> identity_row(const ExpectedEntry& entry,
                                           const std::vector<State>& states) {
  CertificateRow row = unjudged_row(entry);
  for (State state : states) {
    // No equation contains the reference velocities, so they are random multipliers.
    for (std::size_t k = 0; k < state.multipliers.size(); ++k)
      state.multipliers[k] = state.reference[k % state.reference.size()];
    const OracleValues value =
        stable_expression_value(entry.subject.model, entry.expression(), state).values;
    if (!value) continue;
    if (!cln::zerop(value->front())) return std::nullopt;
    ++row.samples;
  }
  row.verdict = Verdict::noted;
  row.worst_value = "an identity: it holds for any motion, so it proves nothing";
  row.tolerance = "left - right is 0 for random accelerations: sampled, no proof";
  return row.samples > 0 ? std::optional(row) : std::nullopt;
}

void check_rank(ExpectationReport& report, const Expectation& equations,
                const std::vector<ExpressionId>& identities, const SystemUnderTest& subject,
                const std::vector<State>& states) {
  StatedSystem system = stated_system(subject.model, equations);
  // The slopes of an identity are rounding errors, which would count as a rank.
  std::erase_if(system.equations, [&identities](ExpressionId equation) {
    return std::ranges::count(identities, equation) > 0;
  });
  const std::vector<State> motions = first_motions(subject.model, states);
  CertificateRow row = unjudged_row({equations, 0, subject});
  row.subject = "accelerations";
  row.formula = "rank of d(left - right)/da and A = number of velocities";
  row.samples = motions.size();
  row.worst_value = "full rank";
  row.tolerance = "pivots above 1e-50 of the largest entry of their row, in 60 digits";
  const std::size_t n = system.accelerations();
  const bool incomplete = is_incomplete(subject.model, equations);
  if (incomplete) count_equations(report, row, system, equations.span, motions);
  for (std::size_t i = 0; !incomplete && i < motions.size(); ++i) {
    const std::vector<cl_R> slopes = unknown_slopes(system, motions[i]);
    if (slopes.empty()) continue;
    const std::size_t rank = acceleration_rank(system, slopes);
    const auto other = rank < n ? std::nullopt : find_other_motion(system, motions[i], slopes);
    if (rank == n && !other) continue;
    row.verdict = Verdict::fails;
    row.worst_value = rank < n ? fmt::format("rank {} of {}", rank, n) : "two accelerations";
    row.worst_state = describe_state(subject, motions[i]);
    report.diagnostics.push_back({Code::E540, equations.span,
                                  fmt::format("{}, so the accelerations are not determined, at {}",
                                              rank < n ? "d(left - right)/da has " + row.worst_value
                                                       : second_solution_text(*other),
                                              row.worst_state)});
    break;
  }
  report.rows.push_back(std::move(row));
}

}  // namespace elgen
