// function_formulas: instructions as formulas in their order of execution.
#include "emit/code/function_formulas.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "program/read_program.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

class Plain final : public Vocabulary {
 public:
  explicit Plain(const LeafNames& leaves) : leaves_(leaves) {}
  std::string leaf(Opcode kind, std::uint32_t number) const override {
    return leaf_text(leaves_, kind, number);
  }
  FormulaText constant(const Constant& constant) const override { return {text_of(constant.form)}; }
  FormulaText square_root(const FormulaText& x) const override {
    return named_call_text("sqrt", {x});
  }
  FormulaText call(FunctionId function, const std::vector<FormulaText>& arguments) const override {
    return named_call_text(function_row(function).name, arguments);
  }
  FormulaText at_run_time(const FormulaText& number) const override {
    return named_call_text("late", {number});
  }

 private:
  const LeafNames& leaves_;
};

/// The formulas of a function of a, b and c (instructions 0, 1, 2).
std::string formula_text(const std::string& operations, std::uint32_t last) {
  const Program program = read_program(
      "parameters a b c\nfunction gravity\n  0 = parameter a\n  1 = parameter b\n"
      "  2 = parameter c\n" +
      operations + fmt::format("  result 1 1 = {}\n", last));
  const Function& function = program.functions.front();
  const Plain language(program.leaves);
  const std::vector<std::string> names(function.instructions.size());
  return FunctionFormulas(program, function, language, names).name_or_formula(last).text;
}

}  // namespace

TEST_CASE("products keep their order, and named values are written by name") {
  const Program program = read_program(
      "parameters m\ncoordinates x\nfunction gravity\n  0 = parameter m\n  1 = coordinate x\n"
      "  2 = multiply 1 1\n  3 = multiply 0 2\n  4 = cos 3\n  5 = constant 1/2\n"
      "  6 = negate 5\n  result 1 2 = 4 6\n");
  const Function& function = program.functions.front();
  std::vector<std::string> names(function.instructions.size());
  const Plain language(program.leaves);
  CHECK(FunctionFormulas(program, function, language, names).name_or_formula(4).text ==
        "cos(m * (x * x))");
  CHECK(FunctionFormulas(program, function, language, names).name_or_formula(6).text == "-1/2");
  names[3] = "mass";
  const FunctionFormulas named(program, function, language, names);
  CHECK(named.name_or_formula(3).text == "mass");
  CHECK(named.formula(3).text == "m * (x * x)");
  CHECK(named.name_or_formula(4).text == "cos(mass)");
}

TEST_CASE("brackets keep the order of evaluation, and there are no others") {
  CHECK(formula_text("  3 = add 0 1\n  4 = add 3 2\n", 4) == "a + b + c");
  CHECK(formula_text("  3 = add 1 2\n  4 = add 0 3\n", 4) == "a + (b + c)");
  CHECK(formula_text("  3 = subtract 1 2\n  4 = subtract 0 3\n", 4) == "a - (b - c)");
  CHECK(formula_text("  3 = subtract 0 1\n  4 = subtract 3 2\n", 4) == "a - b - c");
  CHECK(formula_text("  3 = multiply 1 2\n  4 = multiply 0 3\n", 4) == "a * (b * c)");
  CHECK(formula_text("  3 = multiply 0 1\n  4 = divide 3 2\n", 4) == "a * b / c");
  CHECK(formula_text("  3 = divide 1 2\n  4 = divide 0 3\n", 4) == "a / (b / c)");
  CHECK(formula_text("  3 = divide 1 2\n  4 = multiply 0 3\n", 4) == "a * (b / c)");
  CHECK(formula_text("  3 = add 0 1\n  4 = multiply 3 2\n", 4) == "(a + b) * c");
  CHECK(formula_text("  3 = add 0 1\n  4 = divide 2 3\n", 4) == "c / (a + b)");
  CHECK(formula_text("  3 = multiply 0 1\n  4 = add 2 3\n", 4) == "c + a * b");
}

TEST_CASE("minus signs") {
  CHECK(formula_text("  3 = negate 0\n  4 = multiply 3 1\n  5 = add 4 2\n", 5) == "-a * b + c");
  CHECK(formula_text("  3 = multiply 0 1\n  4 = negate 3\n  5 = add 4 2\n", 5) == "-a * b + c");
  CHECK(formula_text("  3 = add 0 1\n  4 = negate 3\n  5 = multiply 4 2\n", 5) == "-(a + b) * c");
  CHECK(formula_text("  3 = negate 1\n  4 = multiply 0 3\n  5 = multiply 4 2\n", 5) ==
        "a * (-b) * c");
  CHECK(formula_text("  3 = multiply 1 2\n  4 = negate 3\n  5 = subtract 0 4\n", 5) ==
        "a - (-b * c)");
}

TEST_CASE("calls take their arguments without brackets") {
  CHECK(formula_text("  3 = add 0 1\n  4 = atan2 3 2\n", 4) == "atan2(a + b, c)");
  CHECK(formula_text("  3 = add 0 1\n  4 = square_root 3\n  5 = divide 2 4\n", 5) ==
        "c / sqrt(a + b)");
}

TEST_CASE("functions of numbers are computed at run time") {
  CHECK(formula_text("  3 = constant 7/10\n  4 = cos 3\n  5 = multiply 0 4\n", 5) ==
        "a * cos(late(7/10))");
  CHECK(formula_text("  3 = constant 7/10\n  4 = negate 3\n  5 = exp 4\n", 5) ==
        "exp(late(-7/10))");
  CHECK(formula_text("  3 = constant 7/10\n  4 = square_root 3\n", 4) == "sqrt(late(7/10))");
  CHECK(formula_text("  3 = constant 7/10\n  4 = atan2 3 0\n", 4) == "atan2(7/10, a)");
  CHECK(formula_text("  3 = constant 7/10\n  4 = add 3 0\n  5 = cos 4\n", 5) == "cos(7/10 + a)");
}
