// A trajectory as text, CSV, JSON and as a plot.
#include <tinyxml2.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "elgen/simulate.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Trajectory two_columns() {
  Trajectory trajectory;
  trajectory.model = "top";
  trajectory.method = "rk4";
  trajectory.columns = {{"t", "s", ""}, {"phi", "rad", "phi"}};
  trajectory.rows = {{0, 0.1}, {1, 1.0 / 3}};
  trajectory.energy = {"E - E0", "|T| + |V|", 0.5, 0.25, 2};
  trajectory.momenta = {{"phi", "sum |M v|", 0, 0, 3}};
  trajectory.conserved = {{"p(phi)", "kg*m^2/s", 3, 1.5e-12}};
  return trajectory;
}

Trajectory seven_columns() {
  Trajectory trajectory;
  trajectory.columns = {{"t", "s", ""},
                        {"phi", "rad", "ϕ", false, "ϕ"},
                        {"e_w", "", "e", false, "e₀"},
                        {"e_x", "", "e", false, "eₓ"},
                        {"dot(phi)", "", "", false, "ϕ\u0307"},
                        {"x<y", "kg*m^2", "x<y", false, "x<y"},
                        {"E", "J", "E − E₀", true}};
  for (int i = 0; i <= 10; ++i) {
    const double t = i;
    trajectory.rows.push_back({t, std::remainder(t, 2 * M_PI), 1, 0, 1, t * t, 3 + 1e-9 * t});
  }
  return trajectory;
}

}  // namespace

TEST_CASE("the text has the last state, the drifts and the cost of a step") {
  Trajectory trajectory;
  trajectory.model = "top";
  trajectory.method = "rk4";
  trajectory.columns = {{"t", "s", ""}, {"phi", "rad", "phi"}, {"dot(phi)", "", ""}};
  trajectory.last = {2, 0.5, -3};
  trajectory.energy = {"E - E0", "|T| + |V|", 1.036e-3, 2.2e-10, 0.46};
  trajectory.momenta = {{"phi", "sum |M v|", 0, 0, 3}};
  trajectory.conserved = {{"p(phi)", "kg*m^2/s", 3, 1.5e-12}, {"2*E", "", -0.5, 0}};
  trajectory.steps = 200;
  trajectory.nanoseconds = 41.7;
  trajectory.timed_code = "of the emitted C++";
  CHECK(to_text(trajectory) == R"(top by rk4: 200 steps to t = 2
  phi      = 0.5 rad
  dot(phi) = -3
  E - E0: worst 1.036e-03, secular +2.2e-10, relative to |T| + |V| = 0.46
  momentum of phi: worst 0.000e+00, secular +0.0e+00, relative to sum |M v| = 3
  p(phi) = 3 kg*m^2/s at the start, drift 1.500e-12 kg*m^2/s
  2*E = -0.5 at the start, drift 0.000e+00
  42 ns per step of the emitted C++
)");
}

TEST_CASE("constraints are reported with their common unit") {
  Trajectory trajectory = two_columns();
  trajectory.last = {1, 0.5};
  trajectory.constraints = ConstraintAccuracy{{1e-15, 2e-14}, "m^2", "m^2/s", {{"x", "m", -1e-3}}};
  CHECK(
      mentions(to_text(trajectory),
               "\n  start projected onto the constraints: x by -1.000e-03 m\n"
               "  constraints: residual at most 1.000e-15 m^2, of their rates 2.000e-14 m^2/s\n"));
  const auto kept = nlohmann::json::parse(to_json(trajectory))["constraints"];
  CHECK(kept["position"] == 1e-15);
  CHECK(kept["unit"] == "m^2");
  CHECK(kept["rate"] == 2e-14);
  CHECK(kept["start_moved"][0]["by"] == -1e-3);
  trajectory.constraints = ConstraintAccuracy{{0, 2e-14}, {}, "", {}};
  CHECK(mentions(to_text(trajectory),
                 "= 3\n  p(phi) = 3 kg*m^2/s at the start, drift 1.500e-12 kg*m^2/s\n"
                 "  rates of the constraints: residual at most 2.000e-14\n"));
  CHECK_FALSE(nlohmann::json::parse(to_json(trajectory))["constraints"].contains("position"));
}

