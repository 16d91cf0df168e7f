// States between binary arguments, exact numbers and text.
#include "evaluate/subject.hpp"

#include <catch2/catch.hpp>

#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("arguments survive the way to an exact state and back") {
  const System system = cart_pole_system();
  Arguments<double> arguments = arguments_at<double>(nominal_state(system.model, system.scene));
  arguments.q = {0.1, -1e300};
  arguments.v = {5e-324, 2};
  arguments.t = 0.3;
  const Arguments<double> back = arguments_at<double>(exact_state(system.subject(), arguments));
  CHECK(back.q == arguments.q);
  CHECK(back.v == arguments.v);
  CHECK(back.parameters == arguments.parameters);
  CHECK(back.t == arguments.t);
}

TEST_CASE("fixed parameters stay the exact decimals they are") {
  System system = cart_pole_system();
  system.scene.specialisation.fixed[1] = {cln::cl_R("1/10")};
  const auto arguments = arguments_at<double>(nominal_state(system.model, system.scene));
  const State state = exact_state(system.subject(), arguments);
  CHECK(state.parameters[1] == cln::cl_R("1/10"));
  CHECK(state.parameters[3] != cln::cl_R("981/100"));
}

TEST_CASE("states are described by what varies") {
  const System system = cart_pole_system();
  State state = nominal_state(system.model, system.scene);
  state.q = {cln::cl_R("1/2"), cln::cl_R("-1/3")};
  CHECK(describe(system.subject(), state) ==
        "q = (0.5, -0.333333), v = (0, 0), a = (0, 0), u = (0)");
  state.parameters[0] = 1000;
  CHECK(describe(system.subject(), state) ==
        "q = (0.5, -0.333333), v = (0, 0), a = (0, 0), u = (0), M = 1000");
}

TEST_CASE("long states are cut") {
  System system;
  system.model = chain(9).model;
  CHECK(describe(system.subject(), nominal_state(system.model, {})) ==
        "q = (0, 0, 0, 0, 0, 0, 0, 0, …), v = (0, 0, 0, 0, 0, 0, 0, 0, …), "
        "a = (0, 0, 0, 0, 0, 0, 0, 0, …)");
}

TEST_CASE("numbers beyond double are written too") {
  CHECK(short_text(cln::cl_R("0")) == "0");
  CHECK(short_text(cln::cl_R("22/7")) == "3.14286");
  CHECK(short_text(cln::expt(cln::cl_RA(10), 400) * 3 / 2).find("e400") != std::string::npos);
  // As a fraction this has 10^12 digits.
  const cln::cl_R absurd = cln::scale_float(cln::cl_float(1, cln::float_format(60)), 1L << 42);
  CHECK(short_text(absurd) == "4.21e1323943922167");
}

TEST_CASE("functions are found by kind") {
  const System system = cart_pole_system();
  REQUIRE(find_function(system.program, OutputKind::gravity) != nullptr);
  CHECK(find_function(system.program, OutputKind::gravity)->name == "gravity");
  CHECK(find_function(system.program, OutputKind::user_value, 1) == nullptr);
}

TEST_CASE("numbers are there where all of them are defined") {
  CHECK(defined_values({Real(1), Real(2)})->size() == 2);
  CHECK(defined_values({Real(1), Real::undefined()}) == std::nullopt);
}
