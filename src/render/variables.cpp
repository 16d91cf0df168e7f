// The variables of a model on a few lines. Rates are named where some function knows of them.
#include <fmt/format.h>

#include "check/judge/output_units.hpp"
#include "elgen/render.hpp"

namespace elgen {
namespace {

using Lines = std::vector<std::string>;

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

/// "(x [m], theta [rad])"; where that is more than a line the first two and the last.
std::string tuple(const Lines& names) {
  constexpr std::size_t longest = 80;  // with "v = ", ", a = dv/dt" and indentation a line of 100
  const std::string all = fmt::format("({})", fmt::join(names, ", "));
  if (names.size() <= 3 || all.size() <= longest) return all;
  return fmt::format("({}, {}, ..., {})", names[0], names[1], names.back());
}

/// "dot(x) [m/s]", "attitude[1] [rad/s]"
Lines rates(const Model& model) {
  Lines names;
  for (const Velocity& velocity : model.velocities) {
    const std::string name = velocity.rotation ? velocity.name : "dot(" + velocity.name + ")";
    names.push_back(with_unit(name, velocity_unit(model, velocity)));
  }
  return names;
}

}  // namespace

Lines variable_lines(const Model& model, const Program& program) {
  Lines coordinates;
  Lines inputs;
  for (const Coordinate& c : model.coordinates) {
    coordinates.push_back(with_unit(c.name, c.unit_text));
  }
  for (const Input& input : model.inputs) inputs.push_back(with_unit(input.name, input.unit_text));
  Lines lines = {"q = " + tuple(coordinates)};
  if (!knows_motion(model, program)) {
    lines.emplace_back("at rest");
  } else if (model.rotations.empty()) {
    lines.push_back("v = dq/dt, a = dv/dt");
  } else {
    lines.push_back("v = " + tuple(rates(model)) + ", a = dv/dt");
    lines.push_back("dq/dt = N(q) v: coordinate_rates");
  }
  if (!inputs.empty()) lines.push_back("u = " + tuple(inputs));
  return lines;
}

}  // namespace elgen
