// Equilibria claimed to be exact are compared with the oracle at other values of the parameters.
#include <cmath>

#include "analyse/formulas.hpp"
#include "analyse/found.hpp"
#include "analyse/searched_range.hpp"
#include "elgen/oracle.hpp"
#include "program/evaluate/subject.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("a free coordinate with a singular start value hides no equilibria") {
  // A particle in polar coordinates without a force: every position is an equilibrium.
  const Analysed free = analyse_model(R"toml(format = 1
[model]
name = "polar"
[[coordinate]]
name = "a"
unit = "m"
[[coordinate]]
name = "b"
unit = "rad"
[parameters]
m = { value = 1, unit = "kg" }
[energy]
T = "m*(dot(a)^2 + dot(b)^2*a^2)/2"
)toml");
  REQUIRE(free.equilibria.points.size() == 1);
  CHECK(free.equilibria.points[0].coordinates[0].is_arbitrary);
  CHECK(free.equilibria.points[0].coordinates[1].is_arbitrary);
}

TEST_CASE("exact equilibria stay equilibria at other values of the parameters") {
  int moved = 0;
  for (const char* const name : {"double_pendulum", "rotating_hoop", "elastic_pendulum", "chain"}) {
    const Analysed found = analyse_model(model_file(name));
    INFO(name);
    for (const RestPoint& point : found.equilibria.points) {
      CHECK(point.is_exact);
      for (int draw = 0; draw < 20; ++draw) {
        State state = point.state;
        for (cln::cl_R& parameter : state.parameters) {
          // Each parameter changes by at most 5 %, so that g/(R*Omega^2) of the hoop stays below 1.
          parameter = parameter * cln::cl_RA(95 + (++moved * 7) % 11) / 100;
        }
        for (std::size_t i = 0; i < state.q.size(); ++i) {
          if (!point.coordinates[i].closed_form) continue;
          const Real place =
              evaluate_form(found.equilibria.forms.algebra, *point.coordinates[i].closed_form,
                            arguments_at<Real>(state));
          REQUIRE(place.is_defined());
          state.q[i] = place.value();
        }
        const OracleValues bias =
            oracle_values(found.checked.model, {.kind = OutputKind::bias}, state);
        REQUIRE(bias);
        for (const cln::cl_R& entry : *bias) {
          CHECK(std::abs(to_double(entry)) < 1e-40);
        }
      }
    }
  }
}

TEST_CASE("an angle is reduced to the first value not below a bound") {
  const Real half = whole_turn() / Real(2);
  for (const auto& [quarters, expected] :
       {std::pair{-2, 2}, std::pair{2, 2}, std::pair{3, 3}, std::pair{1, 5}, std::pair{-9, 3},
        std::pair{6, 2}, std::pair{40, 4}}) {
    INFO(quarters);
    const Real turned = wrap_above(half * Real(quarters) / Real(2), half);
    CHECK(is_near(turned, half * Real(expected) / Real(2)));
  }
  // A value that is below the bound only by a rounding error is not raised by a turn.
  const Real rounding(power_of_ten(-30));
  CHECK(is_near(wrap_above(half - rounding, half), half - rounding));
}
