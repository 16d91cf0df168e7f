// domain: see elgen/domain.hpp.
#include "elgen/domain.hpp"

#include <algorithm>

#include "sample/states.hpp"

namespace elgen {
namespace {

constexpr std::size_t domain_states = 8;

/// Equal numbers for parameters whose units are equal; what is not checked has a unit of its own.
std::vector<std::uint32_t> numbered_units(const Model& model) {
  std::vector<std::optional<Unit>> known;
  std::vector<std::uint32_t> numbers;
  for (const Parameter& parameter : model.parameters) {
    auto at = parameter.unit ? std::ranges::find(known, parameter.unit) : known.end();
    if (at == known.end()) at = known.insert(at, parameter.unit);
    numbers.push_back(static_cast<std::uint32_t>(at - known.begin()));
  }
  return numbers;
}

}  // namespace

Domain domain_of(const Model& model, const Scene& scene, const Program& program) {
  const Subject subject{model, scene, program};
  const LeafValues<Range> ranges = ranges_of(subject);
  Random random(1);
  Domain domain;
  for (std::size_t i = 0; i < domain_states; ++i) {
    domain.states.push_back(drawn_within(subject, ranges, random));
  }
  domain.declared = map_leaves([](const Range&) { return std::optional<Range>(); }, ranges);
  const auto fill = [&](Opcode kind, std::uint32_t number, const Range& range,
                        std::optional<Range>& declared) {
    if (declared_range(model, kind, number)) declared = range;
  };
  for_each_leaf(fill, ranges, domain.declared);
  for (const Coordinate& coordinate : model.coordinates) {
    domain.is_alone.push_back(!coordinate.rotation);
  }
  domain.unit_of = numbered_units(model);
  return domain;
}

}  // namespace elgen
