// proved_zeros: sums of independent atoms are 0 only where they are empty.
#include "present/proved_zeros.hpp"

#include <algorithm>
#include <utility>

#include "present/arithmetic.hpp"

namespace elgen {
namespace {

bool is_plain(const Algebra& algebra, const Monomial& monomial) {
  return std::ranges::all_of(monomial, [&algebra](const AtomPower& factor) {
    const AtomKind kind = algebra.atoms[factor.atom].kind;
    return kind == AtomKind::leaf || kind == AtomKind::pi;
  });
}

/// Whether no algebraic relation joins atoms of this sort: leaves, pi, and e^(i m/12) of monomials
/// m of these. e^(i m/24), roots, and e^(ix) of fractions x have relations that forms do not know.
bool is_independent(const Algebra& algebra, AtomId id) {
  const Atom& atom = algebra.atoms[id];
  if (atom.kind == AtomKind::leaf || atom.kind == AtomKind::pi) return true;
  return atom.kind == AtomKind::circular && atom.divisor == angle_parts &&
         is_plain(algebra, atom.arguments[0].numerator.begin()->first);
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