TEST_CASE("CSV has a line for each row, with digits that are read back exactly") {
  CHECK(to_csv(two_columns()) == "t,phi\n0,0.1\n1,0.3333333333333333\n");
}

TEST_CASE("JSON has the rows, their columns and the drifts") {
  const auto object = nlohmann::json::parse(to_json(two_columns()));
  CHECK(object["model"] == "top");
  CHECK(object["columns"][1]["name"] == "phi");
  CHECK(object["columns"][1]["unit"] == "rad");
  CHECK(object["rows"][1][1] == 1.0 / 3);
  CHECK(object["energy"]["worst"] == 0.5);
  CHECK(object["momenta"][0]["name"] == "phi");
  CHECK(object["conserved"][0]["text"] == "p(phi)");
  CHECK(object["conserved"][0]["unit"] == "kg*m^2/s");
  CHECK(object["conserved"][0]["start"] == 3);
  CHECK(object["conserved"][0]["drift"] == 1.5e-12);
}

TEST_CASE("a plot is XML with a panel for each name, and a curve for each of its columns") {
  const std::string svg = to_svg(seven_columns());
  tinyxml2::XMLDocument document;
  REQUIRE(document.Parse(svg.c_str()) == tinyxml2::XML_SUCCESS);
  CHECK(count(svg, "font-weight") == 1 + 4);
  CHECK(count(svg, "<path") == 5);
  CHECK(mentions(svg, ">ϕ [rad]<"));
  CHECK(mentions(svg, ">x&lt;y [kg m²]<"));
  CHECK_FALSE(mentions(svg, "ϕ\u0307"));
  CHECK_FALSE(mentions(svg, "nan"));
}

TEST_CASE("a plot has the title or name of the model, and its method and steps") {
  Trajectory trajectory = two_columns();
  CHECK(mentions(to_svg(trajectory), "font-weight=\"bold\">top</text>"));
  CHECK(mentions(to_svg(trajectory), ">top by rk4: 0 steps to t = 1 s<"));
  trajectory.title = "Top & table";
  CHECK(mentions(to_svg(trajectory), "font-weight=\"bold\">Top &amp; table</text>"));
  CHECK(mentions(to_svg(trajectory), ">top by rk4: 0 steps to t = 1 s<"));
}

TEST_CASE("the energy panel shows E - E0, with one digit more than distinguishes its ticks") {
  const std::string svg = to_svg(seven_columns());
  CHECK(mentions(svg, ">E − E₀ [J]<"));
  CHECK(mentions(svg, ">2.00e-09<"));
  CHECK(mentions(svg, ">1.00e-08<"));
  // The curve fills its panel from corner to corner, except for the margins.
  const std::size_t path = svg.rfind("<path");
  CHECK(mentions(svg.substr(path), "d=\"M92.0 579.9"));
  CHECK(mentions(svg.substr(path), "L712.0 478.1\""));
}

TEST_CASE("work is subtracted from the plotted energy") {
  Trajectory trajectory = seven_columns();
  trajectory.columns.back().panel = "E − E₀ − work";
  for (auto& row : trajectory.rows) {
    row.back() = 3 + row.front();
    trajectory.work.push_back(row.front());
  }
  const std::string svg = to_svg(trajectory);
  CHECK(mentions(svg, ">E − E₀ − work [J]<"));
  const std::size_t path = svg.rfind("<path");
  CHECK(mentions(svg.substr(path), "d=\"M92.0 529.0"));
  CHECK(mentions(svg.substr(path), "L712.0 529.0\""));
}

