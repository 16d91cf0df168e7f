// present: runs a Program on closed forms instead of numbers.
//
//     0 = sin theta   1 = multiply 0 0   2 = cos theta   3 = multiply 2 2   4 = add 1 3   ->   1
//
// If the program `whole_sums` lists sums that may stay unexpanded ("whole"), every value has two
// forms: one fully expanded, by which these sums are recognised, and one in which these sums stay
// unexpanded.
#include <algorithm>
#include <memory>
#include <utility>

#include "elgen/closed_forms.hpp"
#include "elgen/fold.hpp"
#include "forms/present/arithmetic.hpp"
#include "forms/present/polynomial.hpp"

namespace elgen {

namespace {

/// Long programs have closed forms that exceed any budget. Beyond `short_program` instructions the
/// budget therefore falls with the square of the length. A failed attempt then costs less than
/// lowering the program did.
std::size_t budget_of(const Function& function, const PresentBudget& budget) {
  constexpr double short_program = 500;
  const double length = std::max(static_cast<double>(function.instructions.size()), short_program);
  const double share = short_program / length;
  return static_cast<std::size_t>(static_cast<double>(budget.products_per_function) * share *
                                  share);
}

bool is_plain(const Algebra& algebra, const Monomial& monomial) {
  return std::ranges::all_of(monomial, [&algebra](const AtomPower& factor) {
    const AtomKind kind = algebra.atoms[factor.atom].kind;
    return kind == AtomKind::leaf || kind == AtomKind::pi;
  });
}

ZeroProof proof_of(const Algebra& algebra, const std::optional<Fraction>& form) {
  if (!form) return ZeroProof::open;
  if (form->numerator.empty()) return ZeroProof::zero;
  const bool is_decided = std::ranges::all_of(form->numerator, [&algebra](const auto& term) {
    return std::ranges::all_of(term.first, [&algebra](const AtomPower& factor) {
      return is_independent(algebra, factor.atom);
    });
  });
  return is_decided ? ZeroProof::not_zero : ZeroProof::open;
}

/// One verdict per entry of functions[0], the only function.
std::vector<ZeroProof> proofs_of(const ClosedForms& forms) {
  std::vector<ZeroProof> result;
  for (const ClosedField& field : forms.functions[0].fields) {
    for (const std::optional<Fraction>& form : field.entries) {
      result.push_back(proof_of(forms.algebra, form));
    }
  }
  return result;
}

Algebra algebra_of_proofs() { return {.has_quotients = true, .has_exponentials = true}; }

/// Whether a summary, a function whose entries repeat entries of other functions, gets closed
/// forms.
enum class Repeats : std::uint8_t { left_out, presented };

/// Appends the closed forms of all entries of all functions, within one budget.
/// values_of(arithmetic, function) returns the values of all instructions.
template <class ValuesOf>
void present_functions(const Program& program, const PresentBudget& budget, ClosedForms& forms,
                       const ValuesOf& values_of, Repeats repeats = Repeats::left_out) {
  std::size_t left = budget.products;
  for (const Function& function : program.functions) {
    ClosedFunction& closed = forms.functions.emplace_back();
    if (repeats == Repeats::left_out && output_row(function.kind).is_summary) continue;
    const std::size_t share = std::min(left, budget_of(function, budget));
    Arithmetic arithmetic(forms.algebra, share, budget.terms);
    // A function with a repeated block gets no closed forms, because they would contain M^-1.
    const bool is_open = function.repeated.count > 0;
    const std::vector<Value> values = is_open ? std::vector<Value>(function.instructions.size())
                                              : values_of(arithmetic, function);
    for (const Field& field : function.fields) {
      ClosedField& entries = closed.fields.emplace_back(ClosedField{field.name, {}});
      for (const std::uint32_t entry : field.entries) entries.entries.push_back(values[entry]);
    }
    left -= share - arithmetic.work();
  }
}

ClosedForms present_over(Algebra algebra, const Program& program, const PresentBudget& budget,
                         Repeats repeats = Repeats::left_out) {
  ClosedForms forms{std::move(algebra), {}};
  const auto values_of = [&program](Arithmetic& arithmetic, const Function& function) {
    return fold<Value>(arithmetic, program, function);
  };
  present_functions(program, budget, forms, values_of, repeats);
  return forms;
}

/// A value fully expanded, and with some sums unexpanded ("whole").
struct PlainAndWhole {
  Value plain = {};
  Value whole = {};
};

/// Folding rules (fold.hpp) for values in both forms.
class WholeArithmetic {
 public:
  WholeArithmetic(Arithmetic& arithmetic, const std::vector<Value>& sums)
      : arithmetic_(arithmetic), sums_(sums) {}

