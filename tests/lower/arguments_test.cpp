// arguments: which ones by the table, in their order.
#include "elgen/arguments.hpp"

#include "emit/fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;
using elgen::testing::Subject;

namespace {

std::string names(const Model& model, const Function& function) {
  std::string text;
  for (const Opcode argument : arguments_of(model, function)) text += leaf_row(argument).symbol;
  return text;
}

}  // namespace

TEST_CASE("arguments in one order, t and h last") {
  Subject subject = cart_pole();
  const std::vector<Function>& functions = subject.program.functions;
  CHECK(names(subject.model, functions[0]) == "pq");    // mass_matrix
  CHECK(names(subject.model, functions[2]) == "pqv");   // kinetic_energy
  CHECK(names(subject.model, functions[4]) == "pqvu");  // forward_dynamics
  Function inverse_dynamics;
  inverse_dynamics.kind = OutputKind::inverse_dynamics;
  CHECK(names(subject.model, inverse_dynamics) == "pqva");
  Function step;
  step.kind = OutputKind::step;
  CHECK(names(subject.model, step) == "pqvuh");
  subject.model.uses_time = true;
  CHECK(names(subject.model, step) == "pqvuth");
  subject.model.quadratic = false;
  CHECK(names(subject.model, functions[0]) == "pqvt");
}
