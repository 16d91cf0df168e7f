// A derivation as text and as a sheet.
#include "elgen/steps.hpp"

#include <catch2/catch.hpp>

#include "choose/chosen.hpp"
#include "render/small_sheet.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;
using elgen::testing::has;

namespace {

struct Derivation {
  explicit Derivation(const std::string& text) : checked(checked_model(text)) {
    const auto derived = derive_steps(*formulate(checked.model));
    const auto recursive = lower(derived->equations, derived->requests, {});
    steps.program = choose(*recursive, present(*recursive), {})->program;
    steps.masses.assign(derived->masses.size(), "mass");
  }

  CheckedModel checked;
  ReadableSteps steps;
};

}  // namespace

TEST_CASE("the order of a textbook") {
  const Derivation d(cart_pole_text());
  const std::string text = steps_text(d.checked.model, d.steps);
  std::size_t last = 0;
  for (const char* title : {"Positions\n", "\nVelocities\n", "\nEnergies\n", "\nEquation of x\n",
                            "\nEquation of theta\n", "\nEnergy function\n"}) {
    INFO(title);
    const std::size_t at = text.find(title, last);
    REQUIRE(at != std::string::npos);
    last = at;
  }
  CHECK(has(text, "  dL/dtheta = m*l*sin(theta)*(g - dot(x)*dot(theta))\n"));
  CHECK(has(steps_text(d.checked.model, d.steps, energies_title), "  V = m*l*g*cos(theta)\n"));
}

TEST_CASE("dissipation, forces and explicit time are steps of their own") {
  const Derivation d(everything_text());
  const std::string text = steps_text(d.checked.model, d.steps);
  CHECK(has(text, "  dD/d(dot(r)) = "));
  CHECK(has(text, "L holds t, so E is not conserved"));
  CHECK(has(text, "  dL/dt at fixed q and v = "));
}

TEST_CASE("the sheet has one section per step") {
  const Derivation d(cart_pole_text());
  const Sheet sheet = steps_sheet(d.checked.model, d.checked.scene, d.steps);
  REQUIRE(sheet.outputs.size() == 6);
  CHECK(sheet.outputs[0].equations.at(0).rows == 2);
  CHECK(sheet.outputs[4].equations.at(0).left == "\\frac{\\partial L}{\\partial \\dot{\\theta}}");
}
