#include <catch2/catch.hpp>

#include "choose/chosen.hpp"
#include "render/small_sheet.hpp"
#include "support/frame_systems.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;
using elgen::testing::has;

TEST_CASE("terms that are zero, or that a model cannot have, are left out") {
  const Chosen c = chosen(cart_pole_text());
  const EquationOfMotion equation = equation_of_motion(c.checked.model, c.choice.program);
  CHECK(equation.text == "M(q) a + C(q,v) v + g(q) = B(q) u");
  CHECK(equation.latex == "M(q) \\ddot{q} + C(q, \\dot{q}) \\dot{q} + g(q) = B(q) u");
}

TEST_CASE("where nothing moves, the equation is that at rest") {
  Chosen c = chosen(cart_pole_text());
  auto& functions = c.choice.program.functions;
  const auto moves = [](const Function& f) { return f.kind != OutputKind::gravity; };
  functions.erase(std::remove_if(functions.begin(), functions.end(), moves), functions.end());
  CHECK(equation_of_motion(c.checked.model, c.choice.program).text == "g(q) = B(q) u");
  c.checked.model.may_drift = true;
  CHECK(equation_of_motion(c.checked.model, c.choice.program).text == "drift(q,0) + g(q) = B(q) u");
}

TEST_CASE("where rotations turn the rates are v") {
  const Chosen c = chosen(tumbler_text());
  CHECK(equation_of_motion(c.checked.model, c.choice.program).latex ==
        "M(q) a + C(q, v) v = B(q) u");
}

TEST_CASE("explicit time is an argument") {
  const Chosen c = chosen(everything_text());
  CHECK(has(equation_of_motion(c.checked.model, c.choice.program).text, "M(q,t) a"));
}
