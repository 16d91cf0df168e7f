#include "support/parse_program.hpp"

#include <catch2/catch.hpp>

#include "program/read_program.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("a program is printed with the names of the model and read back") {
  const std::string text =
      "parameters m l[2]\n"
      "positive m\n"
      "coordinates theta\n"
      "inputs u\n"
      "time\n"
      "momenta\n"
      "step\n"
      "function mass_matrix\n"
      "  0 = parameter l[2]\n"
      "  1 = constant -1/2\n"
      "  2 = multiply 0 1  ; half_length\n"
      "  3 = constant 1/2*pi-cos(3/10)\n"
      "  4 = atan2 2 3\n"
      "  5 = negate 4\n"
      "  6 = square_root 5\n"
      "  result 1 2 = 4 6\n"
      "function both = dynamics\n"
      "  0 = time\n"
      "  1 = coordinate theta\n"
      "  2 = velocity theta\n"
      "  3 = acceleration theta\n"
      "  4 = input u\n"
      "  5 = divide 1 0\n"
      "  result bias 1 1 = 5\n"
      "  result gravity 1 3 = 2 3 4\n"
      "function tip = user_value 2\n"
      "  0 = time\n"
      "  result 1 1 = 0\n"
      "function hamiltonian\n"
      "  0 = momentum theta\n"
      "  1 = multiply 0 0\n"
      "  result 1 1 = 1\n"
      "function advance = step 1\n"
      "  0 = step\n"
      "  1 = velocity theta\n"
      "  result coordinates 1 1 = 0\n"
      "  result rates 1 1 = 1\n"
      "function implicit = step 2 8\n"
      "  0 = velocity theta\n"
      "  result rates 1 1 = 0\n"
      "function composed = step 1 order 8\n"
      "  0 = velocity theta\n"
      "  result rates 1 1 = 0\n"
      "function closed = step 0 projected\n"
      "  0 = velocity theta\n"
      "  result rates 1 1 = 0\n";
  const Program program = read_program(text);
  CHECK(dump(program) == text);
  CHECK(program.constants.size() == 2);
  CHECK(program.functions.at(1).kind == OutputKind::dynamics);
  CHECK(program.functions.at(2).user == 2);
  CHECK(program.functions.at(3).kind == OutputKind::hamiltonian);
  CHECK(program.functions.at(4).kind == OutputKind::step);
  CHECK_FALSE(program.functions.at(3).step);
  CHECK(program.functions.at(4).step == default_step(StepMethod::verlet));
  CHECK(program.functions.at(5).step == default_step(StepMethod::midpoint));
  CHECK(program.functions.at(6).step == default_step(StepMethod::verlet, 8));
  CHECK(program.functions.at(7).step == StepSpec{.method = StepMethod::rk4, .projects = true});
}

TEST_CASE("comments and empty lines are ignored, names are kept") {
  const Program program = read_program(
      "; a comment\n\ncoordinates x\nfunction gravity\n  0 = coordinate x ; position of it\n"
      "  result 1 1 = 0\n");
  CHECK(program.functions.at(0).names.at(0) == "position");
}

TEST_CASE("mistakes are reported with the span of their line") {
  struct Row {
    std::string line;
    std::string message;
  };
  const Row row = GENERATE(values<Row>({
      {"  1 = square 0", "`square` is no operation"},
      {"  1 = sin", "`sin` has other operands"},
      {"  1 = atan2 0", "`atan2` has other operands"},
      {"  1 = parameter m", "`parameter` has other operands"},
      {"  1 = constant x", "`constant` has other operands"},
      {"  1 = negate -1", "`negate` has other operands"},
      {"  2 = negate 0", "expected `1 = OPERATION …`"},
      {"  result 1 1", "expected `result [NAME] ROWS COLUMNS = ENTRIES`"},
      {"  result 1 1 = a", "`a` is not a number"},
      {"function nothing", "`nothing` is no output"},
      {"function",
       "expected `function NAME [= KIND [NUMBER [ITERATIONS] [order ORDER] [projected]]]`"},
  }));
  const std::string head = "coordinates x\nfunction bias\n  0 = coordinate x\n";
  const SourcePointer source = make_source("program", head + row.line + "\n");
  const Result<Program> program = parse_program(source);
  REQUIRE_FALSE(program);
  CHECK(program.diagnostics.at(0).message == row.message);
  CHECK(covered_text(program.diagnostics.at(0).span) == row.line);
}

TEST_CASE("an instruction outside a function is an error") {
  const auto program = parse_program(make_source("program", "  0 = time\n"));
  REQUIRE_FALSE(program);
  CHECK(program.diagnostics.at(0).message == "`0` outside of a function");
}
