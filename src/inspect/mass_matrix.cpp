// Signs and rank of the mass matrix M.
//
// E523: a mass is negative at the parameter values of the model.
// E524: at a sampled state, M is regular but not positive definite.
// E525: D is negative at a sampled state.
// E501: M is singular at every sampled state: M x = 0, so x is a motion without kinetic energy. The
// message has a basis of the null space if the basis is the same at all samples, else the rank. If
// an output divides by M, E501 is also reported if a diagonal entry is 0 at every sample.
// E511: M is regular in general, but loses rank at special configurations. The `singular` factor of
// a coordinate declares these configurations. Without a factor, we try multiples of a right angle
// for each angle and 0 for each coordinate, with random values of all other coordinates.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "elgen/outputs.hpp"
#include "elgen/references.hpp"
#include "inspect/checks.hpp"
#include "inspect/null_space.hpp"
#include "inspect/readable.hpp"
#include "inspect/samples.hpp"
#include "inspect/singular_mass.hpp"
#include "numbers/echelon.hpp"

namespace elgen {
namespace {

using cln::cl_R;
using Basis = std::vector<RealVector>;

/// True if the vectors are the same, component by component, in the form in which they are printed.
bool are_same_as_printed(const Basis& x, const Basis& y) {
  return std::ranges::equal(x, y, [](const RealVector& a, const RealVector& b) {
    return std::ranges::equal(a, b, {}, readable_number, readable_number);
  });
}

std::vector<std::size_t> nonzero_indices(const RealVector& x) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (readable_number(x[i]) != "0") indices.push_back(i);
  }
  return indices;
}

/// The components of x with the indices `part` as a proportion: "x1 : x2 = 1 : -1".
std::string proportion_text(const Model& model, const RealVector& x,
                            const std::vector<std::size_t>& part) {
  std::string names;
  std::string shares;
  for (const std::size_t i : part) {
    const char* separator = names.empty() ? "" : " : ";
    names += separator + model.velocities[i].name;
    shares += separator + readable_number(x[i] / x[part.front()]);
  }
  return names + " = " + shares;
}

Diagnostic motion_without_energy_error(const Model& model, const RealVector& x) {
  const std::vector<std::size_t> part = nonzero_indices(x);
  const Velocity& first = model.velocities[part.front()];
  if (part.size() == 1) {
    return {Code::E501, first.span,
            fmt::format("the rate of `{}` has no kinetic energy", first.name),
            "give it a mass, or remove the coordinate"};
  }
  return {Code::E501, first.span,
          fmt::format("the motion `{}` has no kinetic energy", proportion_text(model, x, part)),
          "too many coordinates, or a mass is missing"};
}

/// E501 if the null space varies with the state: the rank of M, and one motion without kinetic
/// energy at one configuration.
Diagnostic rank_deficit_error(const Model& model, const Basis& basis, const State& state) {
  const std::size_t n = model.velocities.size();
  std::string at;
  for (const cl_R& q : state.q) at += (at.empty() ? "" : ", ") + readable_number(q);
  return {Code::E501, model.velocities.front().span,
          fmt::format(
              "rank {} of {} at every sampled configuration: the motion `{}` has no kinetic "
              "energy at q = ({})",
              n - basis.size(), n, proportion_text(model, basis[0], nonzero_indices(basis[0])), at),
          "too many coordinates, or a mass is missing"};
}

/// The velocities i among `candidates` for which M_ii is only rounding error relative to row i. If
/// the list is not empty, M is not positive definite, and the factorisation fails.
std::vector<std::size_t> rates_without_energy(const MassSample& sample,
                                              const std::vector<std::size_t>& candidates) {
  const std::size_t n = sample.state.v.size();
  const RealVector scales = row_scales(sample.matrix, n);
  std::vector<std::size_t> result;
  for (const std::size_t i : candidates) {
    if (cln::abs(sample.matrix[i * n + i]) <= rounding_tolerance() * scales[i]) result.push_back(i);
  }
  return result;
}

