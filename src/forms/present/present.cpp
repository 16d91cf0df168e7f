// present: runs a Program on closed forms instead of numbers.
//
//     0 = sin theta   1 = multiply 0 0   2 = cos theta   3 = multiply 2 2   4 = add 1 3   ->   1
//
// If the caller lists sums that may stay unexpanded, every value has two forms: a fully expanded
// form, by which these sums are recognised, and a form in which these sums stay unexpanded.
#include <algorithm>
#include <memory>
#include <utility>

#include "elgen/closed_forms.hpp"
#include "elgen/fold.hpp"
#include "forms/present/arithmetic.hpp"
#include "forms/present/polynomial.hpp"

namespace elgen {

namespace {

/// The most products of terms for `function`. Long functions have closed forms that exceed any
/// budget. Beyond `short_program` instructions the budget therefore falls with the square of the
/// length. A failed attempt then costs less than the lowering of `function`.
std::size_t budget_of(const Function& function, const ClosedFormBudget& budget) {
  constexpr double short_program = 500;
  const double length = std::max(static_cast<double>(function.instructions.size()), short_program);
  const double share = short_program / length;
  return static_cast<std::size_t>(static_cast<double>(budget.products_per_function) * share *
                                  share);
}

bool is_product_of_leaves(const Algebra& algebra, const Monomial& monomial) {
  return std::ranges::all_of(monomial, [&algebra](const AtomPower& factor) {
    const AtomKind kind = algebra.atoms[factor.atom].kind;
    return kind == AtomKind::leaf || kind == AtomKind::pi;
  });
}

ZeroProof zero_proof(const Algebra& algebra, const std::optional<Fraction>& form) {
  if (!form) return ZeroProof::undecided;
  if (form->numerator.empty()) return ZeroProof::zero;
  const bool is_decided = std::ranges::all_of(form->numerator, [&algebra](const auto& term) {
    return std::ranges::all_of(term.first, [&algebra](const AtomPower& factor) {
      return is_independent(algebra, factor.atom);
    });
  });
  return is_decided ? ZeroProof::not_zero : ZeroProof::undecided;
}

/// One verdict per entry of functions[0], the only function.
std::vector<ZeroProof> zero_proofs(const ClosedForms& forms) {
  std::vector<ZeroProof> result;
  for (const ClosedField& field : forms.functions[0].fields) {
    for (const std::optional<Fraction>& form : field.entries) {
      result.push_back(zero_proof(forms.algebra, form));
    }
  }
  return result;
}

Algebra proof_algebra() { return {.has_quotients = true, .has_exponentials = true}; }

/// Whether a summary, a function whose entries repeat entries of other functions, gets closed
/// forms.
enum class SummaryHandling : std::uint8_t { skipped, presented };

/// Appends the closed forms of all entries of all functions, within one budget.
/// values_of(arithmetic, function) returns the values of all instructions.
template <class ValuesOf>
void present_functions(const Program& program, const ClosedFormBudget& budget, ClosedForms& forms,
                       const ValuesOf& values_of,
                       SummaryHandling repeats = SummaryHandling::skipped) {
  std::size_t left = budget.products;
  for (const Function& function : program.functions) {
    ClosedFunction& closed = forms.functions.emplace_back();
    if (repeats == SummaryHandling::skipped && output_row(function.kind).is_summary) continue;
    const std::size_t share = std::min(left, budget_of(function, budget));
    Arithmetic arithmetic(forms.algebra, share, budget.terms);
    // A function with a repeated block gets no closed forms, because they would contain M^-1.
    const bool is_open = function.repeated.count > 0;
    const std::vector<OptionalFraction> values =
        is_open ? std::vector<OptionalFraction>(function.instructions.size())
                : values_of(arithmetic, function);
    for (const Field& field : function.fields) {
      ClosedField& entries = closed.fields.emplace_back(ClosedField{field.name, {}});
      for (const std::uint32_t entry : field.entries) entries.entries.push_back(values[entry]);
    }
    left -= share - arithmetic.remaining_products();
  }
}

ClosedForms present_in_algebra(Algebra algebra, const Program& program,
                               const ClosedFormBudget& budget,
                               SummaryHandling repeats = SummaryHandling::skipped) {
  ClosedForms forms{std::move(algebra), {}};
  const auto values_of = [&program](Arithmetic& arithmetic, const Function& function) {
    return fold<OptionalFraction>(arithmetic, program, function);
  };
  present_functions(program, budget, forms, values_of, repeats);
  return forms;
}

/// The two forms of a value: fully expanded, and with the caller's sums unexpanded.
struct ExpansionPair {
  OptionalFraction expanded = {};
  OptionalFraction unexpanded = {};
};

/// Folding rules (fold.hpp) for values in both forms.
class ExpansionPairRules {
 public:
  ExpansionPairRules(Arithmetic& arithmetic, const std::vector<OptionalFraction>& sums)
      : arithmetic_(arithmetic), sums_(sums) {}

