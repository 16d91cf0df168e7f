// energy_sum: see energy_sum.hpp. Appends the instructions of both energies to one function; common
// subexpressions appear once.
#include "choose/energy_sum.hpp"

#include "elgen/evaluate.hpp"
#include "numbers/exact_number.hpp"
#include "program/network/instructions.hpp"
#include "sample/points.hpp"

namespace elgen {
namespace {

/// The number of random points. Parameters are random too, because particular values could hide a
/// term with rates.
constexpr std::size_t compared_points = 3;

const Function* find_earlier_function(const Program& program, std::size_t index, OutputKind kind) {
  for (std::size_t i = 0; i < index; ++i) {
    if (program.functions[i].kind == kind) return &program.functions[i];
  }
  return nullptr;
}

/// True if both energies have equal values at all random points, in 64 digits. False also if a
/// value is undefined.
bool is_same_energy(const Program& recursive, std::size_t index, const Program& chosen,
                    const Function& sum) {
  static const Real negligible(power_of_ten(-45));
  Sampler draw(1);
  for (std::size_t i = 0; i < compared_points; ++i) {
    const auto point = map_leaves([](const cln::cl_RA& x) { return Real(cln::abs(x)); },
                                  draw.point(recursive.leaves));
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
  // This branch on a kind is needed: no other output is the sum of two outputs.
  if (total.kind != OutputKind::total_energy) return std::nullopt;
  const Function* const kinetic = find_earlier_function(chosen, index, OutputKind::kinetic_energy);
  const Function* const potential =
      find_earlier_function(chosen, index, OutputKind::potential_energy);
  if (kinetic == nullptr || potential == nullptr) return std::nullopt;
  Function sum = total;
  sum.instructions.clear();
  sum.names.clear();
  InstructionBuilder instructions(sum);
  const auto entry_of = [&instructions](const Function& energy) {
    return instructions.add_all(energy)[energy.fields.front().entries.front()];
  };
  const std::uint32_t t = entry_of(*kinetic);
  const std::uint32_t v = entry_of(*potential);
  sum.fields.front().entries = {instructions.add(Opcode::add, t, v)};
  if (!is_same_energy(recursive, index, chosen, sum)) return std::nullopt;
  return sum;
}

}  // namespace elgen
