// The class of each value, found in one pass.
#include "program/network/analytic.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "elgen/fold.hpp"

namespace elgen {
namespace {

/// Each class contains the next.
enum class ValueClass : std::uint8_t { unknown, analytic, smooth, nonnegative, positive };

bool is_smooth(ValueClass x) { return x >= ValueClass::smooth; }
bool is_positive(ValueClass x) { return x == ValueClass::positive; }

/// Rules of fold.hpp. No operand is unknown, because unknowns were replaced by variables.
struct ValueClassRules {
  const LeafNames& leaves;

  [[nodiscard]] static ValueClass constant(const Constant& x) {
    if (cln::plusp(x.value)) return ValueClass::positive;
    return is_rational(x) && cln::zerop(x.value) ? ValueClass::nonnegative : ValueClass::smooth;
  }
  [[nodiscard]] ValueClass leaf(Opcode kind, std::uint32_t number) const {
    if (kind != Opcode::parameter) return ValueClass::smooth;
    const Assumption assumption = assumption_of(leaves, number);
    if (assumption == Assumption::positive) return ValueClass::positive;
    return assumption == Assumption::nonnegative ? ValueClass::nonnegative : ValueClass::smooth;
  }
  [[nodiscard]] static ValueClass negate(ValueClass x) { return std::min(x, ValueClass::smooth); }
  [[nodiscard]] static ValueClass add(ValueClass x, ValueClass y) {
    const ValueClass least = std::min(x, y);
    return least == ValueClass::nonnegative ? std::max(x, y) : least;
  }
  [[nodiscard]] static ValueClass subtract(ValueClass x, ValueClass y) {
    return std::min({x, y, ValueClass::smooth});
  }
  [[nodiscard]] static ValueClass multiply(ValueClass x, ValueClass y) { return std::min(x, y); }
  [[nodiscard]] static ValueClass divide(ValueClass x, ValueClass y) {
    return is_positive(y) ? x : ValueClass::analytic;
  }
  [[nodiscard]] static ValueClass square_root(ValueClass x) {
    return is_positive(x) ? ValueClass::positive : ValueClass::unknown;
  }
  [[nodiscard]] static ValueClass call(FunctionId function, ValueClass x, ValueClass y) {
    const FunctionRow& row = function_row(function);
    const ValueClass last = row.arity == 2 ? y : x;
    switch (row.smoothness) {
      case Smoothness::entire:
        return std::min(x, ValueClass::smooth);
      case Smoothness::entire_positive:
        return is_smooth(x) ? ValueClass::positive : ValueClass::analytic;
      case Smoothness::meromorphic:
        return ValueClass::analytic;
      case Smoothness::real_analytic:
        return is_smooth(x) ? ValueClass::smooth : ValueClass::unknown;
      case Smoothness::half_plane:
        return is_smooth(x) && is_positive(last) ? ValueClass::smooth : ValueClass::unknown;
      case Smoothness::branches:
        return ValueClass::unknown;
    }
    return ValueClass::unknown;
  }
};

/// Detects squares in products, whatever the order of the factors: x y x is x^2 y.
class SignAnalysis {
 public:
  /// The refined class of the next instruction: a smooth product of even powers is nonnegative.
  ValueClass refine_class(const Instruction& i, ValueClass kind) {
    const auto at = static_cast<std::uint32_t>(odd_factors_.size());
    std::vector<std::uint32_t> odd = odd_factors(i);
    if (kind == ValueClass::smooth && i.opcode == Opcode::multiply && odd.empty()) {
      kind = ValueClass::nonnegative;
    }
    const bool is_product = i.opcode == Opcode::multiply || i.opcode == Opcode::divide;
    if (kind == ValueClass::smooth && (!is_product || odd.size() > most_factors)) odd = {at};
    if (kind != ValueClass::smooth) odd.clear();
    odd_factors_.push_back(std::move(odd));
    return kind;
  }

 private:
  /// A product with more factors counts as one factor, so that chains of products do not take
  /// quadratic time.
  static constexpr std::size_t most_factors = 16;

  [[nodiscard]] std::vector<std::uint32_t> odd_factors(const Instruction& i) const {
    if (i.opcode == Opcode::divide) return odd_factors_[i.a];  // smooth only if i.b is positive
    if (i.opcode != Opcode::multiply) return {};
    std::vector<std::uint32_t> odd;
    std::ranges::set_symmetric_difference(odd_factors_[i.a], odd_factors_[i.b],
                                          std::back_inserter(odd));
    return odd;
  }

  /// For each smooth value that may be negative: its possibly negative factors with odd exponents.
  std::vector<std::vector<std::uint32_t>> odd_factors_ = {};
};

}  // namespace

std::vector<bool> mark_unknown_values(const Program& program, const Function& function) {
  const ValueClassRules rules{program.leaves};
  std::vector<bool> result;
  std::vector<ValueClass> kinds;
  SignAnalysis signs;
  for (const Instruction& i : function.instructions) {
    const ValueClass kind = fold_instruction(rules, program, i, kinds);
    result.push_back(kind == ValueClass::unknown);
    kinds.push_back(signs.refine_class(i, kind == ValueClass::unknown ? ValueClass::smooth : kind));
  }
  return result;
}

}  // namespace elgen
