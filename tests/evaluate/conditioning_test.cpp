// K = sum |z dx/dz|: what the inputs' own rounding costs.
#include "evaluate/conditioning.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// Of the first entry of a program's first function.
double conditioning(const std::string& text, const State& state,
                    Literals literals = Literals::not_binary) {
  const Program program = program_of(text);
  const Function& function = program.functions.front();
  const auto arguments = map_leaves([](const cln::cl_R& x) { return Real(x); }, state);
  const Conditioning all(program, function, evaluate_instructions(program, function, arguments),
                         rounding<double>(), literals);
  const Real k = all.of(function.fields[0].entries[0]);
  return k.is_defined() ? ScalarTraits<double>::from_real(k.value())
                        : std::numeric_limits<double>::infinity();
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

TEST_CASE("m (x - y): each input counts, however much cancels") {
  const std::string text = head + "  3 = subtract 1 2\n  4 = multiply 0 3\n  result 1 1 = 4\n";
  CHECK(conditioning(text, at(2, 3, 2.5)) == Approx(2 * 0.5 + 2 * 3 + 2 * 2.5));
}

TEST_CASE("uses of one input are added before their magnitude is taken") {
  const std::string text =
      head + "  3 = multiply 1 1\n  4 = multiply 0 1\n  5 = subtract 3 4\n  result 1 1 = 5\n";
  CHECK(conditioning(text, at(3, 2, 0)) == Approx(2 * (2 * 2 - 3) + 3 * 2));
}

TEST_CASE("functions count by their slopes, quotients and roots too") {
  const std::string text =
      head +
      "  3 = sin 1\n  4 = divide 3 2\n  5 = square_root 0\n  6 = multiply 4 5\n"
      "  result 1 1 = 6\n";
  const double x = std::sin(0.5) / 4 * 3;
  CHECK(conditioning(text, at(9, 0.5, 4)) == Approx(x / 2 + x + 0.5 * std::cos(0.5) / 4 * 3));
}

TEST_CASE("literals that are not binary are rounded, and all of them where parameters are fixed") {
  const std::string text = head +
                           "  3 = constant 1/10\n  4 = constant 3\n  5 = constant 2\n"
                           "  6 = multiply 3 4\n  7 = multiply 6 5\n  result 1 1 = 7\n";
  CHECK(conditioning(text, at(1, 1, 1)) == Approx(0.6));
  CHECK(conditioning(text, at(1, 1, 1), Literals::all) == Approx(1.2));
}

TEST_CASE("K is undefined where a slope is") {
  const std::string text = head + "  3 = square_root 1\n  result 1 1 = 3\n";
  CHECK(std::isinf(conditioning(text, at(1, 0, 0))));
}
