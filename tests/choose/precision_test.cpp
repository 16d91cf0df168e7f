// Digits that a function may lose, at fixed points where sums cancel.
#include "choose/precision.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "lower/read_program.hpp"

using namespace elgen;

namespace {

const std::string head =
    "parameters m l\ncoordinates q x\nfunction bias\n  0 = parameter m\n  1 = parameter l\n"
    "  2 = coordinate q\n  3 = coordinate x\n  4 = constant 1\n";

double loss_of(const std::string& instructions, int entry) {
  const Program program =
      testing::read_program(head + instructions + "  result 1 1 = " + std::to_string(entry) + "\n");
  return possible_losses(program, program.functions[0], extreme_points(program)).at(0);
}

}  // namespace

TEST_CASE("1 - cos(q) loses all digits, 2 sin(q/2)^2 none") {
  CHECK(loss_of("  5 = cos 2\n  6 = subtract 4 5\n", 6) > 1e12);
  CHECK(loss_of("  5 = constant 1/2\n  6 = multiply 5 2\n  7 = sin 6\n  8 = multiply 7 7\n", 8) ==
        0);
}

TEST_CASE("m + l - l cos(q)^2 loses digits where l is far larger than m") {
  const std::string squared =
      "  5 = cos 2\n  6 = multiply 5 5\n  7 = multiply 1 6\n  8 = add 0 1\n";
  CHECK(loss_of(squared + "  9 = subtract 8 7\n", 9) > 1e6);
  CHECK(loss_of("  5 = sin 2\n  6 = multiply 5 5\n  7 = multiply 1 6\n  8 = add 0 7\n", 8) == 0);
}

TEST_CASE("what the inputs' own rounding costs is no loss") {
  CHECK(loss_of("  5 = subtract 0 1\n", 5) == 0);
  CHECK(loss_of("  5 = subtract 2 3\n  6 = sin 5\n", 6) == 0);
}

TEST_CASE("points are the same every time, and only angles are near right ones") {
  const Program program = testing::read_program(
      head +
      "  5 = constant 2\n  6 = multiply 5 2\n  7 = cos 6\n  8 = add 7 3\n  result 1 1 = 8\n");
  const ComparisonPoints points = extreme_points(program);
  CHECK(points.size() == 8 + 2 * 3 * 4);
  const ComparisonPoints again = extreme_points(program);
  const auto near_right = [](double x) {
    return std::abs(x / 1.5707963267948966 - std::round(x / 1.5707963267948966)) < 1e-7 &&
           std::abs(x) > 1;
  };
  const auto count = [&](std::size_t coordinate) {
    return std::ranges::count_if(points,
                                 [&](const auto& p) { return near_right(p.q[coordinate]); });
  };
  CHECK(count(0) >= 6);
  CHECK(count(1) == 0);
  for (std::size_t i = 0; i < points.size(); ++i) CHECK(points[i].q == again[i].q);
}

TEST_CASE("an entry that vanishes beside another one of its field loses nothing by that scale") {
  const Program program = testing::read_program(
      "coordinates q\nfunction bias\n  0 = coordinate q\n  1 = cos 0\n  2 = constant 1\n"
      "  3 = subtract 2 1\n  result 2 1 = 2 3\n");
  const Function& function = program.functions[0];
  const ComparisonPoints points = extreme_points(program);
  CHECK(possible_losses(program, function, points, Scale::entry).at(1) > 1e6);
  CHECK(possible_losses(program, function, points, Scale::field).at(1) == 0);
  const Magnitudes magnitudes = magnitudes_of(program, function, points, Scale::field);
  REQUIRE(magnitudes.size() == points.size());
  for (const std::vector<double>& of_point : magnitudes) {
    CHECK(of_point == std::vector<double>{of_point[0], of_point[0]});
    CHECK(of_point[0] >= 1);
  }
}

TEST_CASE("losses are compared by their factor, where there are some") {
  CHECK(loses_more(1e6, 1e3));
  CHECK_FALSE(loses_more(1e6, 2e5));
  CHECK_FALSE(loses_more(60, 0));
  CHECK(loses_more(65, 0));
  CHECK_FALSE(loses_more(8000, 0, 8192));
  CHECK(loses_more(9000, 1000, 8192));
}
