#include "elgen/evaluate.hpp"

#include <catch2/catch.hpp>

#include "program/read_program.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Program every_leaf() {
  return read_program(
      "parameters m\n"
      "coordinates x\n"
      "inputs u\n"
      "time\n"
      "function dynamics\n"
      "  0 = parameter m\n"
      "  1 = coordinate x\n"
      "  2 = velocity x\n"
      "  3 = acceleration x\n"
      "  4 = input u\n"
      "  5 = time\n"
      "  6 = constant 1/4\n"
      "  7 = add 0 1\n"
      "  8 = subtract 2 3\n"
      "  9 = multiply 4 5\n"
      "  10 = divide 7 6\n"
      "  11 = negate 8\n"
      "  12 = square_root 9\n"
      "  result first 1 2 = 10 11\n"
      "  result second 1 1 = 12\n");
}

double call(const std::string& function, double x, double y) {
  const Program program = read_program(
      "coordinates x y\nfunction bias\n  0 = coordinate x\n  1 = coordinate y\n  2 = " + function +
      "\n  result 1 1 = 2\n");
  Arguments<double> arguments;
  arguments.q = {x, y};
  return evaluate(program, program.functions[0], arguments).at(0);
}

}  // namespace

TEST_CASE("leaves, arithmetic and the order of fields are right") {
  const Program program = every_leaf();
  Arguments<double> arguments;
  arguments.parameters = {2};
  arguments.q = {3};
  arguments.v = {5};
  arguments.a = {7};
  arguments.u = {8};
  arguments.t = 2;
  CHECK(evaluate(program, program.functions[0], arguments) == std::vector<double>{20, 2, 4});
}

TEST_CASE("evaluated calls have the values of the C library") {
  const std::pair<const char*, double (*)(double)> rows[] = {
      {"sin", std::sin},   {"cos", std::cos},   {"tan", std::tan},   {"asin", std::asin},
      {"acos", std::acos}, {"atan", std::atan}, {"sinh", std::sinh}, {"cosh", std::cosh},
      {"tanh", std::tanh}, {"exp", std::exp},   {"log", std::log}};
  for (const auto& [name, function] : rows) {
    INFO(name);
    CHECK(call(std::string(name) + " 0", 0.3, 0) == function(0.3));
  }
  CHECK(call("atan2 0 1", 0.3, -2) == std::atan2(0.3, -2.0));
}

TEST_CASE("kinked functions have their usual values, with sign(0) = 0") {
  CHECK(call("sign 0", 0, 0) == 0);
  CHECK(call("sign 0", -3, 0) == -1);
  CHECK(call("sign 0", 3, 0) == 1);
  CHECK(call("abs 0", -3, 0) == 3);
  CHECK(call("min 0 1", 1, 2) == 1);
  CHECK(call("max 0 1", 1, 2) == 2);
}

TEST_CASE("one program is evaluated with every scalar type") {
  const Program program = read_program(
      "coordinates x\nfunction bias\n  0 = coordinate x\n  1 = constant 1/3\n  2 = multiply 0 1\n"
      "  3 = sin 2\n  result 1 1 = 3\n");
  Arguments<float> single;
  single.q = {0.75F};
  Arguments<long double> extended;
  extended.q = {0.75L};
  Arguments<Real> exact;
  exact.q = {Real(cln::cl_RA("3/4"))};
  const Function& function = program.functions[0];
  CHECK(evaluate(program, function, single).at(0) == std::sin(0.25F));
  CHECK(evaluate(program, function, extended).at(0) == std::sin(0.75L * (1.0L / 3.0L)));
  const Real value = evaluate(program, function, exact).at(0);
  // Of 64 digits, rounding costs at most 2.
  const cln::cl_F error = value.value() - sin(Real(cln::cl_RA("1/4"))).value();
  CHECK(cln::abs(error) < cln::cl_float(cln::expt(cln::cl_RA(10), -62), Real::format()));
}
