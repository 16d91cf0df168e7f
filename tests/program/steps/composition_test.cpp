// A call is an inlined copy of the called function with other leaves: a(q, u) = q*u at q + h v.
#include "program/steps/composition.hpp"

#include <catch2/catch.hpp>

#include "program/read_program.hpp"

namespace elgen::test {
namespace {

const std::string callee = R"(parameters k
coordinates q
inputs u
function bias
  0 = coordinate q
  1 = input u
  2 = multiply 0 1  ; t_work
  3 = parameter k
  4 = add 2 3
  5 = multiply 3 3
  result 2 1 = 4 2
)";

}  // namespace

TEST_CASE("a call copies the instructions of its entries, with its leaves replaced") {
  const Program from = read_program(callee);
  Program program{from.leaves};
  program.leaves.h = "h";
  Function function;
  Composition compose(program, function);
  const std::uint32_t h = compose.add_leaf(Opcode::step);
  const InstructionIndices q = compose.add_leaves(Opcode::coordinate, 1);
  const InstructionIndices v = compose.add_leaves(Opcode::velocity, 1);
  const InstructionIndices add_scaled = compose.add_scaled(q, h, v);
  compose.set_name(add_scaled, Opcode::coordinate, 2);
  compose.set_name(q, Opcode::coordinate, 1);  // no effect: a leaf keeps its own name
  InstructionIndices entries = compose.inline_call(
      from, from.functions[0], from.functions[0].fields[0], {.q = add_scaled, .v = v, .number = 2});
  function.kind = OutputKind::bias;
  function.name = "bias";
  function.fields = {{"", 2, 1, std::move(entries)}};
  program.functions.push_back(std::move(function));
  CHECK(find_invariant_violation(program).empty());
  CHECK(dump(program) == R"(parameters k
coordinates q
inputs u
step
function bias
  0 = step
  1 = coordinate q
  2 = velocity q
  3 = multiply 0 2
  4 = add 1 3  ; q_2
  5 = input u
  6 = multiply 4 5  ; t_work_2
  7 = parameter k
  8 = add 6 7
  result 2 1 = 8 6
)");
}

TEST_CASE("two calls at the same point are shared") {
  const Program from = read_program(callee);
  Program program{from.leaves};
  Function function;
  Composition compose(program, function);
  const InstructionIndices q = compose.add_leaves(Opcode::coordinate, 1);
  const InstructionIndices once =
      compose.inline_call(from, from.functions[0], from.functions[0].fields[0], {.q = q});
  const std::size_t size = function.instructions.size();
  CHECK(compose.inline_call(from, from.functions[0], from.functions[0].fields[0],
                            {.q = q, .number = 2}) == once);
  CHECK(function.instructions.size() == size);
}

TEST_CASE("operations that become 0, add 0 or multiply by 1 are not emitted") {
  const Program from = read_program(R"(parameters k m
coordinates q
function momentum
  0 = coordinate q
  1 = velocity q
  2 = parameter k
  3 = parameter m
  4 = multiply 0 1
  5 = multiply 4 2
  6 = add 5 3
  7 = multiply 6 2
  8 = subtract 4 2
  9 = divide 4 2
  result 3 1 = 7 8 9
)");
  Program program{from.leaves};
  Function function{.kind = OutputKind::momentum, .name = "momentum"};
  Composition compose(program, function);
  const std::uint32_t zero = compose.add_number(0);
  const CallPoint at_rest{.q = compose.add_leaves(Opcode::coordinate, 1), .v = {zero}};
  InstructionIndices entries =
      compose.inline_call(from, from.functions[0], from.functions[0].fields[0], at_rest);
  entries.push_back(compose.add(Opcode::multiply, compose.add_number(1), entries[0]));
  function.fields = {{"", 4, 1, std::move(entries)}};
  program.functions.push_back(eliminate_dead_code(function));
  CHECK(dump(program) == R"(parameters k m
coordinates q
function momentum
  0 = constant 0
  1 = parameter k
  2 = parameter m
  3 = multiply 2 1
  4 = negate 1
  result 4 1 = 3 4 0 3
)");
}

}  // namespace elgen::test