  [[nodiscard]] PlainAndWhole constant(const Constant& value) {
    return same_in_both(arithmetic_.constant(value));
  }
  [[nodiscard]] PlainAndWhole leaf(Opcode kind, std::uint32_t number) {
    return same_in_both(arithmetic_.leaf(kind, number));
  }
  [[nodiscard]] PlainAndWhole negate(const PlainAndWhole& x) {
    return {arithmetic_.negate(x.plain), arithmetic_.negate(x.whole)};
  }
  [[nodiscard]] PlainAndWhole add(const PlainAndWhole& x, const PlainAndWhole& y) {
    return shorter({arithmetic_.add(x.plain, y.plain), arithmetic_.add(x.whole, y.whole)});
  }
  [[nodiscard]] PlainAndWhole subtract(const PlainAndWhole& x, const PlainAndWhole& y) {
    return add(x, negate(y));
  }
  [[nodiscard]] PlainAndWhole multiply(const PlainAndWhole& x, const PlainAndWhole& y) {
    return {arithmetic_.multiply(x.plain, y.plain), arithmetic_.multiply(x.whole, y.whole)};
  }
  [[nodiscard]] PlainAndWhole divide(const PlainAndWhole& x, const PlainAndWhole& y) {
    return {arithmetic_.divide(x.plain, y.plain), arithmetic_.divide(x.whole, y.whole)};
  }
  [[nodiscard]] PlainAndWhole square_root(const PlainAndWhole& x) {
    return {arithmetic_.square_root(x.plain), arithmetic_.square_root(x.whole)};
  }
  [[nodiscard]] PlainAndWhole call(FunctionId function, const PlainAndWhole& x,
                                   const PlainAndWhole& y) {
    return {arithmetic_.call(function, x.plain, y.plain),
            arithmetic_.call(function, x.whole, y.whole)};
  }

 private:
  static PlainAndWhole same_in_both(const Value& x) { return {x, x}; }

  /// If x is a rational multiple of a whole sum, x.whole becomes this multiple. Otherwise x.whole
  /// becomes x.plain if x.plain has fewer terms.
  PlainAndWhole shorter(PlainAndWhole x) {
    if (!x.plain || x.plain->numerator.empty()) return same_in_both(x.plain);
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
  const std::vector<Value>& sums_;  ///< expanded forms of the whole sums
};

/// The expanded forms of the sums of typed_sums().
std::vector<Value> plain_forms(Arithmetic& arithmetic, const Program& sums) {
  std::vector<Value> forms;
  for (const Function& sum : sums.functions) {
    forms.push_back(entries_of(sum, fold<Value>(arithmetic, sums, sum)).front());
  }
  return forms;
}

}  // namespace

bool is_independent(const Algebra& algebra, AtomId id) {
  const Atom& atom = algebra.atoms[id];
  if (atom.kind == AtomKind::leaf || atom.kind == AtomKind::pi) return true;
  return atom.kind == AtomKind::circular && atom.divisor == angle_parts &&
         is_plain(algebra, atom.arguments[0].numerator.begin()->first);
}

ClosedForms present(const Program& program, const PresentBudget& budget) {
  return present_over({}, program, budget);
}

ClosedForms present_quotients(const Program& program, const PresentBudget& budget) {
  return present_over({.has_quotients = true}, program, budget);
}

ClosedForms present_for_proofs(const Program& program, const PresentBudget& budget) {
  return present_over(algebra_of_proofs(), program, budget);
}

bool is_rewritten_for_proofs(FunctionId function) {
  return function == FunctionId::stumpff || function == FunctionId::expm1 ||
         has_exponential_form(function);
}

ClosedForms present(const Program& program, Program whole_sums, const PresentBudget& budget) {
  ClosedForms forms;
  Arithmetic plain(forms.algebra, budget.products_per_function, budget.terms);
  const std::vector<Value> sums = plain_forms(plain, whole_sums);
  forms.algebra.sums = std::make_shared<const Program>(std::move(whole_sums));
  present_functions(program, budget, forms, [&](Arithmetic& arithmetic, const Function& function) {
    std::vector<Value> values;
    for (const PlainAndWhole& both :
         fold<PlainAndWhole>(WholeArithmetic(arithmetic, sums), program, function)) {
      values.push_back(both.whole);
    }
    return values;
  });
  return forms;
}

bool is_proved_equal(ClosedForms& forms, const Fraction& x, const Fraction& y) {
  Arithmetic arithmetic(forms.algebra, PresentBudget{}.products_per_function);
  const Value difference = arithmetic.subtract(x, y);
  return difference && difference->numerator.empty();
}

std::vector<ZeroProof> prove_zeros(const Program& program, Function function,
                                   const PresentBudget& budget) {
  const Program alone{program.leaves, program.constants, {std::move(function)}};
  const auto proofs = [&](const Algebra& algebra) {
    return proofs_of(present_over(algebra, alone, budget, Repeats::presented));
  };
  std::vector<ZeroProof> result = proofs({});
  const bool is_open = std::ranges::find(result, ZeroProof::open) != result.end();
  const bool has_other_forms = std::ranges::any_of(function_table(), [&](const FunctionRow& row) {
    return is_rewritten_for_proofs(row.id) && calls(alone, row.id);
  });
  if (!is_open || !has_other_forms) return result;
  const std::vector<ZeroProof> others = proofs(algebra_of_proofs());
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (result[i] == ZeroProof::open) result[i] = others[i];
  }
  return result;
}

}  // namespace elgen
