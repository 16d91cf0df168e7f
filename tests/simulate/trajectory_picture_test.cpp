// A trajectory as a picture.
#include <tinyxml2.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "elgen/simulate.hpp"
#include "support/shell.hpp"

using namespace elgen;
using elgen::test::count;
using elgen::test::mentions;

namespace {

Trajectory seven_columns() {
  Trajectory trajectory;
  trajectory.columns = {{"t", "s", ""},   {"phi", "rad", "phi"}, {"e_w", "", "e"},
                        {"e_x", "", "e"}, {"dot(phi)", "", ""},  {"x<y", "m", "x<y"},
                        {"E", "", "E"}};
  for (int i = 0; i <= 10; ++i) {
    const double t = i;
    trajectory.rows.push_back({t, std::remainder(t, 2 * M_PI), 1, 0, 1, t * t, 3});
  }
  return trajectory;
}

}  // namespace

TEST_CASE("a picture is XML with a panel for each name, and a curve for each column in it") {
  const std::string svg = to_svg(seven_columns());
  tinyxml2::XMLDocument document;
  REQUIRE(document.Parse(svg.c_str()) == tinyxml2::XML_SUCCESS);
  CHECK(count(svg, "font-weight") == 4);
  CHECK(count(svg, "<path") == 5);
  CHECK(mentions(svg, "phi [rad]"));
  CHECK(mentions(svg, "x&lt;y [m]"));
  CHECK_FALSE(mentions(svg, "dot(phi)"));
  CHECK_FALSE(mentions(svg, "nan"));
}

TEST_CASE("curves of one panel differ in their dashes, and wrapped angles are interrupted") {
  const std::string svg = to_svg(seven_columns());
  CHECK(count(svg, "stroke-dasharray=\"none\"") == 4);
  CHECK(count(svg, "stroke-dasharray=\"9 4\"") == 1);
  CHECK(mentions(svg, ">e: e_w solid, e_x dashed<"));
  const std::size_t path = svg.find("<path");
  const std::string first = svg.substr(path, svg.find("/>", path) - path);
  CHECK(count(first, "M") == 3);
}
