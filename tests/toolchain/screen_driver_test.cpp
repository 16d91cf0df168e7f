// The text of the screening driver: the functions that occur, every field judged.
#include "toolchain/screen_driver.hpp"

#include <catch2/catch.hpp>

#include "toolchain/sample_model.hpp"

using Catch::Matchers::Contains;

namespace {

std::string text_of(const elgen::Program& program = sample::program()) {
  return elgen::screen_driver({sample::model(), sample::scene(), program}).text;
}

}  // namespace

TEST_CASE("every field of every function has its figures") {
  const std::string text = text_of();
  CHECK_THAT(text, Contains("#include \"sample/sample.hpp\""));
  CHECK_THAT(text, Contains("judge(x.data() + 0, truth.data() + 0, 1, 2, figures + 0)"));
  CHECK_THAT(text, Contains("judge(x.data() + 1, truth.data() + 1, 1, 0, figures + 4)"));
  CHECK_THAT(text, Contains("extern \"C\" void elgen_screen_double(const double* parameters"));
  CHECK_THAT(text, Contains("extern \"C\" void elgen_screen_float(const float* parameters"));
  CHECK_THAT(text, Contains("inputs(parameters, 3, signs)"));
  CHECK_THAT(text, Contains("inputs(&t, 1, signs)"));
}

TEST_CASE("only functions that the program calls are there, with their derivatives") {
  CHECK_THAT(text_of(), !Contains("Number cos("));
  elgen::Program program = sample::program();
  for (const auto id : {elgen::FunctionId::cos, elgen::FunctionId::atan2, elgen::FunctionId::abs}) {
    program.functions[0].instructions.push_back({elgen::Opcode::call, id, 0, 1});
  }
  const std::string text = text_of(program);
  CHECK_THAT(text, Contains("Number cos(const Number& a)"));
  CHECK_THAT(text, Contains("return called(a, f, -sin(x), 1);"));
  CHECK_THAT(text, Contains("Number atan2(const Number& a, const Number& b)"));
  CHECK_THAT(text, !Contains("Number sin("));
}
