// Makes the rows of check_structure: the identities, and two properties of M.
#include "verify/structure/structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "accuracy/running_errors.hpp"
#include "elgen/fold.hpp"
#include "elgen/outputs.hpp"
#include "numbers/exact_number.hpp"
#include "sample/states.hpp"
#include "verify/states/tally.hpp"
#include "verify/structure/identities.hpp"

namespace elgen {
namespace {

constexpr double identity_tolerance = 1e-40;
constexpr const char* identity_reason =
    "1e-40 of the largest term: 64-digit arithmetic less 24 digits for cancellation";

/// A smaller relative pivot means that the chart is singular (a pole, gimbal lock). The sign of
/// such a pivot is not checked.
constexpr double singular_pivot = 1e-10;

CertificateRow structure_row(const Function& function, std::string_view check,
                             std::string_view formula) {
  CertificateRow row;
  row.check = check;
  row.output = row.subject = function.name;
  row.formula = formula;
  return row;
}

/// The tally of figure(point) over all points; a point without a figure counts as skipped.
template <class Figure>
Tally tally_points(std::vector<ExactValues>& points, const Figure& figure) {
  Tally tally;
  for (ExactValues& at : points) {
    const std::optional<double> found = figure(at);
    if (found) {
      tally.add(*found, at.state());
    } else {
      tally.count_skipped();
    }
  }
  return tally;
}

/// True if 64 digits suffice although terms cancel: the running error of every entry is below 1e-40
/// of the largest entry.
bool keeps_digits(const ExactValues& at, const Function& function) {
  static const Real roundoff(power_of_ten(-64));
  static const Real tolerance(power_of_ten(-40));
  const RunningErrorRules<Real> rules{map_leaves(
      [](const Real& x) {
        return RunningValue<Real>{x, Real(0)};
      },
      at.arguments())};
  const Program& program = at.subject().program;
  const auto entries = entries_of(function, fold<RunningValue<Real>>(rules, program, function));
  Real largest = at.rounding_floor();
  for (const RunningValue<Real>& entry : entries) largest = max(largest, abs(entry.value));
  const Real allowed = tolerance * largest;
  return std::ranges::all_of(entries, [&](const RunningValue<Real>& entry) {
    const Real error = entry.error * roundoff;
    return !error.is_defined() || !allowed.is_defined() || error.value() <= allowed.value();
  });
}

template <class Compute>
CertificateRow identity_row(CertificateRow row, std::vector<ExactValues>& points,
                            const std::vector<const Function*>& functions, const Compute& compute) {
  const Tally tally = tally_points(points, [&](ExactValues& at) -> std::optional<double> {
    const auto keeps = [&at](const Function* function) { return keeps_digits(at, *function); };
    if (!std::ranges::all_of(functions, keeps)) return std::nullopt;
    return compute(at).relative_residual(at.rounding_floor());
  });
  row.worst_value = fmt::format("{:.1e} relative", tally.worst());
  row.tolerance = identity_reason;
  tally.write_result(row, points.front().subject(), identity_tolerance);
  return row;
}

bool has_all_functions(const Program& program, const std::vector<OutputKind>& kinds) {
  return std::ranges::all_of(
      kinds, [&](OutputKind kind) { return find_function(program, kind) != nullptr; });
}

void add_identity_rows(std::vector<CertificateRow>& rows, std::vector<ExactValues>& points) {
  const SystemUnderTest& subject = points.front().subject();
  const Program& program = subject.program;
  for (const Identity& identity : identities()) {
    if (!has_all_functions(program, identity.functions)) continue;
    const Function& function = *find_function(program, identity.functions.front());
    const bool is_another =
        !subject.model.constraints.empty() && !identity.constrained_formula.empty();
    const auto formula = is_another ? identity.constrained_formula : identity.formula;
    std::vector<const Function*> functions;
    for (const OutputKind kind : identity.functions) {
      functions.push_back(find_function(program, kind));
    }
    rows.push_back(identity_row(structure_row(function, identity.check, formula), points, functions,
                                identity.balance));
  }
}

std::vector<ExactValues> exact_values_at(const SystemUnderTest& subject,
                                         const std::vector<State>& states) {
  std::vector<ExactValues> points;
  points.reserve(states.size());
  for (const State& state : states) points.emplace_back(subject, state);
  return points;
}

/// Scales quaternions to norm 1. Sampled quaternions have norm 1 only to the 16 digits of a double,
/// so R would not be a rotation.
std::vector<State> with_unit_quaternions(const SystemUnderTest& subject,
                                         std::vector<State> states) {
  for (State& state : states) normalize_state_quaternions(subject.model, state);
  return states;
}

void add_output_identity_rows(std::vector<CertificateRow>& rows, std::vector<ExactValues>& points,
                              const std::vector<State>& states) {
  const SystemUnderTest& subject = points.front().subject();
  std::vector<ExactValues> points_on_sphere;
  for (const OutputIdentity& identity : output_identities()) {
    for (std::uint32_t user = 0; user < subject.model.outputs.size(); ++user) {
      const Function* function = find_function(subject.program, identity.derivative, user);
      const bool has_value =
          find_function(subject.program, OutputKind::user_value, user) != nullptr;
      if (function == nullptr || !has_value) continue;
      const bool is_of_frame = subject.model.outputs[user].frame.has_value();
      const bool turns = is_of_frame && !subject.model.rotations.empty();
      if (turns && points_on_sphere.empty()) {
        points_on_sphere = exact_values_at(subject, with_unit_quaternions(subject, states));
      }
      const auto formula = is_of_frame ? identity.formula_of_frame : identity.formula;
      rows.push_back(identity_row(structure_row(*function, identity.check, formula),
                                  turns ? points_on_sphere : points, {function},
                                  [&](ExactValues& at) { return identity.balance(at, user); }));
    }
  }
}

/// The largest |M_ij - M_ji|.
double asymmetry(const std::vector<double>& m, std::size_t n) {
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      largest = std::fmax(largest, std::abs(m[i * n + j] - m[j * n + i]));
    }
  }
  return largest;
}

