// Values that a projection of each field confirms.
#include "verify/bounds/confirmed_values.hpp"

#include <catch2/catch.hpp>

#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::optional<std::vector<cln::cl_R>> confirmed(const System& system, std::size_t function,
                                                const State& state) {
  const ExactRun run = run_exactly(system.program, system.program.functions[function], state,
                                   rounding_constants<double>());
  return confirmed_values(system.subject(), function, state, run);
}

/// V = 0, and a program with instruction `value` of `body` as V.
System weightless(const std::string& body, const std::string& value) {
  ModelBuilder b;
  b.coordinate("th").parameter("m", "1");
  return system_of(b.T("m*th_d^2/2").V("0").model,
                   "parameters m\ncoordinates th\n" +
                       function_text("potential_energy", body, "  result 1 1 = " + value + "\n"));
}

}  // namespace

TEST_CASE("values of right functions are the oracle's, wrong functions have none") {
  const System system = cart_pole_system();
  const State state = random_state(system.model, 4);
  for (std::size_t k = 0; k < system.program.functions.size(); ++k) {
    const Function& function = system.program.functions[k];
    if (output_row(function.kind).is_summary) continue;
    INFO(function.name);
    const auto found = confirmed(system, k, state);
    const OracleValues expected =
        oracle_values(system.model, {.kind = function.kind, .user = function.user}, state);
    REQUIRE(found);
    REQUIRE(expected);
    REQUIRE(found->size() == expected->size());
    for (std::size_t i = 0; i < found->size(); ++i) {
      CHECK(agree((*found)[i], (*expected)[i], 40, 1));
    }
  }
  CHECK_FALSE(confirmed(with_mistake("mass_matrix", "= 10 11 11 12", "= 10 11 9 12"), 0, state));
}

TEST_CASE("a value of rounding errors is 0, and a small value is not confirmed") {
  const std::string squares =
      "  0 = coordinate th\n  1 = sin 0\n  2 = cos 0\n  3 = multiply 1 1\n"
      "  4 = multiply 2 2\n  5 = add 3 4\n  6 = constant 1\n  7 = subtract 5 6\n";
  const System zero = weightless(squares, "7");
  const State state = random_state(zero.model, 5);
  const auto found = confirmed(zero, 0, state);
  REQUIRE(found);
  CHECK(found->front() == 0);
  const System small = weightless(
      "  0 = coordinate th\n  1 = constant 1\n  2 = add 0 1\n"
      "  3 = constant 1/1000000000000000000000000000000000000000000000000000000000000\n"
      "  4 = add 2 3\n  5 = subtract 4 2\n",
      "5");
  CHECK_FALSE(confirmed(small, 0, state));
}

TEST_CASE("a state outside the domain has no values") {
  const System system = system_of(pendulum().V("sqrt(-1 - th^2)").model,
                                  "parameters m l g\ncoordinates th\nfunction potential_energy\n"
                                  "  0 = constant 1\n  result 1 1 = 0\n");
  CHECK_FALSE(confirmed(system, 0, nominal_state(system.model, {})));
}
