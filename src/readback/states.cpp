// states: rationals without a pattern, so that what differs somewhere differs here.
#include "states.hpp"

#include <array>
#include <unordered_map>

#include "base/random.hpp"

namespace elgen::reading {
namespace {

using cln::cl_RA;

/// Unit quaternions of rational numbers.
constexpr std::array<std::array<int, 5>, 3> quaternions{
    {{4, 2, 5, 6, 9}, {5, 1, -3, 1, 6}, {2, 4, 1, -2, 5}}};

/// In the middle nine tenths of the range, of [-1, 1] where there is none.
Real within(const std::optional<Interval>& range, Random& random) {
  const Interval interval = range ? *range : Interval{-1, 1};
  const cl_RA share = (1 + random.rational() * cl_RA(9) / 10) / 2;
  return Real(interval.low + (interval.high - interval.low) * share);
}

Arguments<Real> state(const Model& model, const LeafNames& leaves, std::size_t number,
                      Random& random) {
  Arguments<Real> values;
  std::unordered_map<std::string, cln::cl_R> parameters;
  for (const Parameter& p : model.parameters) parameters.emplace(p.name, p.value);
  for (const std::string& name : leaves.parameters)
    values.parameters.emplace_back(parameters[name]);
  for (const Coordinate& c : model.coordinates) values.q.push_back(within(c.range, random));
  for (const Rotation& rotation : model.rotations) {
    const auto& q = quaternions[number % quaternions.size()];
    for (std::size_t i = 0; i < 4; ++i) {
      values.q[rotation.first_coordinate + i] = Real(cl_RA(q[i]) / q[4]);
    }
  }
  for (const Velocity& v : model.velocities) {
    values.v.push_back(within(v.rate_range, random));
    values.a.push_back(within({}, random));
  }
  for (const Input& input : model.inputs) values.u.push_back(within(input.limits, random));
  values.t = within({}, random);
  return values;
}

}  // namespace

std::vector<Arguments<Real>> comparison_states(const Model& model, const LeafNames& leaves,
                                               std::size_t count) {
  std::vector<Arguments<Real>> states;
  Random random(1);
  while (states.size() < count) states.push_back(state(model, leaves, states.size(), random));
  return states;
}

}  // namespace elgen::reading
