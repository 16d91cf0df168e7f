// The leaves of a step.
#include "integrate/methods.hpp"

#include <catch2/catch.hpp>

#include "support/models.hpp"

namespace elgen::test {
namespace {

Model point(const std::string& potential) {
  return checked_model(model_text("point",
                                  "[[coordinate]]\nname = \"x\"\n[energy]\n"
                                  "T = \"1/2*dot(x)^2\"\nV = \"" +
                                      potential + "\"\n"))
      .model;
}

}  // namespace

TEST_CASE("time moves where the model knows it") {
  for (const bool moves : {false, true}) {
    const Model model = point(moves ? "x*sin(t)" : "x^2");
    Program program;
    Function function;
    Composition compose(program, function);
    const StepContext step(model, {.iterations = 3}, program, compose);
    CHECK(step.iterations == 3);
    const std::size_t size = function.instructions.size();
    const std::uint32_t later = step.time_after(step.half);
    CHECK(function.instructions.size() == size + (moves ? 1 : 0));
    if (moves) CHECK(function.instructions[later].opcode == Opcode::add);
  }
}
}  // namespace elgen::test
