// E511: configurations at which M loses rank though it is regular elsewhere: the chart breaks
// there.
//
// A coordinate's `singular` factor says so itself. Otherwise angles are tried at the multiples of a
// right angle and every coordinate at 0, the others being random.
#include <fmt/format.h>

#include "inspect/checks.hpp"
#include "inspect/null_space.hpp"
#include "inspect/samples.hpp"

namespace elgen {
namespace {

using cln::cl_R;

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
    // The digits of pi leave sin(pi) below 1e-50, as null_space() asks.
    const cl_R pi = cln::pi(cln::float_format(80));
    values.insert(values.end(), {{"pi/2", pi / 2}, {"-pi/2", -pi / 2}, {"pi", pi}});
  }
  return values;
}

Diagnostic declared(const Model& model, const Coordinate& coordinate) {
  const std::string_view factor = covered_text(model.expressions[*coordinate.singular].span);
  return {Code::E511, coordinate.span,
          fmt::format("the chart of `{}` breaks where `{}` is zero", coordinate.name, factor)};
}

/// "0, pi": the special values of coordinate i at which M is singular.
std::string breaking_values(const Inspected& subject, const MassSample& regular, std::size_t i) {
  const Vector scales = row_scales(regular.matrix, regular.state.v.size());
  std::string names;
  for (const SpecialValue& special : special_values(subject.model.coordinates[i])) {
    // Nothing holds an angle in its range as a motion turns it.
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

Diagnostic found(const Coordinate& coordinate, const std::string& values) {
  return {Code::E511, coordinate.span,
          fmt::format("the mass matrix loses rank at `{}` = {}", coordinate.name, values),
          "state it as `singular`, or choose other coordinates if the motion passes there"};
}

}  // namespace

Diagnostics inspect_charts(const Inspected& subject) {
  const auto& coordinates = subject.model.coordinates;
  Diagnostics diagnostics;
  for (const Coordinate& coordinate : coordinates) {
    if (coordinate.singular) diagnostics.push_back(declared(subject.model, coordinate));
  }
  if (coordinates.size() > most_coordinates_searched) return diagnostics;
  const auto regular = sampled_mass_matrix(subject, 0);
  for (std::size_t i = 0; regular && i < coordinates.size(); ++i) {
    if (coordinates[i].singular || coordinates[i].rotation) continue;
    const std::string values = breaking_values(subject, *regular, i);
    if (!values.empty()) diagnostics.push_back(found(coordinates[i], values));
  }
  return diagnostics;
}

}  // namespace elgen