CertificateRow symmetry_row(const SystemUnderTest& subject, const Function& function,
                            const std::vector<State>& states) {
  Tally tally;
  for (const State& state : states) {
    const std::vector<double> m = evaluate(subject.program, function, arguments_at<double>(state));
    tally.add(asymmetry(m, state.v.size()), state);
  }
  CertificateRow row = structure_row(function, "mass matrix symmetric", "M_ij = M_ji in double");
  row.worst_value = fmt::format("largest difference {:g}", tally.worst());
  row.tolerance = "exact: both entries are the same value";
  tally.write_result(row, subject, 0);
  return row;
}

/// The smallest relative pivot D_i/M_ii. -1 if a diagonal entry of M is negative; none if a
/// diagonal entry is undefined; 0 if M is singular, or if another entry is undefined.
std::optional<double> smallest_pivot(const std::vector<Real>& m, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    if (!m[i * n + i].is_defined()) return std::nullopt;
    if (cln::minusp(m[i * n + i].value())) return -1;
  }
  const OracleValues defined = to_oracle_values(m);
  const OracleValues pivots = defined ? oracle_relative_pivots(*defined, n) : std::nullopt;
  if (!pivots) return 0;
  double smallest = 1;
  for (const cln::cl_R& pivot : *pivots) {
    smallest = std::fmin(smallest, to_double(pivot));
  }
  return smallest;
}

CertificateRow definiteness_row(const Function& function, std::vector<ExactValues>& points) {
  const Tally tally = tally_points(points, [](ExactValues& at) -> std::optional<double> {
    const auto pivot = smallest_pivot(at.entries(OutputKind::mass_matrix), at.size());
    if (!pivot || std::abs(*pivot) < singular_pivot) return std::nullopt;
    return -*pivot;
  });
  CertificateRow row =
      structure_row(function, "mass matrix positive definite", "D_i/M_ii > 0, M = L D L^T");
  row.worst_value = tally.samples() == 0 ? "no regular state"
                                         : fmt::format("smallest pivot {:.2g}", -tally.worst());
  row.tolerance = fmt::format(
      "> {:g}; charts with smaller pivots count as singular and are skipped", singular_pivot);
  tally.write_result(row, points.front().subject(), -singular_pivot, SkipReason::singular);
  return row;
}

}  // namespace

std::vector<CertificateRow> check_structure(const SystemUnderTest& subject,
                                            const std::vector<State>& states) {
  std::vector<CertificateRow> rows;
  if (states.empty()) return rows;
  std::vector<ExactValues> points = exact_values_at(subject, states);
  const Function* mass = find_function(subject.program, OutputKind::mass_matrix);
  if (mass != nullptr) {
    rows.push_back(symmetry_row(subject, *mass, states));
    // An expansion of M is positive definite only near the expansion point.
    if (!subject.model.approximation) rows.push_back(definiteness_row(*mass, points));
  }
  add_identity_rows(rows, points);
  add_output_identity_rows(rows, points, states);
  return rows;
}

}  // namespace elgen
