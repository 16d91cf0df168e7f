// Places of rest that are called exact, at other values of the parameters, by the oracle.
#include <cmath>

#include "analyse/formulas.hpp"
#include "analyse/found.hpp"
#include "elgen/oracle.hpp"
#include "program/evaluate/subject.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("exact places are places at other values of the parameters") {
  int moved = 0;
  for (const char* const name : {"double_pendulum", "rotating_hoop", "elastic_pendulum", "chain"}) {
    const Analysed found = analysed(model_file(name));
    INFO(name);
    for (const RestPoint& point : found.equilibria.points) {
      CHECK(point.is_exact);
      for (int draw = 0; draw < 20; ++draw) {
        State state = point.state;
        for (cln::cl_R& parameter : state.parameters) {
          // Within 5 %, where the hoop's g/(R*Omega^2) stays below 1.
          parameter = parameter * cln::cl_RA(95 + (++moved * 7) % 11) / 100;
        }
        for (std::size_t i = 0; i < state.q.size(); ++i) {
          if (!point.coordinates[i].form) continue;
          const Real place = value_of(found.equilibria.forms.algebra, *point.coordinates[i].form,
                                      arguments_at<Real>(state));
          REQUIRE(place.is_defined());
          state.q[i] = place.value();
        }
        const OracleValues bias =
            oracle_values(found.checked.model, {.kind = OutputKind::bias}, state);
        REQUIRE(bias);
        for (const cln::cl_R& entry : *bias) {
          CHECK(std::abs(ScalarTraits<double>::from_real(entry)) < 1e-40);
        }
      }
    }
  }
}
