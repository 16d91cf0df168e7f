// The sums that a program has as they were typed, and closed forms in which some of them stay
// whole.
//
// Every value is kept twice: multiplied out, by which a sum is found again, and with whole sums.
#include <algorithm>
#include <memory>
#include <utility>

#include "elgen/fold.hpp"
#include "forms/present/polynomial.hpp"
#include "forms/present/present.hpp"

namespace elgen {
namespace {

bool is_product(const Instruction& i) {
  return i.opcode == Opcode::multiply || i.opcode == Opcode::divide;
}

/// Angles are taken apart into exponentials, and sums of them are written as such.
bool takes_angle(FunctionId function) {
  return is_circular(function) || function == FunctionId::tan;
}

/// Finds the sums under powers, roots, quotients and functions of one function.
class SumSearch {
 public:
  explicit SumSearch(const Function& function)
      : function_(function), moves_(function.instructions.size()) {
    for (std::uint32_t at = 0; at < moves_.size(); ++at) {
      const Instruction& i = function.instructions[at];
      moves_[at] = i.opcode == Opcode::coordinate || i.opcode == Opcode::time;
      for (std::size_t k = 0; k < operand_count(i); ++k) {
        if (moves_[k == 0 ? i.a : i.b]) moves_[at] = true;
      }
      search(i);
    }
  }

  std::vector<std::uint32_t> found = {};

 private:
  void search(const Instruction& i) {
    if (i.opcode == Opcode::square_root) add_factors(i.a);
    if (i.opcode == Opcode::divide) add_factors(i.b);
    if (i.opcode == Opcode::multiply && i.a == i.b) add_factors(i.a);
    if (i.opcode != Opcode::call || takes_angle(i.function)) return;
    for (std::size_t k = 0; k < operand_count(i); ++k) add_factors(k == 0 ? i.a : i.b);
  }

  void add_factors(std::uint32_t at) {
    const Instruction& i = function_.instructions[at];
    if (is_product(i)) add_factors(i.b);
    if (is_product(i) || i.opcode == Opcode::negate) return add_factors(i.a);
    if (is_sum(i) && moves_[at] && std::ranges::find(found, at) == found.end()) found.push_back(at);
  }

  const Function& function_;
  std::vector<bool> moves_;
};

/// x, and x with whole sums.
struct Both {
  Value plain = {};
  Value whole = {};
};

/// The rules of fold.hpp.
class WholeArithmetic {
 public:
  WholeArithmetic(Arithmetic& arithmetic, const std::vector<Value>& sums)
      : arithmetic_(arithmetic), sums_(sums) {}

  [[nodiscard]] Both constant(const Constant& value) { return alike(arithmetic_.constant(value)); }
  [[nodiscard]] Both leaf(Opcode kind, std::uint32_t number) {
    return alike(arithmetic_.leaf(kind, number));
  }
  [[nodiscard]] Both negate(const Both& x) {
    return {arithmetic_.negate(x.plain), arithmetic_.negate(x.whole)};
  }
  [[nodiscard]] Both add(const Both& x, const Both& y) {
    return shorter({arithmetic_.add(x.plain, y.plain), arithmetic_.add(x.whole, y.whole)});
  }
  [[nodiscard]] Both subtract(const Both& x, const Both& y) { return add(x, negate(y)); }
  [[nodiscard]] Both multiply(const Both& x, const Both& y) {
    return {arithmetic_.multiply(x.plain, y.plain), arithmetic_.multiply(x.whole, y.whole)};
  }
  [[nodiscard]] Both divide(const Both& x, const Both& y) {
    return {arithmetic_.divide(x.plain, y.plain), arithmetic_.divide(x.whole, y.whole)};
  }
  [[nodiscard]] Both square_root(const Both& x) {
    return {arithmetic_.square_root(x.plain), arithmetic_.square_root(x.whole)};
  }
  [[nodiscard]] Both call(FunctionId function, const Both& x, const Both& y) {
    return {arithmetic_.call(function, x.plain, y.plain),
            arithmetic_.call(function, x.whole, y.whole)};
  }

 private:
  static Both alike(const Value& x) { return {x, x}; }

  /// One whole sum, its negative, or the shorter one of both values.
  Both shorter(Both x) {
    if (!x.plain || x.plain->numerator.empty()) return alike(x.plain);
    for (std::uint32_t i = 0; i < sums_.size(); ++i) {
      if (!sums_[i] || sums_[i]->denominator != x.plain->denominator) continue;
      const auto ratio = ratio_of(x.plain->numerator, sums_[i]->numerator);
      if (!ratio) continue;
      x.whole = arithmetic_.multiply(fraction_of(*ratio), arithmetic_.whole_sum(i, *sums_[i]));
      return x;
    }
    if (!x.whole || x.plain->numerator.size() < x.whole->numerator.size()) x.whole = x.plain;
    return x;
  }

  Arithmetic& arithmetic_;
  const std::vector<Value>& sums_;  ///< multiplied out
};

/// The sums of typed_sums() multiplied out.
std::vector<Value> plain_forms(Arithmetic& arithmetic, const Program& sums) {
  std::vector<Value> forms;
  for (const Function& sum : sums.functions) {
    forms.push_back(entries_of(sum, fold<Value>(arithmetic, sums, sum)).front());
  }
  return forms;
}

}  // namespace

Program typed_sums(const Program& program) {
  Program sums{program.leaves, program.constants, {}};
  Algebra algebra;
  Arithmetic arithmetic(algebra);
  std::vector<Value> known;
  for (const Function& function : program.functions) {
    const std::vector<std::uint32_t> found = SumSearch(function).found;
    if (found.empty()) continue;
    const std::vector<Value> values = fold<Value>(arithmetic, program, function);
    for (const std::uint32_t at : found) {
      const Value& value = values[at];
      if (!value || value->numerator.size() < 2) continue;
      const bool is_known = std::ranges::any_of(known, [&](const Value& other) {
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

ClosedForms present(const Program& program, Program whole_sums, const PresentBudget& budget) {
  ClosedForms forms;
  Arithmetic plain(forms.algebra, budget.products_per_function, budget.terms);
  const std::vector<Value> sums = plain_forms(plain, whole_sums);
  forms.algebra.sums = std::make_shared<const Program>(std::move(whole_sums));
  present_functions(program, budget, forms, [&](Arithmetic& arithmetic, const Function& function) {
    std::vector<Value> values;
    for (const Both& both : fold<Both>(WholeArithmetic(arithmetic, sums), program, function)) {
      values.push_back(both.whole);
    }
    return values;
  });
  return forms;
}

}  // namespace elgen
