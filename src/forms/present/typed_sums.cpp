// typed_sums: see elgen/closed_forms.hpp. Two sums are the same if their closed forms are equal up
// to a rational factor.
#include <algorithm>

#include "elgen/closed_forms.hpp"
#include "elgen/fold.hpp"
#include "forms/present/arithmetic.hpp"
#include "forms/present/polynomial.hpp"

namespace elgen {
namespace {

bool is_product(const Instruction& i) {
  return i.opcode == Opcode::multiply || i.opcode == Opcode::divide;
}

/// True for sin, cos and tan. Their angles become exponentials of single terms, so no sum in an
/// angle can stay unexpanded.
bool takes_angle(FunctionId function) {
  return is_circular(function) || function == FunctionId::tan;
}

/// Finds the sums that contain a coordinate or t and are factors of a square, a radicand, a
/// denominator or an argument of a function.
class SumSearch {
 public:
  explicit SumSearch(const Function& function)
      : function_(function), depends_on_motion_(function.instructions.size()) {
    for (std::uint32_t at = 0; at < depends_on_motion_.size(); ++at) {
      const Instruction& i = function.instructions[at];
      depends_on_motion_[at] = i.opcode == Opcode::coordinate || i.opcode == Opcode::time;
      for (std::size_t k = 0; k < operand_count(i); ++k) {
        if (depends_on_motion_[k == 0 ? i.a : i.b]) depends_on_motion_[at] = true;
      }
      search_operands(i);
    }
  }

  std::vector<std::uint32_t> found = {};

 private:
  void search_operands(const Instruction& i) {
    if (i.opcode == Opcode::square_root) add_sum_factors(i.a);
    if (i.opcode == Opcode::divide) add_sum_factors(i.b);
    if (i.opcode == Opcode::multiply && i.a == i.b) add_sum_factors(i.a);
    if (i.opcode != Opcode::call || takes_angle(i.function)) return;
    for (std::size_t k = 0; k < operand_count(i); ++k) add_sum_factors(k == 0 ? i.a : i.b);
  }

  void add_sum_factors(std::uint32_t at) {
    const Instruction& i = function_.instructions[at];
    if (is_product(i)) add_sum_factors(i.b);
    if (is_product(i) || i.opcode == Opcode::negate) return add_sum_factors(i.a);
    if (is_sum(i) && depends_on_motion_[at] && std::ranges::find(found, at) == found.end())
      found.push_back(at);
  }

  const Function& function_;
  std::vector<bool> depends_on_motion_;
};

}  // namespace

Program unexpanded_sums(const Program& program) {
  Program sums{program.leaves, program.constants, {}};
  Algebra algebra;
  Arithmetic arithmetic(algebra);
  std::vector<OptionalFraction> known;
  for (const Function& function : program.functions) {
    const std::vector<std::uint32_t> found = SumSearch(function).found;
    if (found.empty()) continue;
    const std::vector<OptionalFraction> values =
        fold<OptionalFraction>(arithmetic, program, function);
    for (const std::uint32_t at : found) {
      const OptionalFraction& value = values[at];
      if (!value || value->numerator.size() < 2) continue;
      const bool is_known = std::ranges::any_of(known, [&](const OptionalFraction& other) {
        return other->denominator == value->denominator &&
               ratio_of(value->numerator, other->numerator);
      });
      if (is_known) continue;
      known.push_back(value);
      sums.functions.push_back(with_entries(function, {at}));
    }
  }
  return sums;
}

}  // namespace elgen