/// E501 for the first output that divides by M and therefore requires a positive definite M. If the
/// scene does not name this output, the error is at the energy of the model.
Diagnostics not_definite_error(const InspectedModel& subject,
                               const std::vector<std::size_t>& rates) {
  const Model& model = subject.model;
  for (const OutputRequest& output : subject.scene.outputs) {
    if (!divides_by_mass(output_row(output.kind)) || rates.empty()) continue;
    const Velocity& velocity = model.velocities[rates.front()];
    Diagnostic error = no_kinetic_energy_error(output, velocity.name);
    if (error.span.source == nullptr) {
      const auto& written = model.energies.L ? model.energies.L : model.energies.T;
      error.span = written ? model.expressions[*written].span : velocity.span;
      error.hint = fmt::format(
          "add a term with the square of `dot({})`, such as 1/2*m*v^2, or do not request "
          "this output",
          velocity.name);
    }
    return {error};
  }
  return {};
}

Diagnostics singular_errors(const Model& model, const std::vector<Basis>& found,
                            const State& last) {
  for (const Basis& basis : found) {
    if (!are_same_as_printed(basis, found.front()))
      return {rank_deficit_error(model, found.back(), last)};
  }
  Diagnostics diagnostics;
  for (const RealVector& x : found.front())
    diagnostics.push_back(motion_without_energy_error(model, x));
  return diagnostics;
}

void check_mass(const Model& model, const State& state, const std::string& name,
                const std::optional<ExpressionId>& mass, Diagnostics& found) {
  if (!mass) return;
  const auto value = oracle_expression_value(model, *mass, state);
  if (!value || *value >= 0) return;
  found.push_back({Code::E523, model.expressions[*mass].span,
                   fmt::format("the mass of `{}` is {}", name, exact_number_text(*value)),
                   "sign mistake?"});
}

/// E523 for each negative mass. None for models with more than most_coordinates_sampled velocities,
/// because each mass costs a traversal of the model.
Diagnostics negative_mass_errors(const InspectedModel& subject) {
  const Model& model = subject.model;
  if (model.velocities.size() > most_coordinates_sampled) return {};
  const State state = nominal_state(model, subject.scene);
  Diagnostics found;
  for (const Point& point : model.points) check_mass(model, state, point.name, point.mass, found);
  for (const Body& body : model.bodies) check_mass(model, state, body.name, body.mass, found);
  return found;
}

/// The first velocity, in the order of elimination, whose pivot of M = L D L^T is negative beyond
/// rounding error. None if no pivot is negative or an earlier pivot is 0.
std::optional<std::size_t> find_negative_pivot(const MassSample& sample) {
  const std::size_t n = sample.state.v.size();
  const RealVector scales = row_scales(sample.matrix, n);
  DiagonalPivot<cl_R> field;
  const Echelon<DiagonalPivot<cl_R>> echelon(field, sample.matrix, n, n);
  std::size_t k = 0;
  for (const auto& pivot : echelon.pivots()) {
    const cl_R least = rounding_tolerance() * scales[k];
    if (pivot.column != k || cln::abs(pivot.value) <= least) return std::nullopt;
    if (cln::minusp(pivot.value)) return k;
    ++k;
  }
  return std::nullopt;
}

/// E524 if M is neither positive definite nor singular at the sample. No error if a mass is
/// negative.
Diagnostics negative_energy_errors(const InspectedModel& subject, const MassSample& sample) {
  const Model& model = subject.model;
  const auto at = find_negative_pivot(sample);
  // A negative mass is already reported as E523.
  if (!at || !negative_mass_errors(subject).empty()) return {};
  const auto& written = model.energies.L ? model.energies.L : model.energies.T;
  const Span& span = written ? model.expressions[*written].span : model.velocities[*at].span;
  return {{Code::E524, span,
           fmt::format("M is not positive definite: motions of `{}` have negative kinetic energy",
                       model.velocities[*at].name),
           "sign mistake, or a square is missing?"}};
}

// E511: special configurations at which M loses rank.

struct SpecialValue {
  const char* name;
  cl_R value;
};

bool contains(const std::optional<Interval>& range, const cl_R& value) {
  return !range || (range->low <= value && value <= range->high);
}

std::vector<SpecialValue> special_values(const Coordinate& coordinate) {
  std::vector<SpecialValue> values{{"0", 0}};
  if (is_angle(coordinate)) {
    // With 80 digits of pi, sin(pi) is below 1e-50, the threshold of null_space().
    const cl_R pi = cln::pi(cln::float_format(80));
    values.insert(values.end(), {{"pi/2", pi / 2}, {"-pi/2", -pi / 2}, {"pi", pi}});
  }
  return values;
}

