// present: a Program, run on closed forms instead of numbers.
//
//     0 = sin theta   1 = multiply 0 0   2 = cos theta   3 = multiply 2 2   4 = add 1 3   ->   1
#include "forms/present/present.hpp"

#include <algorithm>
#include <utility>

#include "elgen/fold.hpp"

namespace elgen {

namespace {

/// Long programs are those whose closed forms outgrow them: beyond `short_program` instructions the
/// budget falls with the square of the length, so that trying costs less than lowering did.
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

}  // namespace

bool is_independent(const Algebra& algebra, AtomId id) {
  const Atom& atom = algebra.atoms[id];
  if (atom.kind == AtomKind::leaf || atom.kind == AtomKind::pi) return true;
  return atom.kind == AtomKind::circular && atom.divisor == angle_parts &&
         is_plain(algebra, atom.arguments[0].numerator.begin()->first);
}

void present_functions(const Program& program, const PresentBudget& budget, ClosedForms& forms,
                       const ValuesOf& values_of) {
  std::size_t left = budget.products;
  for (const Function& function : program.functions) {
    ClosedFunction& closed = forms.functions.emplace_back();
    if (output_row(function.kind).repeats) continue;
    const std::size_t share = std::min(left, budget_of(function, budget));
    Arithmetic arithmetic(forms.algebra, share, budget.terms);
    const std::vector<Value> values = values_of(arithmetic, function);
    for (const Field& field : function.fields) {
      ClosedField& entries = closed.fields.emplace_back(ClosedField{field.name, {}});
      for (const std::uint32_t entry : field.entries) entries.entries.push_back(values[entry]);
    }
    left -= share - arithmetic.work();
  }
}

ClosedForms present(const Program& program, const PresentBudget& budget) {
  ClosedForms forms;
  present_functions(program, budget, forms, [&](Arithmetic& arithmetic, const Function& function) {
    return fold<Value>(arithmetic, program, function);
  });
  return forms;
}

bool proved_equal(ClosedForms& forms, const Fraction& x, const Fraction& y) {
  Arithmetic arithmetic(forms.algebra, PresentBudget{}.products_per_function);
  const Value difference = arithmetic.subtract(x, y);
  return difference && difference->numerator.empty();
}

std::vector<ZeroProof> proved_zeros(const Program& program, Function function,
                                    const PresentBudget& budget) {
  function.kind = OutputKind::momentum;  // any but `dynamics`, which has no closed form of its own
  const ClosedForms forms =
      present({program.leaves, program.constants, {std::move(function)}}, budget);
  std::vector<ZeroProof> result;
  for (const ClosedField& field : forms.functions[0].fields) {
    for (const std::optional<Fraction>& form : field.entries) {
      result.push_back(proof_of(forms.algebra, form));
    }
  }
  return result;
}

}  // namespace elgen
