// Variables on a few lines: names with units, rates where something moves.
#include <catch2/catch.hpp>

#include "choose/chosen.hpp"
#include "elgen/render.hpp"
#include "support/frame_systems.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

using Lines = std::vector<std::string>;

Lines lines_of(const std::string& text, const SceneOptions& options = {}) {
  const Chosen c = chosen(text, options);
  return variable_lines(c.checked.model, c.choice.program);
}

}  // namespace

TEST_CASE("coordinates, velocities as their rates, inputs") {
  CHECK(lines_of(cart_pole_text()) == Lines{"q = (x, theta)", "v = dq/dt, a = dv/dt", "u = (u)"});
}

TEST_CASE("many names are the first two and the last") {
  const Chosen c = chosen(cart_pole_text());
  Model model = c.checked.model;
  for (int i = 0; i < 20; ++i) model.coordinates.push_back(model.coordinates[1]);
  CHECK(variable_lines(model, c.choice.program).front() == "q = (x, theta, ..., theta)");
}

TEST_CASE("where no function knows of motion all is at rest") {
  SceneOptions options;
  options.outputs = {make_source("command line", "gravity")};
  CHECK(lines_of(cart_pole_text(), options).at(1) == "at rest");
}

TEST_CASE("velocities that are no rates have names") {
  const Lines lines = lines_of(tumbler_text());
  REQUIRE(lines.size() >= 3);
  CHECK(lines[1].rfind("v = (", 0) == 0);
  CHECK(lines[2] == "dq/dt = N(q) v: coordinate_rates");
}