Diagnostic declared_chart_note(const Model& model, const Coordinate& coordinate) {
  const std::string_view factor =
      covered_text(model.expressions[*coordinate.singular_condition].span);
  return {Code::E511, coordinate.span,
          fmt::format("the chart of `{}` breaks where `{}` is zero", coordinate.name, factor)};
}

/// The special values of coordinate i at which M is singular, as text: "0, pi".
std::string rank_losing_values(const InspectedModel& subject, const MassSample& regular,
                               std::size_t i) {
  const RealVector scales = row_scales(regular.matrix, regular.state.v.size());
  std::string names;
  for (const SpecialValue& special : special_values(subject.model.coordinates[i])) {
    // A motion may leave the declared range of an angle, so all special values of angles are tried.
    const Coordinate& coordinate = subject.model.coordinates[i];
    if (!is_angle(coordinate) && !contains(coordinate.range, special.value)) continue;
    State state = regular.state;
    state.q[i] = special.value;
    const OracleValues matrix =
        oracle_values(subject.model, {.kind = OutputKind::mass_matrix}, state);
    if (!matrix || null_space(*matrix, scales).empty()) continue;
    names += (names.empty() ? "" : ", ") + std::string(special.name);
  }
  return names;
}

Diagnostic found_chart_note(const Coordinate& coordinate, const std::string& values) {
  return {Code::E511, coordinate.span,
          fmt::format("the mass matrix loses rank at `{}` = {}", coordinate.name, values),
          "state it as `singular`, or choose other coordinates if the motion passes there"};
}

}  // namespace

Diagnostics inspect_mass_matrix(const InspectedModel& subject) {
  const std::size_t n = subject.model.velocities.size();
  if (n > most_coordinates_sampled) return {};
  std::vector<Basis> found;
  std::vector<std::size_t> rates(n);
  std::iota(rates.begin(), rates.end(), std::size_t{0});
  bool is_regular = false;
  State last;
  for (unsigned seed = 0; seed < zero_sample_count; ++seed) {
    const auto sample = sample_mass_matrix(subject, seed);
    if (!sample) return {};
    found.push_back(null_space(sample->matrix, row_scales(sample->matrix, n)));
    rates = rates_without_energy(*sample, rates);
    is_regular = is_regular || found.back().empty();
    if (is_regular && rates.empty()) return negative_energy_errors(subject, *sample);
    last = sample->state;
  }
  return is_regular ? not_definite_error(subject, rates)
                    : singular_errors(subject.model, found, last);
}

Diagnostics inspect_signs(const InspectedModel& subject) {
  const Model& model = subject.model;
  Diagnostics found = negative_mass_errors(subject);
  // D is a single expression; several expressions would have to be summed before the check.
  for (const ExpressionId root : dissipation_roots(model)) {
    for (unsigned seed = 0; seed < zero_sample_count; ++seed) {
      const auto value = oracle_expression_value(model, root, sample_state(subject, seed));
      if (!value || *value >= 0) continue;
      found.push_back({Code::E525, model.expressions[root].span,
                       "D is negative, so it drives the motion",
                       "a damper is `1/2*d*v^2` with a positive d: sign mistake?"});
      break;
    }
  }
  return found;
}

Diagnostics inspect_charts(const InspectedModel& subject) {
  const auto& coordinates = subject.model.coordinates;
  Diagnostics diagnostics;
  for (const Coordinate& coordinate : coordinates) {
    if (coordinate.singular_condition)
      diagnostics.push_back(declared_chart_note(subject.model, coordinate));
  }
  if (coordinates.size() > most_coordinates_searched) return diagnostics;
  const auto regular = sample_mass_matrix(subject, 0);
  for (std::size_t i = 0; regular && i < coordinates.size(); ++i) {
    if (coordinates[i].singular_condition || coordinates[i].rotation) continue;
    const std::string values = rank_losing_values(subject, *regular, i);
    if (!values.empty()) diagnostics.push_back(found_chart_note(coordinates[i], values));
  }
  return diagnostics;
}

}  // namespace elgen
