// fold: evaluates the instructions of a Function in any domain: numbers, error bounds, closed
// forms, graphs, text. `Rules` is a class that defines each operation on values of the domain:
//
//     constant(const Constant&)   leaf(Opcode, number)   negate(x)   add(x, y)   subtract(x, y)
//     multiply(x, y)   divide(x, y)   square_root(x)   call(FunctionId, x, y)
//
// A function of one argument ignores y.
#pragma once

#include <vector>

#include "elgen/program.hpp"

namespace elgen {

/// The value of instruction `i`. For each operand k of `i`, values[k] must be the value of
/// instruction k.
template <class Rules, class Values>
[[nodiscard]] auto fold_instruction(Rules&& rules, const Program& program, const Instruction& i,
                                    const Values& values) {
  switch (i.opcode) {
    case Opcode::constant:
      return rules.constant(program.constants[i.a]);
    case Opcode::negate:
      return rules.negate(values[i.a]);
    case Opcode::add:
      return rules.add(values[i.a], values[i.b]);
    case Opcode::subtract:
      return rules.subtract(values[i.a], values[i.b]);
    case Opcode::multiply:
      return rules.multiply(values[i.a], values[i.b]);
    case Opcode::divide:
      return rules.divide(values[i.a], values[i.b]);
    case Opcode::square_root:
      return rules.square_root(values[i.a]);
    case Opcode::call:
      return rules.call(i.function, values[i.a], values[i.b]);
#define ELGEN_LEAVES(kind, ...) case Opcode::kind:
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
      break;
  }
  return rules.leaf(i.opcode, i.a);
}

/// The values of all instructions of `function`, in order, computed with `rules`.
template <class Value, class Rules>
[[nodiscard]] std::vector<Value> fold(Rules&& rules, const Program& program,
                                      const Function& function) {
  std::vector<Value> values(function.instructions.size());
  Value* const all = values.data();  // checks of indices took half of the time
  Value* next = all;
  for (const Instruction& i : function.instructions) {
    *next++ = fold_instruction(rules, program, i, all);
  }
  return values;
}

/// The values of the entries of all fields of `function`, field by field, row-major. values[k] is
/// the value of instruction k.
template <class Value>
[[nodiscard]] std::vector<Value> entries_of(const Function& function,
                                            const std::vector<Value>& values) {
  std::vector<Value> entries;
  for (const std::uint32_t entry : entries_of(function)) entries.push_back(values[entry]);
  return entries;
}

}  // namespace elgen
