// Pivots of an elimination by their closed forms.
#include "choose/closed_pivots.hpp"

#include <catch2/catch.hpp>

#include "choose/chosen.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const std::string double_pendulum = model_text(
    "pair",
    "[[coordinate]]\nname = \"q1\"\nunit = \"rad\"\n[[coordinate]]\nname = \"q2\"\nunit = \"rad\"\n"
    "[parameters]\nm1 = { value = 1, assume = \"positive\" }\n"
    "m2 = { value = 2, assume = \"positive\" }\n[energy]\n"
    "T = \"1/2*m1*dot(q1)^2 + 1/2*m2*((cos(q1)*dot(q1) + cos(q2)*dot(q2))^2"
    " + (sin(q1)*dot(q1) + sin(q2)*dot(q2))^2)\"\nV = \"-(m1 + m2)*cos(q1) - m2*cos(q2)\"\n");

/// Up to the choice of forms.
struct Recursive {
  CheckedModel checked = checked_model(double_pendulum);
  Program program = [this] {
    const auto lagrangian = formulate(checked.model);
    const auto equations = derive(*lagrangian, checked.scene.outputs, {});
    return cancel(*lower(*equations, checked.scene.outputs, {}));
  }();
  ClosedForms forms = present(program);
  ComparisonPoints points = extreme_points(program);

  [[nodiscard]] std::size_t find(OutputKind kind) const {
    std::size_t at = 0;
    while (program.functions[at].kind != kind) ++at;
    return at;
  }
};

}  // namespace

TEST_CASE("a pivot that cancels has a closed form that does not") {
  Recursive r;
  const std::size_t at = r.find(OutputKind::forward_dynamics);
  const Function forward = r.program.functions[at];
  const auto pivots = closed_pivots(r.program, forward, r.forms, r.forms.functions[at], r.points);
  REQUIRE(pivots.size() == 1);
  CHECK(pivots[0].velocity == 1);
  const Function mended = with_closed_pivots(forward, forward, pivots, r.program);
  CHECK(check_invariants({r.program.leaves, r.program.constants, {mended}}).empty());
  const std::vector<double> before = possible_losses(r.program, forward, r.points);
  const std::vector<double> after = possible_losses(r.program, mended, r.points);
  CHECK(before[3] > 1e6);
  CHECK(after[3] == 0);
  CHECK(after[1] < before[1]);
}

TEST_CASE("a function without pivots stays as it is") {
  Recursive r;
  const std::size_t at = r.find(OutputKind::forward_dynamics);
  const Function forward = r.program.functions[at];
  const Function bias = r.program.functions[r.find(OutputKind::bias)];
  const auto pivots = closed_pivots(r.program, forward, r.forms, r.forms.functions[at], r.points);
  CHECK(with_closed_pivots(bias, forward, pivots, r.program).instructions == bias.instructions);
}
