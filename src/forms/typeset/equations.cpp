// equations: see equations.hpp.
#include "forms/typeset/equations.hpp"

#include <algorithm>
#include <map>

#include "elgen/typeset.hpp"
#include "forms/present/polynomial.hpp"

namespace elgen {
namespace {

bool contains_rate(const Algebra& algebra, const Fraction& form) {
  return std::ranges::any_of(
      form.numerator, [&](const auto& term) { return elgen::contains_rate(algebra, term.first); });
}

/// The acceleration in `term`, which has at most one acceleration; term.end() if there is none.
Monomial::const_iterator find_acceleration(const Algebra& algebra, const Monomial& term) {
  return std::ranges::find_if(term, [&](const AtomPower& power) {
    const Atom& atom = algebra.atoms[power.atom];
    return atom.kind == AtomKind::leaf && atom.leaf == Opcode::acceleration;
  });
}

Fraction negate_form(const Fraction& form) {
  return {multiply_by_term(form.numerator, {-1, 0}), form.denominator};
}

/// Removes zeros and pairs that cancel: V = a*x + b - a*x exerts no force.
std::vector<Fraction> remove_cancelling_pairs(std::vector<Fraction> summands) {
  for (std::size_t i = 0; i < summands.size(); ++i) {
    for (std::size_t k = i + 1; k < summands.size(); ++k) {
      if (summands[i] != negate_form(summands[k])) continue;
      summands[i] = {};
      summands[k] = {};
    }
  }
  std::erase_if(summands, [](const Fraction& form) { return form.numerator.empty(); });
  return summands;
}

}  // namespace

/// The summands without zeros and cancelling pairs; empty if all summands add up to 0, as for
/// V = a*x + b*x - (a + b)*x.
std::vector<Fraction> EquationArranger::nonzero_summands(const std::vector<Fraction>& summands) {
  OptionalFraction sum = Fraction{};
  for (const Fraction& form : summands) sum = arithmetic_.add(sum, form);
  if (sum && sum->numerator.empty()) return {};
  return remove_cancelling_pairs(summands);
}

Fraction EquationArranger::total(const std::vector<Fraction>& summands) {
  OptionalFraction sum = Fraction{};
  for (const Fraction& form : summands) sum = arithmetic_.add(sum, form);
  if (!sum) throw TextbookLengthError();
  return *sum;
}

std::optional<EquationRow> EquationArranger::read_row(const ClosedFunction& function) {
  EquationRow result;
  const auto forms = [&](LagrangeStepField field) {
    return function.fields[static_cast<std::size_t>(field)].entries;
  };
  const auto rates = forms(LagrangeStepField::momentum_rate);
  const auto partials = forms(LagrangeStepField::partial);
  for (std::size_t k = 0; k < rates.size(); ++k) {
    const OptionalFraction part = arithmetic_.subtract(rates[k], partials[k]);
    if (!part) return std::nullopt;
    result.inertia.push_back(*part);
  }
  for (const std::optional<Fraction>& form : forms(LagrangeStepField::dissipation)) {
    if (!form) return std::nullopt;
    result.dissipation.push_back(*form);
  }
  const std::optional<Fraction> force = forms(LagrangeStepField::force).front();
  if (!force) return std::nullopt;
  result.force = *force;
  return result;
}

TextbookSum EquationArranger::arrange_row(std::vector<Fraction> summands, std::uint32_t own,
                                          const std::vector<Fraction>& dissipation) {
  const auto resting =
      std::stable_partition(summands.begin(), summands.end(),
                            [&](const Fraction& form) { return contains_rate(algebra_, form); });
  TextbookSum result = arranger_.collect_by_rates(total({summands.begin(), resting}), own);
  for (const std::vector<Fraction>& part : {dissipation, {resting, summands.end()}}) {
    for (const Fraction& form : nonzero_summands(part))
      append_terms(result, arranger_.arrange_summand(form, own));
  }
  return result;
}

struct EquationArranger::LinearRow {
  std::map<std::uint32_t, Fraction> inertia = {};  ///< coefficient of each acceleration
  Fraction rest = {};                              ///< force minus all terms without acceleration
};

std::optional<EquationArranger::LinearRow> EquationArranger::split_accelerations(
    const std::optional<EquationRow>& row) {
  if (!row) return std::nullopt;
  std::vector<Fraction> all = row->inertia;
  all.insert(all.end(), row->dissipation.begin(), row->dissipation.end());
  all.push_back(negate_form(row->force));
  const Fraction whole = total(all);
  LinearRow result;
  result.rest.denominator = whole.denominator;
  for (const auto& [monomial, coefficient] : whole.numerator) {
    const auto at = find_acceleration(algebra_, monomial);
    if (at == monomial.end()) {
      add_term(result.rest.numerator, monomial, {-coefficient.real, -coefficient.imaginary});
      continue;
    }
    Fraction& inertia = result.inertia[algebra_.atoms[at->atom].index];
    inertia.denominator = whole.denominator;
    add_term(inertia.numerator, product(monomial, Monomial{{at->atom, -1}}), coefficient);
  }
  return result;
}

/// The acceleration of velocity `own`: (force - terms without acceleration)/inertia, term by term.
TextbookSum EquationArranger::divide_by_inertia(const EquationRow& row, const Fraction& inertia,
                                                std::uint32_t own) {
  std::vector<Fraction> moving;
  std::vector<Fraction> resting;
  for (const Fraction& form : row.inertia) {
    (contains_rate(algebra_, form) ? moving : resting).push_back(negate_form(form));
  }
  Fraction whole = total(moving);
  erase_if(whole.numerator, [&](const auto& term) {
    return find_acceleration(algebra_, term.first) != term.first.end();
  });
  std::vector<Fraction> parts = nonzero_summands(resting);
  parts.insert(parts.begin(), std::move(whole));
  for (const Fraction& form : nonzero_summands(row.dissipation)) parts.push_back(negate_form(form));
  parts.push_back(row.force);
  TextbookSum result;
  for (const Fraction& part : parts) {
    const OptionalFraction divided = arithmetic_.divide(part, inertia);
    if (!divided) throw TextbookLengthError();
    append_terms(result, arranger_.arrange_summand(*divided, own));
  }
  return result;
}

std::optional<TextbookSum> EquationArranger::solve_acceleration(
    const std::vector<std::optional<EquationRow>>& rows, std::uint32_t own) {
  const std::optional<LinearRow> first = split_accelerations(rows[own]);
  if (!first || first->inertia.count(own) == 0 || first->inertia.size() > 2) return std::nullopt;
  const Fraction& inertia = first->inertia.at(own);
  if (first->inertia.size() == 1) {
    const bool is_product = arranger_.is_one_product(inertia);
    if (is_product) return divide_by_inertia(*rows[own], inertia, own);
    return arranger_.arrange_quotient(first->rest, inertia);
  }
  const std::uint32_t other = first->inertia.begin()->first == own
                                  ? std::next(first->inertia.begin())->first
                                  : first->inertia.begin()->first;
  const std::optional<LinearRow> second = split_accelerations(rows[other]);
  const bool is_pair = second && second->inertia.size() == 2 && second->inertia.count(own) == 1;
  if (!is_pair) return std::nullopt;
  // Cramer's rule.
  const auto minor = [&](const Fraction& a, const Fraction& b, const Fraction& c,
                         const Fraction& d) {
    return arithmetic_.subtract(arithmetic_.multiply(a, b), arithmetic_.multiply(c, d));
  };
  const Fraction& coupling = first->inertia.at(other);
  const Fraction& theirs = second->inertia.at(other);
  const OptionalFraction above = minor(theirs, first->rest, coupling, second->rest);
  const OptionalFraction below = minor(inertia, theirs, coupling, second->inertia.at(own));
  if (!above || !below) return std::nullopt;
  return arranger_.arrange_quotient(*above, *below);
}

}  // namespace elgen
