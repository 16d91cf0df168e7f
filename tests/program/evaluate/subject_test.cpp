// Conversion of states between binary arguments, exact numbers and text, and the effect of rounding
// the arguments.
#include "program/evaluate/subject.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

#include "accuracy/conditioning.hpp"
#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// The conditioning K of the first entry of a program's first function; infinite if undefined.
double conditioning(const std::string& text, const State& state,
                    std::vector<bool> parameters = {}) {
  const Program program = read_program(text);
  const Function& function = program.functions.front();
  const auto arguments = map_leaves([](const cln::cl_R& x) { return Real(x); }, state);
  const Conditioning all(program, function, evaluate_instructions(program, function, arguments),
                         std::move(parameters));
  const Real k = all.absolute_condition(function.fields[0].entries[0]);
  return k.is_defined() ? to_double(k.value()) : std::numeric_limits<double>::infinity();
}

State at(double m, double x, double y) {
  State state;
  state.parameters = {exact_value(m)};
  state.q = {exact_value(x), exact_value(y)};
  return state;
}

const std::string head =
    "parameters m\ncoordinates x y\nfunction bias\n  0 = parameter m\n  1 = coordinate x\n"
    "  2 = coordinate y\n";

}  // namespace

TEST_CASE("arguments converted to an exact state and back are unchanged") {
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

TEST_CASE("fixed parameters keep their exact decimals") {
  System system = cart_pole_system();
  system.scene.specialisation.fixed[1] = {cln::cl_R("1/10")};
  const auto arguments = arguments_at<double>(nominal_state(system.model, system.scene));
  const State state = exact_state(system.subject(), arguments);
  CHECK(state.parameters[1] == cln::cl_R("1/10"));
  CHECK(state.parameters[3] != cln::cl_R("981/100"));
}

TEST_CASE("a state is described by its variables and changed parameters") {
  const System system = cart_pole_system();
  State state = nominal_state(system.model, system.scene);
  state.q = {cln::cl_R("1/2"), cln::cl_R("-1/3")};
  CHECK(describe_state(system.subject(), state) ==
        "q = (0.5, -0.333333), v = (0, 0), a = (0, 0), u = (0)");
  state.parameters[0] = 1000;
  CHECK(describe_state(system.subject(), state) ==
        "q = (0.5, -0.333333), v = (0, 0), a = (0, 0), u = (0), M = 1000");
}

TEST_CASE("long states are abbreviated") {
  System system;
  system.model = chain(9).model;
  CHECK(describe_state(system.subject(), nominal_state(system.model, {})) ==
        "q = (0, 0, 0, 0, 0, 0, 0, 0, …), v = (0, 0, 0, 0, 0, 0, 0, 0, …), "
        "a = (0, 0, 0, 0, 0, 0, 0, 0, …)");
}

TEST_CASE("numbers beyond double are printed too") {
  CHECK(short_number_text(cln::cl_R("0")) == "0");
  CHECK(short_number_text(cln::cl_R("22/7")) == "3.14286");
  CHECK(mentions(short_number_text(cln::expt(cln::cl_RA(10), 400) * 3 / 2), "e400"));
  // As a fraction, this number has 10^12 digits.
  const cln::cl_R absurd = cln::scale_float(cln::cl_float(1, cln::float_format(60)), 1L << 42);
  CHECK(short_number_text(absurd) == "4.21e1323943922167");
}

TEST_CASE("functions are found by kind") {
  const System system = cart_pole_system();
  REQUIRE(find_function(system.program, OutputKind::gravity) != nullptr);
  CHECK(find_function(system.program, OutputKind::gravity)->name == "gravity");
  CHECK(find_function(system.program, OutputKind::user_value, 1) == nullptr);
}

TEST_CASE("values exist only if all entries are defined") {
  CHECK(to_oracle_values({Real(1), Real(2)})->size() == 2);
  CHECK(to_oracle_values({Real(1), Real::undefined()}) == std::nullopt);
}

TEST_CASE("m (x - y): each input contributes, despite cancellation") {
  const std::string text = head + "  3 = subtract 1 2\n  4 = multiply 0 3\n  result 1 1 = 4\n";
  CHECK(conditioning(text, at(2, 3, 2.5)) == Approx(2 * 0.5 + 2 * 3 + 2 * 2.5));
}

TEST_CASE("contributions of one input are added before the absolute value") {
  const std::string text =
      head + "  3 = multiply 1 1\n  4 = multiply 0 1\n  5 = subtract 3 4\n  result 1 1 = 5\n";
  CHECK(conditioning(text, at(3, 2, 0)) == Approx(2 * (2 * 2 - 3) + 3 * 2));
}

TEST_CASE("functions, quotients and roots contribute by their slopes") {
  const std::string text =
      head +
      "  3 = sin 1\n  4 = divide 3 2\n  5 = square_root 0\n  6 = multiply 4 5\n"
      "  result 1 1 = 6\n";
  const double x = std::sin(0.5) / 4 * 3;
  CHECK(conditioning(text, at(9, 0.5, 4)) == Approx(x / 2 + x + 0.5 * std::cos(0.5) / 4 * 3));
}

TEST_CASE("literals do not contribute, but constants from a fixed parameter do") {
  const std::string text = head +
                           "  3 = constant 1/10\n  4 = constant 3\n  5 = constant 2\n"
                           "  6 = multiply 3 4\n  7 = multiply 6 5\n  result 1 1 = 7\n";
  CHECK(conditioning(text, at(1, 1, 1)) == 0);
  CHECK(conditioning(text, at(1, 1, 1), {true, false, false}) == Approx(0.6));
  CHECK(conditioning(text, at(1, 1, 1), {true, true, false}) == Approx(1.2));
}

TEST_CASE("K is accurate if doubles cancel, underflow or overflow") {
  // (1e20 x + x) - 1e20 x has the derivative (1e20 + 1) - 1e20 = 1, which doubles compute as 0.
  const std::string cancelling = head +
                                 "  3 = constant 100000000000000000000\n  4 = multiply 3 1\n"
                                 "  5 = add 4 1\n  6 = subtract 5 4\n  result 1 1 = 6\n";
  CHECK(conditioning(cancelling, at(1, 0.5, 0)) == Approx(0.5));
  const std::string vanishing = head +
                                "  3 = multiply 1 2\n  4 = multiply 3 3\n"
                                "  5 = multiply 4 0\n  result 1 1 = 5\n";
  CHECK(conditioning(vanishing, at(1e300, 1e-100, 1e-100)) == Approx(5e-100));
  CHECK(conditioning(vanishing, at(1e-300, 1e100, 1e100)) == Approx(5e100));
}

TEST_CASE("K is infinite if a derivative is undefined") {
  const std::string text = head + "  3 = square_root 1\n  result 1 1 = 3\n";
  CHECK(std::isinf(conditioning(text, at(1, 0, 0))));
}
