#include <fmt/core.h>

#include <catch2/catch.hpp>

#include "elgen/page.hpp"
#include "program/read_program.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// The equations of the first function, with the names used in code.
FunctionEquations equations_of(const Program& program) {
  const Function& function = program.functions[0];
  return function_equations(program, function, temporary_names(program, function));
}

/// The text of instruction `result`. Instructions 0 ... 7 are m, x, y, dot(x), dot(dot(x)), u, t
/// and 1/2; the numbers of `instructions` start at 8.
std::string entry(const std::string& instructions, int result) {
  const Program program = read_program(
      "parameters m\ncoordinates x y\ninputs u\ntime\n"
      "function bias\n"
      "  0 = parameter m\n  1 = coordinate x\n  2 = coordinate y\n  3 = velocity x\n"
      "  4 = acceleration x\n  5 = input u\n  6 = time\n  7 = constant 1/2\n" +
      instructions + fmt::format("  result 1 1 = {}\n", result));
  return text_of(equations_of(program).entries.at(0).at(0));
}

}  // namespace

TEST_CASE("leaves are printed as in the model") {
  CHECK(entry("", 0) == "m");
  CHECK(entry("", 3) == "dot(x)");
  CHECK(entry("", 4) == "dot(dot(x))");
  CHECK(entry("", 5) == "u");
  CHECK(entry("", 6) == "t");
  CHECK(entry("", 7) == "1/2");
}

TEST_CASE("brackets are printed only if precedence needs them") {
  struct Row {
    std::string instructions;
    int result;
    std::string text;
  };
  const Row row = GENERATE(values<Row>({
      {"  8 = add 0 1\n  9 = multiply 8 2\n", 9, "(m + x)*y"},
      {"  8 = multiply 0 1\n  9 = add 8 2\n", 9, "m*x + y"},
      {"  8 = add 1 2\n  9 = subtract 0 8\n", 9, "m - (x + y)"},
      {"  8 = subtract 0 1\n  9 = subtract 8 2\n", 9, "m - x - y"},
      {"  8 = multiply 0 1\n  9 = divide 2 8\n", 9, "y/(m*x)"},
      {"  8 = divide 0 1\n  9 = divide 8 2\n", 9, "m/x/y"},
      {"  8 = divide 0 1\n  9 = divide 2 8\n", 9, "y/(m/x)"},
      {"  8 = divide 0 1\n  9 = multiply 8 2\n", 9, "m/x*y"},
      {"  8 = divide 0 1\n  9 = multiply 2 8\n", 9, "y*(m/x)"},
      {"  8 = multiply 1 1\n  9 = multiply 0 8\n", 9, "m*x^2"},
      {"  8 = add 1 2\n  9 = multiply 8 8\n", 9, "(x + y)^2"},
      {"  8 = multiply 7 1\n", 8, "1/2*x"},
      {"  8 = multiply 1 7\n", 8, "x*(1/2)"},
      {"  8 = multiply 0 1\n  9 = negate 8\n", 9, "-m*x"},
      {"  8 = add 0 1\n  9 = negate 8\n", 9, "-(m + x)"},
      {"  8 = negate 0\n  9 = multiply 8 1\n", 9, "(-m)*x"},
      {"  8 = negate 0\n  9 = exp 8\n", 9, "exp(-m)"},
      {"  8 = add 0 1\n  9 = square_root 8\n", 9, "sqrt(m + x)"},
      {"  8 = atan2 0 1\n", 8, "atan2(m, x)"},
  }));
  CHECK(entry(row.instructions, row.result) == row.text);
}

TEST_CASE("a short entry is written out, a long entry uses definitions") {
  std::string text =
      "coordinates x y\nfunction bias\n  0 = coordinate x\n  1 = sin 0\n  2 = coordinate y\n"
      "  3 = sin 2\n";
  for (int i = 4; i < 50; ++i) text += fmt::format("  {} = multiply {} 1\n", i, i - 1);
  const Program program = read_program(text + "  result 1 2 = 3 49\n");
  const FunctionEquations result = equations_of(program);
  CHECK(text_of(result.entries.at(0).at(0)) == "sin(y)");
  REQUIRE(result.definitions.size() == 5);
  CHECK(text_of(result.definitions[0].name) == "sin_x");
  CHECK(text_of(result.definitions[0].value) == "sin(x)");
  CHECK(text_of(result.definitions[1].name) == "sin_y");
  CHECK(text_of(result.definitions[2].value) == "sin_y*sin_x^13");
  CHECK(text_of(result.entries.at(0).at(1)) == text_of(result.definitions[4].name) + "*sin_x^7");
}

TEST_CASE("guards of pivots are for code: pages omit them") {
  const Program program = read_program(
      "parameters m\ncoordinates x\nfunction forward_dynamics\n"
      "  0 = parameter m\n  1 = coordinate x\n  2 = constant 1\n  3 = constant 0\n"
      "  4 = divide 2 0\n  5 = multiply 3 4\n  6 = add 2 5\n  7 = divide 3 1\n"
      "  8 = add 4 7\n  9 = add 1 4\n"
      "  result acceleration 1 1 = 9\n  result relative_pivots 2 1 = 6 8\n");
  const FunctionEquations shown = equations(program, 0);
  CHECK(texts_of(shown.entries.at(1)) == std::vector<std::string>{"1", "1/m"});
  CHECK(texts_of(shown.entries.at(0)) == std::vector<std::string>{"x + 1/m"});
}

TEST_CASE("products are printed with powers, and closed forms with their names") {
  Program program = read_program(
      "parameters m\ncoordinates x\nfunction gravity\n  0 = parameter m\n  1 = coordinate x\n"
      "  2 = multiply 1 1\n  3 = multiply 0 2\n  4 = cos 3\n  5 = constant 1/2\n"
      "  6 = negate 5\n  result 1 2 = 4 6\n");
  CHECK(texts_of(equations_of(program).entries.at(0)) ==
        std::vector<std::string>{"cos(m*x^2)", "-1/2"});
  program.readable = program.functions;
  program.readable[0].names.resize(7);
  program.readable[0].names[3] = "mass";
  const FunctionEquations named = equations(program, 0);
  REQUIRE(named.definitions.size() == 1);
  CHECK(text_of(named.definitions[0].name) == "mass");
  CHECK(text_of(named.definitions[0].value) == "m*x^2");
  CHECK(text_of(named.entries.at(0).at(0)) == "cos(mass)");
}
