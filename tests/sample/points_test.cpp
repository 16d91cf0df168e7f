// Points: determined by a seed, with the promised magnitudes and signs, and with special angles.
#include "sample/points.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace elgen;

namespace {

constexpr double right_angle = 1.5707963267948966;

/// Two coordinates with their rates, and two parameters; the second is assumed positive.
LeafNames two_of_each() {
  LeafNames leaves;
  leaves.q = {"phi", "x"};
  leaves.v = {"dot(phi)", "dot(x)"};
  leaves.parameters = {"k", "m"};
  leaves.assumptions = {Assumption::none, Assumption::positive};
  return leaves;
}

/// The binary exponents of all coordinates and rates.
std::vector<int> exponents(const LeafValues<double>& point) {
  std::vector<int> all;
  for (const auto* numbers : {&point.q, &point.v}) {
    for (const double x : *numbers) all.push_back(std::ilogb(x));
  }
  return all;
}

bool all_within(const LeafValues<double>& point, int low, int high) {
  return std::ranges::all_of(exponents(point), [&](int e) { return e >= low && e <= high; });
}

}  // namespace

TEST_CASE("a sampler and its copy draw the same vectors without zero entries") {
  Sampler draw(3);
  Sampler copy = draw;
  const std::vector<cln::cl_R> vector = draw.vector(5);
  CHECK(vector == copy.vector(5));
  CHECK(std::ranges::none_of(vector, [](const cln::cl_R& x) { return cln::zerop(x); }));
  CHECK(draw.vector(5) != vector);
}

TEST_CASE("parameters of exact points are positive: all, or only those assumed positive") {
  const LeafNames leaves = two_of_each();
  Sampler draw(1);
  bool is_negative = false;
  for (int i = 0; i < 20; ++i) {
    const LeafValues<cln::cl_RA> positive = draw.point(leaves);
    CHECK((positive.parameters[0] > 0 && positive.parameters[1] > 0));
    CHECK(cln::zerop(positive.t));
    const LeafValues<cln::cl_RA> assumed = draw.point(leaves, PositiveParameters::assumed);
    CHECK(assumed.parameters[1] > 0);
    is_negative = is_negative || assumed.parameters[0] < 0;
  }
  CHECK(is_negative);
}

TEST_CASE("a quarter of the mixed points have ordinary magnitudes, the others wide ones") {
  const Points points = mixed_magnitude_points(two_of_each());
  REQUIRE(points.size() == 16);
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(all_within(points[i], i % 4 == 0 ? -3 : -26, i % 4 == 0 ? 0 : 26));
    CHECK((points[i].parameters[0] > 0 && points[i].parameters[1] > 0));
  }
  CHECK_FALSE(std::ranges::all_of(points, [](const auto& p) { return all_within(p, -3, 3); }));
}

TEST_CASE("angles are moved near right angles, straight angles, equal angles and 0") {
  const std::vector<bool> is_angle{true, false, true};
  Sampler draw(1);
  for (int i = 0; i < 20; ++i) {
    std::vector<double> q{9, 9, 9};
    draw.set_angles(CancellingAngles::right, is_angle, q);
    CHECK(std::abs(std::cos(q[0])) == Approx(7.5e-9).margin(2.6e-9));
    CHECK(q[1] == 9);
    draw.set_angles(CancellingAngles::straight, is_angle, q);
    CHECK(std::abs(std::sin(q[2])) == Approx(7.5e-9).margin(2.6e-9));
    draw.set_angles(CancellingAngles::equal, is_angle, q);
    CHECK((q[0] != q[2] && std::abs(q[0] - q[2]) < 2e-3));
    CHECK(std::abs(q[0]) < 2 * right_angle + 1e-3);
    draw.set_angles(CancellingAngles::tiny, is_angle, q);
    CHECK(std::abs(q[0]) < 1e-8);
  }
}
