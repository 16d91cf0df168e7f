// The class of each value, found in one pass.
#include "program/network/analytic.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "elgen/fold.hpp"

namespace elgen {
namespace {

/// Each class contains the next.
enum class Kind : std::uint8_t { unknown, analytic, smooth, nonnegative, positive };

bool is_smooth(Kind x) { return x >= Kind::smooth; }
bool is_positive(Kind x) { return x == Kind::positive; }

/// Rules of fold.hpp. No operand is unknown, because unknowns were replaced by variables.
struct KindRules {
  const LeafNames& leaves;

  [[nodiscard]] static Kind constant(const Constant& x) {
    if (cln::plusp(x.value)) return Kind::positive;
    return is_rational(x) && cln::zerop(x.value) ? Kind::nonnegative : Kind::smooth;
  }
  [[nodiscard]] Kind leaf(Opcode kind, std::uint32_t number) const {
    if (kind != Opcode::parameter) return Kind::smooth;
    const Assumption assumption = assumption_of(leaves, number);
    if (assumption == Assumption::positive) return Kind::positive;
    return assumption == Assumption::nonnegative ? Kind::nonnegative : Kind::smooth;
  }
  [[nodiscard]] static Kind negate(Kind x) { return std::min(x, Kind::smooth); }
  [[nodiscard]] static Kind add(Kind x, Kind y) {
    const Kind least = std::min(x, y);
    return least == Kind::nonnegative ? std::max(x, y) : least;
  }
  [[nodiscard]] static Kind subtract(Kind x, Kind y) { return std::min({x, y, Kind::smooth}); }
  [[nodiscard]] static Kind multiply(Kind x, Kind y) { return std::min(x, y); }
  [[nodiscard]] static Kind divide(Kind x, Kind y) { return is_positive(y) ? x : Kind::analytic; }
  [[nodiscard]] static Kind square_root(Kind x) {
    return is_positive(x) ? Kind::positive : Kind::unknown;
  }
  [[nodiscard]] static Kind call(FunctionId function, Kind x, Kind y) {
    const FunctionRow& row = function_row(function);
    const Kind last = row.arity == 2 ? y : x;
    switch (row.smoothness) {
      case Smoothness::everywhere:
        return std::min(x, Kind::smooth);
      case Smoothness::positive:
        return is_smooth(x) ? Kind::positive : Kind::analytic;
      case Smoothness::poles:
        return Kind::analytic;
      case Smoothness::real:
        return is_smooth(x) ? Kind::smooth : Kind::unknown;
      case Smoothness::half_plane:
        return is_smooth(x) && is_positive(last) ? Kind::smooth : Kind::unknown;
      case Smoothness::branches:
        return Kind::unknown;
    }
    return Kind::unknown;
  }
};

/// Detects squares: x y x is x^2 y, whatever the order of its factors.
class SignAnalysis {
 public:
  /// The next instruction's kind: a smooth product of even powers becomes nonnegative.
  Kind refined_kind(const Instruction& i, Kind kind) {
    const auto at = static_cast<std::uint32_t>(odd_factors_.size());
    std::vector<std::uint32_t> odd = factors(i);
    if (kind == Kind::smooth && i.opcode == Opcode::multiply && odd.empty()) {
      kind = Kind::nonnegative;
    }
    const bool is_product = i.opcode == Opcode::multiply || i.opcode == Opcode::divide;
    if (kind == Kind::smooth && (!is_product || odd.size() > most_factors)) odd = {at};
    if (kind != Kind::smooth) odd.clear();
    odd_factors_.push_back(std::move(odd));
    return kind;
  }

 private:
  /// A product with more factors counts as one factor, so that chains of products do not take
  /// quadratic time.
  static constexpr std::size_t most_factors = 16;

  [[nodiscard]] std::vector<std::uint32_t> factors(const Instruction& i) const {
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

std::vector<bool> unknowns(const Program& program, const Function& function) {
  const KindRules rules{program.leaves};
  std::vector<bool> result;
  std::vector<Kind> kinds;
  SignAnalysis signs;
  for (const Instruction& i : function.instructions) {
    const Kind kind = fold_instruction(rules, program, i, kinds);
    result.push_back(kind == Kind::unknown);
    kinds.push_back(signs.refined_kind(i, kind == Kind::unknown ? Kind::smooth : kind));
  }
  return result;
}

}  // namespace elgen
