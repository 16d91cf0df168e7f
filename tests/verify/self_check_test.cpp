// The check before every write: correct programs pass, and every kind of mistake is named.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "elgen/certificate.hpp"
#include "verify/bounds/projection.hpp"
#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

SelfCheck check(const System& system) {
  return self_check(system.model, system.scene, system.program);
}

/// Cart and pole; entries 0 and 1 of M rely on sampled zeros, in `mass_matrix` and in `dynamics`.
System with_sampled_zeros() {
  System system = cart_pole_system();
  for (Function& function : system.program.functions) {
    const bool repeats = function.kind == OutputKind::dynamics;
    if (repeats || function.kind == OutputKind::mass_matrix) function.sampled_zeros = {0, 1};
  }
  return system;
}

}  // namespace

TEST_CASE("a correct short program passes at 32 states") {
  const SelfCheck result = check(cart_pole_system());
  CHECK(result.failure.empty());
  CHECK(result.states == 32);
  REQUIRE(result.digits_lost);
  CHECK(*result.digits_lost <= 0.5);
}

TEST_CASE("a mistake in any function is found, and the function is named") {
  for (const auto& [function, from, to] :
       {std::tuple{"mass_matrix", "= 10 11 11 12", "= 10 11 9 12"},
        std::tuple{"coriolis_matrix", "= 17 18 17 17", "= 17 16 17 17"},
        std::tuple{"velocity_force", "= 19 17", "= 18 17"},
        std::tuple{"gravity", "= 16 15", "= 16 14"},
        std::tuple{"potential_energy", "= 13", "= 11"},
        std::tuple{"drift", "= 13 13", "= 13 0"},
        std::tuple{"dissipation", "= 20 17", "= 17 20"},
        std::tuple{"bias", "23 = add 19 20", "23 = subtract 19 20"},
        std::tuple{"momentum", "29 = add 27 28", "29 = subtract 27 28"},
        std::tuple{"kinetic_energy", "34 = multiply 33 32", "34 = add 33 32"},
        std::tuple{"total_energy", "36 = add 34 35", "36 = subtract 34 35"},
        std::tuple{"energy_function", "36 = add 34 35", "36 = subtract 34 35"},
        std::tuple{"input_matrix", "= 14 13", "= 13 14"},
        std::tuple{"inverse_dynamics", "33 = add 32 22", "33 = add 32 21"},
        std::tuple{"forward_dynamics", "25 = subtract 24 23", "25 = add 24 23"},
        std::tuple{"forward_dynamics", "36 = divide 28 12", "36 = divide 28 10"},
        std::tuple{"tip", "= 14 15", "= 15 14"},
        std::tuple{"tip_jacobian", "= 13 15 14 17", "= 13 15 14 16"},
        std::tuple{"tip_bias", "= 17 19", "= 17 18"},
        std::tuple{"dynamics", "= 23 22", "= 23 21"}}) {
    INFO(function);
    const SelfCheck result = check(with_mistake(function, from, to));
    CHECK(result.failure.find("`" + std::string(function) + "`: ") == 0);
    CHECK(mentions(result.failure, "q = ("));
    CHECK(result.states == 1);
  }
}

TEST_CASE("a large rounding error is a figure of the receipt and no failure") {
  const SelfCheck result = check(badly_rounded());
  INFO(result.failure);
  CHECK(result.failure.empty());
  REQUIRE(result.digits_lost);
  CHECK(*result.digits_lost > 3);
}

TEST_CASE("every field of an output is compared") {
  CHECK(check(system_of(oscillator_model(), oscillator_program())).failure.empty());
  for (const auto& [what, from, to] :
       {std::tuple{"w.M (X y) of A", "A 2 2 = 3 4 7 9", "A 2 2 = 3 4 7 8"},
        std::tuple{"w.X y of A", "A 2 2 = 3 4 7 9", "A 2 2 = 4 4 7 9"},
        std::tuple{"w.M (X y) of B", "B 2 1 = 3 5", "B 2 1 = 3 3"},
        std::tuple{"w.X y of B", "B 2 1 = 3 5", "B 2 1 = 5 5"},
        std::tuple{"w.X y of by_position", "1 1 = 2", "1 1 = 3"},
        std::tuple{"w.X y of by_velocity", "1 1 = 1", "1 1 = 2"},
        std::tuple{"w.M (X y) of by_position", "1 1 = 7", "1 1 = 6"},
        std::tuple{"w.M (X y) of by_velocity", "1 1 = 9", "1 1 = 8"},
        std::tuple{"w.M (X y) of by_input", "1 1 = 5", "1 1 = 4"}}) {
    INFO(to);
    const System wrong = system_of(oscillator_model(), replaced(oscillator_program(), from, to));
    CHECK(mentions(check(wrong).failure, fmt::format("{} is ", what)));
  }
}

