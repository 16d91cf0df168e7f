// Composition: instruction by instruction; what two calls compute alike is one value.
#include "integrate/composition.hpp"

#include <fmt/format.h>

#include "elgen/leaf_names.hpp"
#include "lower/graph/prune.hpp"

namespace elgen {

std::uint32_t Composition::leaf(Opcode kind, std::uint32_t number) {
  return instructions_.add(Instruction{.opcode = kind, .a = number});
}

Places Composition::leaves(Opcode kind, std::size_t count) {
  Places places;
  for (std::uint32_t i = 0; i < count; ++i) places.push_back(leaf(kind, i));
  return places;
}

std::uint32_t Composition::number(const cln::cl_RA& value) {
  const std::uint32_t constant = position_of(rational_constant(value), program_.constants);
  return instructions_.add(Instruction{.opcode = Opcode::constant, .a = constant});
}

std::uint32_t Composition::add(Opcode opcode, std::uint32_t a, std::uint32_t b) {
  return instructions_.add(opcode, a, b);
}

Places Composition::moved(const Places& x, std::uint32_t c, const Places& y) {
  Places sum;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum.push_back(add(Opcode::add, x[i], add(Opcode::multiply, c, y[i])));
  }
  return sum;
}

std::uint32_t Composition::leaf_at(const Instruction& leaf, const CallPoint& at) {
  if (leaf.opcode == Opcode::coordinate) return at.q[leaf.a];
  if (leaf.opcode == Opcode::velocity) return at.v[leaf.a];
  if (leaf.opcode == Opcode::time) return at.t;
  return instructions_.add(leaf);
}

Places Composition::call(const Program& from, const Function& callee, const CallPoint& at) {
  const Places& wanted = callee.fields.front().entries;
  const std::vector<bool> needed = needed_for(callee, wanted);
  // A hash says of what a value is computed, which is another one here.
  const std::vector<std::string> names = told_names(from, callee);
  const std::string suffix = at.number > 1 ? fmt::format("_{}", at.number) : "";
  Places places(callee.instructions.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!needed[i]) continue;
    Instruction instruction = callee.instructions[i];
    if (is_leaf(instruction.opcode)) {
      places[i] = leaf_at(instruction, at);
      continue;
    }
    if (instruction.opcode == Opcode::constant) {
      instruction.a = position_of(from.constants[instruction.a], program_.constants);
    }
    if (operand_count(instruction) > 0) instruction.a = places[instruction.a];
    if (operand_count(instruction) > 1) instruction.b = places[instruction.b];
    places[i] = instructions_.add(instruction);
    std::string& name = function_.names[places[i]];
    if (!names[i].empty() && name.empty()) name = names[i] + suffix;
  }
  Places result;
  for (const std::uint32_t entry : wanted) result.push_back(places[entry]);
  return result;
}

void Composition::name(const Places& values, Opcode kind, std::uint32_t number) {
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    if (operand_count(function_.instructions[values[i]]) == 0) continue;
    std::string& name = function_.names[values[i]];
    if (!name.empty()) continue;
    const std::string of = identifier_of(leaf_of(program_.leaves, kind, i));
    name = fmt::format("{}_{}", fmt::format(fmt::runtime(leaf_row(kind).identifier), of), number);
  }
}

}  // namespace elgen
