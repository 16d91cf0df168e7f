// energy_sum: see energy_sum.hpp. Both energies are appended to one function, nothing twice.
#include "choose/energy_sum.hpp"

#include "elgen/evaluate.hpp"
#include "numbers/exact_number.hpp"
#include "numbers/random.hpp"
#include "program/network/instructions.hpp"

namespace elgen {
namespace {

/// Random points, with parameters of their own: at its value one may hide a part in the rates.
constexpr std::size_t compared_points = 3;

const Function* find_before(const Program& program, std::size_t index, OutputKind kind) {
  for (std::size_t i = 0; i < index; ++i) {
    if (program.functions[i].kind == kind) return &program.functions[i];
  }
  return nullptr;
}

/// The place of the only entry of `from`, whose instructions are appended.
std::uint32_t append(Instructions& instructions, Function& to, const Function& from) {
  std::vector<std::uint32_t> places;
  for (std::uint32_t at = 0; at < from.instructions.size(); ++at) {
    Instruction i = from.instructions[at];
    if (operand_count(i) > 0) i.a = places[i.a];
    if (operand_count(i) > 1) i.b = places[i.b];
    places.push_back(instructions.add(i));
    if (to.names[places.back()].empty()) to.names[places.back()] = from.names[at];
  }
  return places[from.fields.front().entries.front()];
}

/// Exactly; false where either has no value.
bool is_same_energy(const Program& recursive, std::size_t index, const Program& chosen,
                    const Function& sum) {
  static const Real negligible(power_of_ten(-45));
  Random random(1);
  for (std::size_t i = 0; i < compared_points; ++i) {
    const auto point =
        draw_leaves(recursive.leaves, [&] { return Real(cln::abs(random.rational())); });
    const Real own = evaluate(recursive, recursive.functions[index], point).front();
    const Real other = evaluate(chosen, sum, point).front();
    const Real apart = abs(own - other);
    if (!apart.is_defined()) return false;
    if (apart.value() > ((abs(own) + abs(other)) * negligible).value()) return false;
  }
  return true;
}

}  // namespace

std::optional<Function> energy_sum(const Program& recursive, const Program& chosen,
                                   std::size_t index) {
  const Function& total = recursive.functions[index];
  if (total.kind != OutputKind::total_energy) return std::nullopt;
  const Function* const kinetic = find_before(chosen, index, OutputKind::kinetic_energy);
  const Function* const potential = find_before(chosen, index, OutputKind::potential_energy);
  if (kinetic == nullptr || potential == nullptr) return std::nullopt;
  Function sum = total;
  sum.instructions.clear();
  sum.names.clear();
  Instructions instructions(sum);
  const std::uint32_t t = append(instructions, sum, *kinetic);
  const std::uint32_t v = append(instructions, sum, *potential);
  sum.fields.front().entries = {instructions.add(Opcode::add, t, v)};
  if (!is_same_energy(recursive, index, chosen, sum)) return std::nullopt;
  return sum;
}

}  // namespace elgen