TEST_CASE("an entry that is undefined where the oracle has a value is a mistake") {
  for (const auto& [function, from, to, what] :
       {std::tuple{"mass_matrix", "result 2 2 = 10 11 11 12",
                   "13 = constant 0\n  14 = divide 12 13\n  result 2 2 = 10 11 11 14",
                   "w.X y is undefined"},
        std::tuple{"gravity", "15 = negate 14\n  16 = constant 0\n",
                   "15 = constant 0\n  16 = divide 14 15\n", "w.x is undefined"},
        std::tuple{"forward_dynamics", "31 = divide 30 28", "31 = divide 30 17",
                   "an acceleration is undefined"},
        std::tuple{"dynamics", "21 = multiply 15 3", "21 = divide 15 17",
                   " in the function of the same name"}}) {
    INFO(function);
    const SelfCheck result = check(with_mistake(function, from, to));
    CHECK(mentions(result.failure, what));
  }
}

TEST_CASE("a model without a value at any state does not pass") {
  const System system = system_of(pendulum().V("sqrt(-1 - th^2)").model,
                                  "parameters m l g\ncoordinates th\nfunction bias\n"
                                  "  0 = constant -1\n  1 = square_root 0\n  result 1 1 = 1\n");
  const SelfCheck result = check(system);
  CHECK(result.failure.find("`bias` has no value at any of 256 states, nor has `") == 0);
  CHECK(result.has_undefined_output);
  CHECK(result.states == 0);
  CHECK(result.undefined_states == 256);
}

TEST_CASE("an output without a value is found beside outputs that have one") {
  const char* mass =
      "parameters m l g\ncoordinates th\nfunction mass_matrix\n  0 = parameter m\n"
      "  1 = parameter l\n  2 = multiply 1 1\n  3 = multiply 0 2\n  result 1 1 = 3\n";
  const char* root = "function gravity\n  0 = constant -1\n  1 = square_root 0\n  result 1 1 = 1\n";
  const System system = system_of(pendulum().V("sqrt(-1 - th^2)").model, std::string(mass) + root);
  const SelfCheck result = check(system);
  CHECK(result.failure.find("`gravity` has no value") == 0);
  CHECK(result.has_undefined_output);
}

TEST_CASE("states in a narrow domain are searched for, and states outside it are counted") {
  const char* text =
      "parameters m l g\ncoordinates th\nfunction potential_energy\n"
      "  0 = coordinate th\n  1 = constant 3\n  2 = subtract 0 1\n  3 = square_root 2\n"
      "  result 1 1 = 3\n";
  ModelBuilder b;
  b.coordinate("th").parameter("m", "1").parameter("l", "1").parameter("g", "1");
  const System system = system_of(b.T("th_d^2").V("sqrt(th - 3)").model, text);
  const SelfCheck result = check(system);
  CHECK(result.failure.empty());
  CHECK(result.states >= 1);
  CHECK(result.undefined_states >= 1);
}

TEST_CASE("the receipt and the certificate report zeros that are not proved") {
  CHECK(check(cart_pole_system()).sampled_zeros == 0);
  const System system = with_sampled_zeros();
  const std::string text = self_check_text(check(system));
  CHECK(mentions(text,
                 "; 2 entries rely on zeros sampled at 64 points, not proved: `elgen verify -v` "
                 "names them and compares them at more states"));
  CHECK(mentions(self_check_text({2, 1.0, "", 1}), "; 1 entry relies on zeros"));
  std::vector<CertificateRow> rows =
      verify(system.model, system.scene, system.program, {}, {1, true, 1}).certificate.rows;
  std::erase_if(rows, [](const CertificateRow& row) { return row.evidence != Evidence::zeros; });
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].subject == "mass_matrix");
  CHECK(rows[0].samples == 64);
  CHECK(rows[0].worst_value == "in entries 1, 2");
}

