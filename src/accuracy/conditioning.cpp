// conditioning: every instruction's slopes by its operands once, then one sweep for each value.
#include "accuracy/conditioning.hpp"

#include <utility>

namespace elgen {
namespace {

/// Operands, of which one moves.
struct OneMoves {
  const std::vector<Real>& values;
  std::uint32_t moving;

  [[nodiscard]] Dual<Real> operator[](std::uint32_t at) const {
    return {values[at], Real(at == moving ? 1 : 0)};
  }
};

}  // namespace

Conditioning::Conditioning(const Program& program, const Function& function,
                           std::vector<Real> values, std::vector<bool> parameters)
    : program_(program),
      function_(function),
      values_(std::move(values)),
      parameters_(std::move(parameters)) {
  slopes_.reserve(values_.size());
  for (const Instruction& i : function.instructions) {
    const std::size_t operands = operand_count(i);
    Slopes& slopes = slopes_.emplace_back();
    if (operands > 0) slopes.by_a = slope(i, i.a);
    if (operands > 1 && i.b != i.a) slopes.by_b = slope(i, i.b);
  }
}

Real Conditioning::slope(const Instruction& i, std::uint32_t operand) const {
  static const Arguments<Dual<Real>> no_leaves;
  const interpreter::NumberRules<Dual<Real>> rules{no_leaves};
  return folded(rules, program_, i, OneMoves{values_, operand}).slope;
}

bool Conditioning::counts(const Instruction& i) const {
  if (i.opcode == Opcode::constant) return !parameters_.empty() && parameters_[i.a];
  return is_leaf(i.opcode);
}

Real Conditioning::of(std::uint32_t instruction) const {
  std::vector<Real> adjoints(instruction + 1, Real());
  adjoints[instruction] = Real(1);
  Real sum;
  for (std::size_t at = instruction + 1; at-- > 0;) {
    const Instruction& i = function_.instructions[at];
    const Real adjoint = adjoints[at];
    if (is_zero(adjoint)) continue;
    if (counts(i)) sum = sum + abs(adjoint * values_[at]);
    const std::size_t operands = operand_count(i);
    if (operands > 0) adjoints[i.a] = adjoints[i.a] + adjoint * slopes_[at].by_a;
    if (operands > 1) adjoints[i.b] = adjoints[i.b] + adjoint * slopes_[at].by_b;
  }
  return sum;
}

}  // namespace elgen
