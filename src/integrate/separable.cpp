// not_separable: what is constant or absent is read off the program.
#include <fmt/format.h>

#include <algorithm>

#include "elgen/integrate.hpp"
#include "evaluate/subject.hpp"

namespace elgen {
namespace {

/// "theta", "dot(x)" or "t": the first leaf of one of these kinds that the output reads; "" where
/// it reads none.
std::string leaf_read(const Program& program, OutputKind kind, LeafSet kinds) {
  const Function* const function = find_function(program, kind);
  if (function == nullptr) return {};
  for (const Instruction& instruction : function->instructions) {
    if (is_leaf(instruction.opcode) && kinds.has_any(instruction.opcode)) {
      return leaf_text(program.leaves, instruction.opcode, instruction.a);
    }
  }
  return {};
}

/// Whether p is more than M v, for an M that is constant.
bool has_linear_terms(const CheckedModel& checked, const Program& program) {
  constexpr OutputKind momentum = OutputKind::momentum;
  if (!leaf_read(program, momentum, Opcode::coordinate | Opcode::time).empty()) return true;
  const State resting = nominal_state(checked.model, checked.scene);
  const auto at_rest =
      evaluate(program, *find_function(program, momentum), arguments_at<double>(resting));
  return std::ranges::any_of(at_rest, [](double p) { return p != 0; });
}

}  // namespace

std::string not_separable(const CheckedModel& checked, const Program& program) {
  if (const auto& rotations = checked.model.rotations; !rotations.empty()) {
    return fmt::format("`{}` is a rotation", rotations.front().name);
  }
  const std::string of_mass = leaf_read(program, OutputKind::mass_matrix,
                                        Opcode::coordinate | Opcode::time | Opcode::velocity);
  if (!of_mass.empty()) return fmt::format("M depends on `{}`", of_mass);
  if (has_linear_terms(checked, program)) return "L has terms linear in the rates";
  const std::string of_bias = leaf_read(program, OutputKind::bias, Opcode::velocity);
  return of_bias.empty() ? "" : fmt::format("a force depends on `{}`", of_bias);
}

}  // namespace elgen
