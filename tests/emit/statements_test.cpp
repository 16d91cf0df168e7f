// statements: rows of program -> text, the brackets above all; and that no bracket is missing,
// by evaluating the text's own order against the interpreter's.
#include "emit/statements.hpp"

#include <fmt/format.h>

#include "fixture.hpp"

using namespace elgen;

namespace {

/// The plainest language: leaves by letter and number.
class Plain final : public Vocabulary {
 public:
  Plain() : Vocabulary(code_spelling()) {}
  std::string leaf(const Instruction& i) const override {
    return i.opcode == Opcode::time ? "t" : fmt::format("x{}", i.a);
  }
  Formula square_root(const Formula& x) const override { return called("sqrt", {x}); }
};

FunctionBody body_of(const std::string& instructions) {
  const Program program =
      elgen::testing::read_program("parameters a b c d\nfunction gravity\n" + instructions);
  const Function& function = program.functions.front();
  return statements(program, function, Plain(), temporary_names(program, function));
}

std::string entry_of(const std::string& operations, int last) {
  const std::string leaves = "  0 = parameter a\n  1 = parameter b\n  2 = parameter c\n";
  return body_of(leaves + operations + fmt::format("  result 1 1 = {}\n", last)).entries[0][0].text;
}

}  // namespace

TEST_CASE("brackets keep the order of evaluation, and there are no others") {
  CHECK(entry_of("  3 = add 0 1\n  4 = add 3 2\n", 4) == "x0 + x1 + x2");
  CHECK(entry_of("  3 = add 1 2\n  4 = add 0 3\n", 4) == "x0 + (x1 + x2)");
  CHECK(entry_of("  3 = subtract 1 2\n  4 = subtract 0 3\n", 4) == "x0 - (x1 - x2)");
  CHECK(entry_of("  3 = subtract 0 1\n  4 = subtract 3 2\n", 4) == "x0 - x1 - x2");
  CHECK(entry_of("  3 = multiply 1 2\n  4 = multiply 0 3\n", 4) == "x0 * (x1 * x2)");
  CHECK(entry_of("  3 = multiply 0 1\n  4 = divide 3 2\n", 4) == "x0 * x1 / x2");
  CHECK(entry_of("  3 = divide 1 2\n  4 = divide 0 3\n", 4) == "x0 / (x1 / x2)");
  CHECK(entry_of("  3 = divide 1 2\n  4 = multiply 0 3\n", 4) == "x0 * (x1 / x2)");
  CHECK(entry_of("  3 = add 0 1\n  4 = multiply 3 2\n", 4) == "(x0 + x1) * x2");
  CHECK(entry_of("  3 = add 0 1\n  4 = divide 2 3\n", 4) == "x2 / (x0 + x1)");
  CHECK(entry_of("  3 = multiply 0 1\n  4 = add 2 3\n", 4) == "x2 + x0 * x1");
}

TEST_CASE("minus signs") {
  CHECK(entry_of("  3 = negate 0\n  4 = multiply 3 1\n  5 = add 4 2\n", 5) == "-x0 * x1 + x2");
  CHECK(entry_of("  3 = multiply 0 1\n  4 = negate 3\n  5 = add 4 2\n", 5) == "-x0 * x1 + x2");
  CHECK(entry_of("  3 = add 0 1\n  4 = negate 3\n  5 = multiply 4 2\n", 5) == "-(x0 + x1) * x2");
  CHECK(entry_of("  3 = negate 1\n  4 = multiply 0 3\n  5 = multiply 4 2\n", 5) ==
        "x0 * (-x1) * x2");
  CHECK(entry_of("  3 = multiply 1 2\n  4 = negate 3\n  5 = subtract 0 4\n", 5) ==
        "x0 - (-x1 * x2)");
}

TEST_CASE("calls take their arguments without brackets") {
  CHECK(entry_of("  3 = add 0 1\n  4 = atan2 3 2\n", 4) == "atan2(x0 + x1, x2)");
  CHECK(entry_of("  3 = add 0 1\n  4 = square_root 3\n  5 = divide 2 4\n", 5) ==
        "x2 / sqrt(x0 + x1)");
}

TEST_CASE("a shared value is one statement, before its uses") {
  const FunctionBody body = body_of(
      "  0 = parameter a\n  1 = parameter b\n  2 = add 0 1  ; total\n  3 = multiply 2 2\n"
      "  result 2 1 = 3 2\n");
  REQUIRE(body.statements.size() == 1);
  CHECK(body.statements[0].name == "total");
  CHECK(body.statements[0].value.text == "x0 + x1");
  CHECK(body.statements[0].value.uses.empty());
  CHECK(body.entries[0][0].text == "total * total");
  CHECK(body.entries[0][1].text == "total");
  CHECK(body.entries[0][0].uses == std::vector<std::uint32_t>{0});
  CHECK(body.statements[0].value.instructions == std::vector<std::uint32_t>{2, 0, 1});
  CHECK(body.entries[0][0].instructions == std::vector<std::uint32_t>{3});
}

TEST_CASE("functions called") {
  const Program program = elgen::testing::read_program(
      "coordinates x\nfunction gravity\n  0 = coordinate x\n  1 = sin 0\n  2 = square_root 1\n"
      "  result 1 1 = 2\n");
  CHECK(called_functions(program.functions.front()) == std::set<FunctionId>{FunctionId::sin});
}
