// function_formulas: the same instructions as read and as executed.
#include "render/function_formulas.hpp"

#include <catch2/catch.hpp>

#include "lower/read_program.hpp"

using namespace elgen;

namespace {

class Plain final : public Vocabulary {
 public:
  Plain(const Spelling& spelling, const LeafNames& leaves)
      : Vocabulary(spelling), leaves_(leaves) {}
  std::string leaf(const Instruction& i) const override {
    return leaf_text(leaves_, i.opcode, i.a);
  }

 private:
  const LeafNames& leaves_;
};

}  // namespace

TEST_CASE("products are read with powers, and executed in their order") {
  const Program program = testing::read_program(
      "parameters m\ncoordinates x\nfunction gravity\n  0 = parameter m\n  1 = coordinate x\n"
      "  2 = multiply 1 1\n  3 = multiply 0 2\n  4 = cos 3\n  5 = constant 1/2\n"
      "  6 = negate 5\n  result 1 2 = 4 6\n");
  const Function& function = program.functions.front();
  std::vector<std::string> names(function.instructions.size());
  const Plain read(model_spelling(), program.leaves);
  const Plain executed(code_spelling(), program.leaves);
  CHECK(FunctionFormulas(program, function, read, names).entry(4).text() == "cos(m*x^2)");
  CHECK(FunctionFormulas(program, function, executed, names).entry(4).text() == "cos(m * (x * x))");
  CHECK(FunctionFormulas(program, function, read, names).entry(6).text() == "-1/2");
  names[3] = "mass";
  const FunctionFormulas named(program, function, read, names);
  CHECK(named.entry(3).text() == "mass");
  CHECK(named.definition(3).text() == "m*x^2");
  CHECK(named.entry(4).text() == "cos(mass)");
}