TEST_CASE("rounding errors are plotted as a flat line") {
  Trajectory trajectory;
  trajectory.energy.scale = 1;
  trajectory.columns = {{"t", "s", ""},
                        {"x", "m", "x"},
                        {"z", "m", "z"},
                        {"y", "m", "y"},
                        {"E", "J", "E − E₀", true}};
  trajectory.rows = {{0, 0, 0, 5, 3}, {1, 1, 3e-17, 5 + 1e-10, 3 + 4.5e-16}};
  const std::string svg = to_svg(trajectory);
  CHECK(mentions(svg, "d=\"M92.0 253.0L712.0 253.0\""));
  CHECK(mentions(svg, "d=\"M92.0 391.0L712.0 391.0\""));
  CHECK(mentions(svg, "d=\"M92.0 529.0L712.0 529.0\""));
  CHECK(mentions(svg, ">5.00e-13<"));
  trajectory.energy.scale = 1e-6;
  CHECK_FALSE(mentions(to_svg(trajectory), "d=\"M92.0 529.0L712.0 529.0\""));
}

TEST_CASE("the path of a point has equal scales and a marked start") {
  Trajectory trajectory;
  trajectory.path = "bob";
  trajectory.columns = {{"t", "s", ""},
                        {"q", "rad", "q"},
                        {"x(bob)", "m", "", false, "x(bob)"},
                        {"y(bob)", "m", "", false, "y(bob)"},
                        {"E", "J", "E − E₀", true}};
  trajectory.rows = {{0, 7, 0, -1, 3}, {1, 8, 1, -1.5, 3}, {2, 9, 2, -1, 3}};
  const std::string svg = to_svg(trajectory);
  tinyxml2::XMLDocument document;
  REQUIRE(document.Parse(svg.c_str()) == tinyxml2::XML_SUCCESS);
  CHECK(count(svg, "<path") == 1);
  CHECK(mentions(svg, "d=\"M115.0 298.2L402.0 441.8L689.0 298.2\""));
  CHECK(mentions(svg, "<circle cx=\"115.0\" cy=\"298.2\""));
  CHECK(mentions(svg, ">start<"));
  CHECK(mentions(svg, ">x(bob) [m]<"));
  CHECK(mentions(svg, ">y(bob) [m]<"));
  CHECK_FALSE(mentions(svg, "t [s]"));
}

TEST_CASE("the path of a point at rest or along an axis is drawn too") {
  Trajectory trajectory;
  trajectory.path = "bob";
  trajectory.columns = {
      {"t", "s", ""}, {"x(bob)", "", ""}, {"y(bob)", "", ""}, {"E", "", "E − E₀", true}};
  trajectory.rows = {{0, 0, 0, 3}, {1, 0, 0, 3}};
  CHECK(mentions(to_svg(trajectory), "d=\"M402.0 370.0L402.0 370.0\""));
  trajectory.rows = {{0, 3, -1, 3}, {1, 3, 1, 3}};
  CHECK(mentions(to_svg(trajectory), "d=\"M402.0 657.0L402.0 83.0\""));
}

TEST_CASE("labels distinguish ticks, however close they are") {
  Trajectory trajectory;
  trajectory.columns = {{"t", "s", ""}, {"x", "m", "x"}};
  trajectory.rows = {{0, 1}, {1, 1 + 1e-7}};
  const std::string svg = to_svg(trajectory);
  CHECK(mentions(svg, ">1.00000002<"));
  CHECK(mentions(svg, ">1.00000004<"));
}

TEST_CASE("curves of a panel differ in their dashes, and wrapped angles are interrupted") {
  const std::string svg = to_svg(seven_columns());
  CHECK(count(svg, "stroke-dasharray=\"none\"") == 4);
  CHECK(count(svg, "stroke-dasharray=\"9 4\"") == 1);
  CHECK(mentions(svg, ">e: e₀ solid, eₓ dashed<"));
  const std::size_t path = svg.find("<path");
  const std::string first = svg.substr(path, svg.find("/>", path) - path);
  CHECK(count(first, "M") == 3);
}
