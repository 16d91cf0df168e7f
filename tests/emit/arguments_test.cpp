// arguments: which ones by the table, their names and sizes, and what is read from them.
#include "emit/arguments.hpp"

#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;
using elgen::testing::Subject;

namespace {

std::string names(const Model& model, const Function& function) {
  std::string text;
  for (const Argument argument : arguments_of(model, function)) text += argument_name(argument);
  return text;
}

}  // namespace

TEST_CASE("arguments in one order, t last") {
  Subject subject = cart_pole();
  const std::vector<Function>& functions = subject.program.functions;
  CHECK(names(subject.model, functions[0]) == "pq");    // mass_matrix
  CHECK(names(subject.model, functions[2]) == "pqv");   // kinetic_energy
  CHECK(names(subject.model, functions[4]) == "pqvu");  // forward_dynamics
  Function inverse_dynamics;
  inverse_dynamics.kind = OutputKind::inverse_dynamics;
  CHECK(names(subject.model, inverse_dynamics) == "pqva");
  subject.model.uses_time = true;
  subject.model.quadratic = false;
  CHECK(names(subject.model, functions[0]) == "pqvt");
}

TEST_CASE("leaves are read from arguments") {
  CHECK(argument_of(Opcode::parameter) == Argument::parameters);
  CHECK(argument_of(Opcode::input) == Argument::inputs);
  CHECK(argument_of(Opcode::time) == Argument::time);
  CHECK_FALSE(argument_of(Opcode::constant));
  CHECK_FALSE(argument_of(Opcode::negate));
}

TEST_CASE("sizes of arguments, and members of parameters") {
  Subject subject = cart_pole();
  CHECK(argument_size(subject.model, Argument::accelerations) == 2);
  CHECK(argument_size(subject.model, Argument::inputs) == 1);
  CHECK(argument_size(subject.model, Argument::time) == 1);
  elgen::testing::add_parameter_array(subject.model, "k", {1, 2});
  subject.program.leaves.parameters = {"g", "k[2]"};
  CHECK(parameter_members(subject.model, subject.program.leaves) ==
        std::vector<std::string>{"g", "k[1]"});
}
