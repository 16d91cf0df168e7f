// joint_program: what is added to a function that has it already is found by its value number.
#include "diff/joint_program.hpp"

#include <algorithm>

#include "diff/renamed.hpp"
#include "program/network/instructions.hpp"

namespace elgen {
namespace {

LeafNames with_renames(LeafNames names, const Renames& renames) {
  for_each_leaf(
      [&renames](Opcode, std::uint32_t, std::string& name) { name = renamed(name, renames); },
      static_cast<LeafValues<std::string>&>(names));
  return names;
}

Assumption weaker(Assumption x, Assumption y) {
  if (x == Assumption::none || y == Assumption::none) return Assumption::none;
  return x == y ? x : Assumption::nonnegative;
}

/// Copies the instructions of a function, and where its entries came to be.
class Copy {
 public:
  Copy(const Program& from, const LeafValues<std::uint32_t>& places, Program& to,
       Instructions& instructions)
      : from_(from), places_(places), to_(to), instructions_(instructions) {}

  std::vector<std::uint32_t> operator()(const Function& function, const ParameterValues& values) {
    std::vector<std::uint32_t> copies;
    for (Instruction i : function.instructions) {
      if (is_leaf(i.opcode)) {
        i = leaf(i, values);
      } else if (i.opcode == Opcode::constant) {
        i.a = position_of(from_.constants[i.a], to_.constants);
      }
      if (operand_count(i) > 0) i.a = copies[i.a];
      if (operand_count(i) > 1) i.b = copies[i.b];
      copies.push_back(instructions_.add(i));
    }
    std::vector<std::uint32_t> entries;
    for (const std::uint32_t entry : entries_of(function)) entries.push_back(copies[entry]);
    return entries;
  }

 private:
  Instruction leaf(Instruction i, const ParameterValues& values) {
    const auto value = i.opcode == Opcode::parameter
                           ? values.find(leaf_of(from_.leaves, i.opcode, i.a))
                           : values.end();
    if (value != values.end()) {
      return {.opcode = Opcode::constant, .a = position_of(value->second, to_.constants)};
    }
    if (list_of(places_, i.opcode) != nullptr) i.a = leaf_of(places_, i.opcode, i.a);
    return i;
  }

  const Program& from_;
  const LeafValues<std::uint32_t>& places_;
  Program& to_;
  Instructions& instructions_;
};

}  // namespace

JointProgram::JointProgram(const Program& before, const Program& after, const Renames& renames)
    : before_(before), after_(after) {
  new_places_ = add(after.leaves);
  old_places_ = add(with_renames(before.leaves, renames));
}

auto JointProgram::add(const LeafNames& names) -> LeafPlaces {
  LeafNames& joint = joint_.leaves;
  joint.uses_time = joint.uses_time || names.uses_time;
  LeafPlaces places;
  const std::size_t known_before = joint.parameters.size();
#define ELGEN_LEAVES(kind, member, ...)                                                \
  for (const std::string& name : names.member) {                                       \
    const auto found = std::ranges::find(joint.member, name);                          \
    places.member.push_back(static_cast<std::uint32_t>(found - joint.member.begin())); \
    if (found == joint.member.end()) joint.member.push_back(name);                     \
  }
#define ELGEN_LEAF(kind, member, ...) \
  if (joint.member.empty()) joint.member = names.member;
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
  // Of a parameter that both have, what both assume.
  joint.assumptions.resize(joint.parameters.size(), Assumption::none);
  for (std::uint32_t i = 0; i < names.parameters.size(); ++i) {
    Assumption& assumption = joint.assumptions[places.parameters[i]];
    const Assumption one = assumption_of(names, i);
    assumption = places.parameters[i] < known_before ? weaker(assumption, one) : one;
  }
  return places;
}

JointFunction JointProgram::joined(const Function& before, const Function& after,
                                   const JointValues& values) {
  JointFunction joint;
  // Any kind but `dynamics`, which has no closed form of its own.
  joint.function.kind = OutputKind::momentum;
  joint.function.name = after.name;
  Instructions instructions(joint.function);
  joint.before = Copy(before_, old_places_, joint_, instructions)(before, values.before);
  joint.after = Copy(after_, new_places_, joint_, instructions)(after, values.after);
  return joint;
}

}  // namespace elgen
