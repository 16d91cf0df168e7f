// Compares the numerators of both forms over one denominator. If the denominators are different
// sums, compares the denominators instead.
#include "verify/structure/differing_terms.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <vector>

#include "analyse/formulas.hpp"
#include "elgen/analysis_pages.hpp"
#include "forms/present/arithmetic.hpp"
#include "forms/present/polynomial.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

/// Limit of the products of terms in one comparison: some milliseconds. Textbook equations need
/// less than a tenth.
constexpr std::size_t most_work_of_terms = 20'000;
/// With more differing terms, the form is not just mistyped, and no terms are reported.
constexpr std::size_t most_reported_terms = 4;
/// The same limit as in `elgen diff`.
constexpr std::size_t longest_form = 100;

bool is_not_circular(const Atom& atom) { return atom.kind != AtomKind::circular; }

const Polynomial& polynomial_of_powers(const TermsByPowers& terms, const Monomial& powers) {
  static const Polynomial none;
  const auto found = terms.find(powers);
  return found == terms.end() ? none : found->second;
}

/// The text of a product without its sign.
std::string remove_sign(const std::string& text) {
  const bool is_product = text.find(' ') == std::string::npos;
  return is_product && text.starts_with('-') ? text.substr(1) : text;
}

std::string factor_text(const cln::cl_RA& times) {
  if (times == -1) return "has the opposite sign";
  const bool is_part = cln::abs(times) < 1;
  return fmt::format("has {} {} its factor", number_text(times), is_part ? "of" : "times");
}

/// The differing terms of both forms over one denominator; none if the budget is exceeded.
std::optional<DifferingTerms> terms_over_common_denominator(Algebra& algebra, const Fraction& right,
                                                            const Fraction& written) {
  Arithmetic arithmetic(algebra, most_work_of_terms);
  const OptionalFraction first = full_denominator(algebra, written);
  const OptionalFraction once = arithmetic.multiply(right, first);
  const OptionalFraction divisor =
      once ? arithmetic.multiply(first, full_denominator(algebra, *once)) : once;
  const OptionalFraction x = arithmetic.multiply(right, divisor);
  const OptionalFraction y = arithmetic.multiply(written, divisor);
  if (!x || !y || !x->denominator.empty() || !y->denominator.empty()) return std::nullopt;
  const TermsByPowers rights = group_by_powers(algebra, x->numerator);
  const TermsByPowers writtens = group_by_powers(algebra, y->numerator);
  std::set<Monomial, MonomialLess> all;
  for (const TermsByPowers* terms : {&rights, &writtens}) {
    for (const auto& [powers, part] : *terms) all.insert(powers);
  }
  DifferingTerms result;
  const auto add = [&](Fraction& to, const Polynomial& part, const Monomial& powers) {
    const Fraction term = fraction_of(multiply_by_term(part, {1, 0}, powers));
    const OptionalFraction sum = arithmetic.add(to, arithmetic.divide(term, divisor));
    if (sum) to = *sum;
    return sum.has_value();
  };
  for (const Monomial& powers : all) {
    const Polynomial& own = polynomial_of_powers(rights, powers);
    const Polynomial& other = polynomial_of_powers(writtens, powers);
    if (own == other) continue;
    ++result.count;
    const auto times = own.empty() || other.empty() ? std::nullopt : ratio_of(other, own);
    const bool is_added =
        times ? add(result.rescaled_terms[*times], own, powers)
              : add(result.missing, own, powers) && add(result.surplus, other, powers);
    if (!is_added) return std::nullopt;
  }
  return result;
}

bool has_divisor(const Fraction& form, std::uint32_t factor, std::int32_t exponent) {
  const auto found = form.denominator.find(factor);
  return found != form.denominator.end() && found->second >= exponent;
}

/// True if the terms occur in the forms as written: both forms minus these terms have only divisors
/// that both forms have.
bool are_terms_in_forms(Algebra& algebra, const Fraction& right, const Fraction& written,
                        const DifferingTerms& terms) {
  Arithmetic arithmetic(algebra, most_work_of_terms);
  OptionalFraction common = arithmetic.subtract(right, terms.missing);
  for (const auto& [times, form] : terms.rescaled_terms) common = arithmetic.subtract(common, form);
  return common && std::ranges::all_of(common->denominator, [&](const auto& divisor) {
           return has_divisor(right, divisor.first, divisor.second) &&
                  has_divisor(written, divisor.first, divisor.second);
         });
}

/// The differing terms of the written denominator and of n / `right`, n the written numerator; none
/// if n / `right` has a denominator.
std::optional<DifferingTerms> denominator_terms(Algebra& algebra, const Fraction& right,
                                                const Fraction& written) {
  Arithmetic arithmetic(algebra, most_work_of_terms);
  const OptionalFraction own = full_denominator(algebra, written);
  const OptionalFraction needed = arithmetic.divide(arithmetic.multiply(written, own), right);
  if (!needed || !needed->denominator.empty()) return std::nullopt;
  auto terms = terms_over_common_denominator(algebra, *needed, *own);
  if (terms) terms->is_of_denominator = true;
  return terms;
}

}  // namespace

TermsByPowers group_by_powers(const Algebra& algebra, const Polynomial& sum) {
  return group_terms_by_atoms(algebra, sum, is_not_circular);
}

std::optional<DifferingTerms> differing_terms(Algebra& algebra, const Fraction& right,
                                              const Fraction& written) {
  auto terms = terms_over_common_denominator(algebra, right, written);
  if (!terms || are_terms_in_forms(algebra, right, written, *terms)) return terms;
  return denominator_terms(algebra, right, written);
}

std::string short_form_text(const Model& model, const Algebra& algebra, const Fraction& form) {
  const std::optional<Formula> formula = readable_formula(model, algebra, form);
  std::string text = formula ? text_of(*formula) : "";
  return text.size() <= longest_form ? text : "";
}

std::string differing_terms_text(const Model& model, const Algebra& algebra,
                                 const DifferingTerms& terms) {
  if (terms.count == 0 || terms.count > most_reported_terms) return {};
  bool is_read = true;
  const auto read = [&](const Fraction& form) {
    std::string text = form.numerator.empty() ? "" : short_form_text(model, algebra, form);
    is_read = is_read && text.empty() == form.numerator.empty();
    return text;
  };
  std::vector<std::string> words;
  for (const auto& [times, form] : terms.rescaled_terms) {
    words.push_back(fmt::format("the term {} {}", remove_sign(read(form)), factor_text(times)));
  }
  const std::string missing = read(terms.missing);
  const std::string surplus = read(terms.surplus);
  if (!missing.empty() && !surplus.empty()) {
    words.push_back(fmt::format("{} replaces {}", surplus, missing));
  } else if (!missing.empty()) {
    words.push_back(fmt::format("the term {} is missing", remove_sign(missing)));
  } else if (!surplus.empty()) {
    words.push_back(fmt::format("the term {} is superfluous", remove_sign(surplus)));
  }
  const std::string_view place = terms.is_of_denominator ? "in the denominator " : "";
  return is_read ? fmt::format("{}{}", place, fmt::join(words, ", ")) : "";
}

}  // namespace elgen