/// V = exp(factor th), th in [-1, 1].
System exponential(const std::string& factor) {
  ModelBuilder b;
  b.coordinate("th").parameter("m", "1").parameter("l", "1").parameter("g", "1");
  return system_of(b.T("th_d^2").V("exp(" + factor + "*th)").model,
                   "parameters m l g\ncoordinates th\nfunction potential_energy\n  0 = constant " +
                       factor +
                       "\n  1 = coordinate th\n  2 = multiply 0 1\n  3 = exp 2\n"
                       "  result 1 1 = 3\n");
}

TEST_CASE("states inside the ranges whose values overflow are counted and reported") {
  const SelfCheck overflows = check(exponential("1000"));
  INFO(overflows.failure);
  CHECK(overflows.failure.empty());
  CHECK(overflows.overflowing_states > 0);
  CHECK(overflows.overflowing_states < overflows.states_in_ranges);
  CHECK(mentions(self_check_text(overflows),
                 fmt::format("; not finite in double at {} of {} states inside the "
                             "ranges",
                             overflows.overflowing_states, overflows.states_in_ranges)));
  const SelfCheck finite = check(exponential("100"));
  CHECK(finite.states_in_ranges > 0);
  CHECK(finite.overflowing_states == 0);
  CHECK_FALSE(mentions(self_check_text(finite), "finite"));
}

TEST_CASE("the certificate counts skipped states inside the ranges") {
  const auto text = [](const System& system) {
    return to_text(
        verify(system.model, system.scene, system.program, {}, {16, true, 1}).certificate);
  };
  CHECK(mentions(text(exponential("1000")), " inside the ranges skipped"));
  CHECK_FALSE(mentions(text(exponential("100")), "inside the ranges skipped"));
}

TEST_CASE("a program without functions passes") {
  CHECK(check(system_of(pendulum().model, "")).failure.empty());
}

TEST_CASE("the receipt states what was checked and what was found") {
  CHECK(self_check_text({32, 0.42, "", 0}) ==
        "compared with 60-digit arithmetic at 32 states; at most 0.4 digits lost");
  CHECK(self_check_text({1, 0.04, "", 0}) ==
        "compared with 60-digit arithmetic at 1 state; no digit lost");
  CHECK(self_check_text({2, {}, "", 0}) == "compared with 60-digit arithmetic at 2 states");
  CHECK(self_check_text({30, 0.42, "", 0, 4}) ==
        "compared with 60-digit arithmetic at 30 states; at most 0.4 digits lost; 4 outside the "
        "domain");
  CHECK(self_check_text({.states = 32, .states_in_ranges = 20, .overflowing_states = 2}) ==
        "compared with 60-digit arithmetic at 32 states");
  CHECK(self_check_text({.states = 32, .states_in_ranges = 20, .overflowing_states = 3}) ==
        "compared with 60-digit arithmetic at 32 states; not finite in double at 3 of 20 states "
        "inside the ranges");
}

TEST_CASE("pivots are compared with M from inverse dynamics, and from the energies without it") {
  System system = masses_in_a_row(6);
  const std::vector<OutputRequest> requests = outputs_for_self_check(system.model, system.program);
  REQUIRE(requests.size() == 1);
  CHECK(requests[0].kind == OutputKind::inverse_dynamics);
  CHECK(outputs_for_self_check(system.model, forces_of_masses(6)).empty());
  const System few = masses_in_a_row(4);
  CHECK(outputs_for_self_check(few.model, few.program).empty());
  const auto failure = [&](const Program& unrequested) {
    return self_check(system.model, system.scene, system.program, unrequested).failure;
  };
  CHECK(failure(forces_of_masses(6)).empty());
  CHECK(failure(forces_of_masses(6, true)).empty());
  CHECK(failure({}).empty());
  system.program.functions[0].fields[1].entries[5] = 0;  // the last pivot is 0
  for (const Program& program : {forces_of_masses(6), forces_of_masses(6, true), Program()}) {
    CHECK(failure(program).find("`forward_dynamics`: a relative pivot is 0, the oracle says 1") ==
          0);
  }
}

TEST_CASE("one state is enough for the pivots of more than 20 velocities") {
  for (const int n : {20, 21}) {
    const System system = masses_in_a_row(n);
    const auto places = field_places(system.subject());
    REQUIRE(places.size() == 2);
    CHECK_FALSE(is_projected_once(places[0], system.model));
    CHECK(is_projected_once(places[1], system.model) == (n == 21));
  }
}
