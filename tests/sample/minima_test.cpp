// Minima of potentials: places at which several sums vanish, quartics, cyclic coordinates and
// constraints.
#include "sample/minima.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <vector>

#include "elgen/oracle.hpp"
#include "numbers/dual.hpp"
#include "oracle/model_builder.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

using Place = std::vector<double>;
using DualReal = Dual<Real>;

DualReal number(const char* text) { return ScalarTraits<DualReal>::from_real(exact(text)); }

/// V and its slopes for a potential of the dual numbers q.
template <class Potential>
PotentialValues values_of(const Potential& potential, const std::vector<Real>& q) {
  PotentialValues values;
  for (std::size_t i = 0; i < q.size(); ++i) {
    std::vector<DualReal> at;
    for (std::size_t k = 0; k < q.size(); ++k) at.push_back({q[k], Real(k == i ? 1 : 0)});
    const DualReal value = potential(at);
    values.potential = value.value;
    values.slopes.push_back(value.slope);
  }
  return values;
}

const Interval unit_range{-1, 1};

/// Two coordinates x and y, without a range of x if `range` is empty.
Model plane(const std::optional<Interval>& range = unit_range) {
  ModelBuilder builder;
  builder.coordinate("x").coordinate("y");
  builder.model.coordinates[0].range = range;
  builder.model.coordinates[1].range = unit_range;
  return builder.model;
}

/// The minima of `potential` from the origin and two other starts.
std::vector<Place> minima_of(const PotentialFunction& potential, const Model& model) {
  Domain domain{model};
  domain.ranges.q = {{-1, 1}, {-1, 1}};
  for (const Place& q : {Place{-0.5, 0.125}, Place{0.25, -0.875}}) {
    LeafValues<double> state =
        map_leaves([](const cln::cl_R& x) { return to_double(x); }, nominal_state(model, {}));
    state.q = q;
    domain.states.push_back(state);
  }
  return find_minima(potential, {0, 1}, domain);
}

template <class Potential>
std::vector<Place> minima_in_plane(const Potential& potential,
                                   const std::optional<Interval>& range = unit_range) {
  return minima_of([&](const std::vector<Real>& q) { return values_of(potential, q); },
                   plane(range));
}

}  // namespace

TEST_CASE("the place at which three sums vanish together comes before a saddle") {
  const auto found = minima_in_plane([](const auto& q) {
    const DualReal one = number("1");
    const DualReal x = q[0] - number("1/2");
    const DualReal stretch = sqrt(x * x + q[1] * q[1]) - number("3/10");
    return number("9/2") * stretch * stretch + number("2") * (one - cos(q[1])) +
           number("2") * (cosh(q[0] - number("4/5")) - one);
  });
  REQUIRE(found.size() == 2);
  CHECK(found[0] == Place{0.8, 0});
  CHECK(found[1][0] == Approx(0.31264059808290430));
  CHECK(found[1][1] == 0);
}

TEST_CASE("the minimum of a quartic has all digits") {
  const auto found = minima_in_plane([](const auto& q) {
    const DualReal x = q[0] - number("3/10");
    return x * x * x * x + q[1] * q[1];
  });
  CHECK(found == std::vector<Place>{Place{0.3, 0}});
}

TEST_CASE("minima along a cyclic coordinate are found where the starts lead") {
  const auto ring = minima_in_plane([](const auto& q) {
    const DualReal stretch = sqrt(q[0] * q[0] + q[1] * q[1]) - number("1");
    return stretch * stretch;
  });
  REQUIRE(ring.size() == 2);
  for (const Place& q : ring) CHECK(std::abs(std::hypot(q[0], q[1]) - 1) < 1e-15);
  const auto line =
      minima_in_plane([](const auto& q) { return number("1") - cos(q[0] - q[1] - number("2/5")); });
  REQUIRE(line.size() == 3);
  for (const Place& q : line) CHECK(std::abs(q[0] - q[1] - 0.4) < 1e-15);
}

TEST_CASE("the minimum on a constraint is its lowest point") {
  ModelBuilder builder;
  builder.coordinate("x").coordinate("y").constraint("x^2 + y^2 - 1");
  const auto height = [](const auto& q) { return number("9.81") * q[1] + number("1") - cos(q[0]); };
  const PotentialFunction slopes = [&](const std::vector<Real>& q) { return values_of(height, q); };
  CHECK(minima_of(slopes, builder.model) == std::vector<Place>{Place{0, -1}});
  for (int i = 0; i < 6; ++i) builder.constraint("x^2 + y^2 - 1");
  CHECK(minima_of(slopes, builder.model).empty());  // more than eight unknowns
}

TEST_CASE("a potential without a minimum gives no place") {
  CHECK(minima_in_plane([](const auto& q) { return q[0] * q[0] + q[1]; }).empty());
  CHECK(minima_in_plane([](const auto& q) { return exp(-q[0]) + q[1] * q[1]; }).empty());
  CHECK(minima_of([](const std::vector<Real>&) { return std::nullopt; }, plane()).empty());
}

TEST_CASE("a minimum outside the declared range gives no place") {
  const auto well = [](const auto& q) {
    const DualReal x = q[0] - number("5");
    return x * x + q[1] * q[1];
  };
  CHECK(minima_in_plane(well, std::nullopt) == std::vector<Place>{Place{5, 0}});
  CHECK(minima_in_plane(well).empty());
}

TEST_CASE("of equal minima of an unbounded coordinate the typed one counts") {
  Model model = plane(std::nullopt);
  model.coordinates[0].unit = Unit{};
  const auto strained = [](const auto& q) {
    return q[0] * q[0] + number("1") / (q[0] * q[0]) + q[1] * q[1];
  };
  const PotentialFunction slopes = [&](const std::vector<Real>& q) {
    return values_of(strained, q);
  };
  CHECK(minima_of(slopes, model) == std::vector<Place>{Place{1, 0}});
}

TEST_CASE("minima at values of parameters are found from far starts") {
  ModelBuilder builder;
  builder.coordinate("x").coordinate("y").parameter("r", "0.0000000004656612873077392578125");
  for (std::size_t i = 0; i < 2; ++i) builder.model.coordinates[i].unit = find_unit("m");
  builder.model.parameters[0].unit = find_unit("m");
  const auto bond = [](const auto& q) {
    const DualReal ratio = number("0.0000000004656612873077392578125") / q[0];
    const DualReal sixth = ratio * ratio * ratio * ratio * ratio * ratio;
    return sixth * sixth - number("2") * sixth + q[1] * q[1];
  };
  const PotentialFunction slopes = [&](const std::vector<Real>& q) { return values_of(bond, q); };
  CHECK(minima_of(slopes, builder.model) == std::vector<Place>{Place{0x1p-31, 0}});
}