  [[nodiscard]] ExpansionPair constant(const Constant& value) {
    return make_equal_pair(arithmetic_.constant(value));
  }
  [[nodiscard]] ExpansionPair leaf(Opcode kind, std::uint32_t number) {
    return make_equal_pair(arithmetic_.leaf(kind, number));
  }
  [[nodiscard]] ExpansionPair negate(const ExpansionPair& x) {
    return {arithmetic_.negate(x.expanded), arithmetic_.negate(x.unexpanded)};
  }
  [[nodiscard]] ExpansionPair add(const ExpansionPair& x, const ExpansionPair& y) {
    return choose_shorter(
        {arithmetic_.add(x.expanded, y.expanded), arithmetic_.add(x.unexpanded, y.unexpanded)});
  }
  [[nodiscard]] ExpansionPair subtract(const ExpansionPair& x, const ExpansionPair& y) {
    return add(x, negate(y));
  }
  [[nodiscard]] ExpansionPair multiply(const ExpansionPair& x, const ExpansionPair& y) {
    return {arithmetic_.multiply(x.expanded, y.expanded),
            arithmetic_.multiply(x.unexpanded, y.unexpanded)};
  }
  [[nodiscard]] ExpansionPair divide(const ExpansionPair& x, const ExpansionPair& y) {
    return {arithmetic_.divide(x.expanded, y.expanded),
            arithmetic_.divide(x.unexpanded, y.unexpanded)};
  }
  [[nodiscard]] ExpansionPair square_root(const ExpansionPair& x) {
    return {arithmetic_.square_root(x.expanded), arithmetic_.square_root(x.unexpanded)};
  }
  [[nodiscard]] ExpansionPair call(FunctionId function, const ExpansionPair& x,
                                   const ExpansionPair& y) {
    return {arithmetic_.call(function, x.expanded, y.expanded),
            arithmetic_.call(function, x.unexpanded, y.unexpanded)};
  }

 private:
  static ExpansionPair make_equal_pair(const OptionalFraction& x) { return {x, x}; }

  /// If x is a rational multiple of one of `sums_`, x.unexpanded becomes this multiple. Otherwise
  /// x.unexpanded becomes x.expanded if x.expanded has fewer terms.
  ExpansionPair choose_shorter(ExpansionPair x) {
    if (!x.expanded || x.expanded->numerator.empty()) return make_equal_pair(x.expanded);
    for (std::uint32_t i = 0; i < sums_.size(); ++i) {
      if (!sums_[i] || sums_[i]->denominator != x.expanded->denominator) continue;
      const auto ratio = ratio_of(x.expanded->numerator, sums_[i]->numerator);
      if (!ratio) continue;
      x.unexpanded =
          arithmetic_.multiply(fraction_of(*ratio), arithmetic_.unexpanded_sum(i, *sums_[i]));
      return x;
    }
    if (!x.unexpanded || x.expanded->numerator.size() < x.unexpanded->numerator.size())
      x.unexpanded = x.expanded;
    return x;
  }

  Arithmetic& arithmetic_;
  const std::vector<OptionalFraction>& sums_;  ///< the caller's sums, in expanded form
};

/// The expanded form of each function of `sums`, a program that unexpanded_sums() returned.
std::vector<OptionalFraction> expanded_forms(Arithmetic& arithmetic, const Program& sums) {
  std::vector<OptionalFraction> forms;
  for (const Function& sum : sums.functions) {
    forms.push_back(entries_of(sum, fold<OptionalFraction>(arithmetic, sums, sum)).front());
  }
  return forms;
}

}  // namespace

bool is_independent(const Algebra& algebra, AtomId id) {
  const Atom& atom = algebra.atoms[id];
  if (atom.kind == AtomKind::leaf || atom.kind == AtomKind::pi) return true;
  return atom.kind == AtomKind::circular && atom.divisor == units_per_angle &&
         is_product_of_leaves(algebra, atom.arguments[0].numerator.begin()->first);
}

ClosedForms present(const Program& program, const ClosedFormBudget& budget) {
  return present_in_algebra({}, program, budget);
}

ClosedForms present_quotients(const Program& program, const ClosedFormBudget& budget) {
  return present_in_algebra({.has_quotients = true}, program, budget);
}

ClosedForms present_for_proofs(const Program& program, const ClosedFormBudget& budget) {
  return present_in_algebra(proof_algebra(), program, budget);
}

bool is_rewritten_for_proofs(FunctionId function) {
  return function == FunctionId::stumpff || function == FunctionId::expm1 ||
         has_exponential_form(function);
}

ClosedForms present(const Program& program, Program unexpanded_sums,
                    const ClosedFormBudget& budget) {
  ClosedForms forms;
  Arithmetic plain(forms.algebra, budget.products_per_function, budget.terms);
  const std::vector<OptionalFraction> sums = expanded_forms(plain, unexpanded_sums);
  forms.algebra.unexpanded_sums = std::make_shared<const Program>(std::move(unexpanded_sums));
  present_functions(program, budget, forms, [&](Arithmetic& arithmetic, const Function& function) {
    std::vector<OptionalFraction> values;
    for (const ExpansionPair& both :
         fold<ExpansionPair>(ExpansionPairRules(arithmetic, sums), program, function)) {
      values.push_back(both.unexpanded);
    }
    return values;
  });
  return forms;
}

bool is_proved_equal(ClosedForms& forms, const Fraction& x, const Fraction& y) {
  Arithmetic arithmetic(forms.algebra, ClosedFormBudget{}.products_per_function);
  const OptionalFraction difference = arithmetic.subtract(x, y);
  return difference && difference->numerator.empty();
}

std::vector<ZeroProof> prove_zeros(const Program& program, Function function,
                                   const ClosedFormBudget& budget) {
  const Program alone{program.leaves, program.constants, {std::move(function)}};
  const auto proofs = [&](const Algebra& algebra) {
    return zero_proofs(present_in_algebra(algebra, alone, budget, SummaryHandling::presented));
  };
  std::vector<ZeroProof> result = proofs({});
  const bool is_open = std::ranges::find(result, ZeroProof::undecided) != result.end();
  const bool has_other_forms = std::ranges::any_of(function_table(), [&](const FunctionRow& row) {
    return is_rewritten_for_proofs(row.id) && calls_function(alone, row.id);
  });
  if (!is_open || !has_other_forms) return result;
  const std::vector<ZeroProof> others = proofs(proof_algebra());
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (result[i] == ZeroProof::undecided) result[i] = others[i];
  }
  return result;
}

}  // namespace elgen
