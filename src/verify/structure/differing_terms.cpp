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

bool is_no_angle(const Atom& atom) { return atom.kind != AtomKind::circular; }

const Polynomial& part_of(const TermsByPowers& terms, const Monomial& powers) {
  static const Polynomial none;
  const auto found = terms.find(powers);
  return found == terms.end() ? none : found->second;
}

/// The text of a product without its sign.
std::string without_sign(const std::string& text) {
  const bool is_product = text.find(' ') == std::string::npos;
  return is_product && text.starts_with('-') ? text.substr(1) : text;
}

std::string times_text(const cln::cl_RA& times) {
  if (times == -1) return "has the opposite sign";
  const bool is_part = cln::abs(times) < 1;
  return fmt::format("has {} {} its factor", number_text(times), is_part ? "of" : "times");
}

/// The differing terms of both forms over one denominator; none if the budget is exceeded.
std::optional<DifferingTerms> terms_over_one(Algebra& algebra, const Fraction& right,
                                             const Fraction& written) {
  Arithmetic arithmetic(algebra, most_work_of_terms);
  const Value first = divisor_of(algebra, written);
  const Value once = arithmetic.multiply(right, first);
  const Value divisor = once ? arithmetic.multiply(first, divisor_of(algebra, *once)) : once;
  const Value x = arithmetic.multiply(right, divisor);
  const Value y = arithmetic.multiply(written, divisor);
  if (!x || !y || !x->denominator.empty() || !y->denominator.empty()) return std::nullopt;
  const TermsByPowers rights = terms_by_powers(algebra, x->numerator);
  const TermsByPowers writtens = terms_by_powers(algebra, y->numerator);
  std::set<Monomial, MonomialLess> all;
  for (const TermsByPowers* terms : {&rights, &writtens}) {
    for (const auto& [powers, part] : *terms) all.insert(powers);
  }
  DifferingTerms result;
  const auto add = [&](Fraction& to, const Polynomial& part, const Monomial& powers) {
    const Fraction term = fraction_of(scaled(part, {1, 0}, powers));
    const Value sum = arithmetic.add(to, arithmetic.divide(term, divisor));
    if (sum) to = *sum;
    return sum.has_value();
  };
  for (const Monomial& powers : all) {
    const Polynomial& own = part_of(rights, powers);
    const Polynomial& other = part_of(writtens, powers);
    if (own == other) continue;
    ++result.count;
    const auto times = own.empty() || other.empty() ? std::nullopt : ratio_of(other, own);
    const bool is_told =
        times ? add(result.multiples[*times], own, powers)
              : add(result.missing, own, powers) && add(result.surplus, other, powers);
    if (!is_told) return std::nullopt;
  }
  return result;
}

bool has_divisor(const Fraction& form, std::uint32_t factor, std::int32_t exponent) {
  const auto found = form.denominator.find(factor);
  return found != form.denominator.end() && found->second >= exponent;
}

/// True if the terms occur in the forms as written: both forms minus these terms have only divisors
/// that both forms have.
bool occur_in_forms(Algebra& algebra, const Fraction& right, const Fraction& written,
                    const DifferingTerms& terms) {
  Arithmetic arithmetic(algebra, most_work_of_terms);
  Value common = arithmetic.subtract(right, terms.missing);
  for (const auto& [times, form] : terms.multiples) common = arithmetic.subtract(common, form);
  return common && std::ranges::all_of(common->denominator, [&](const auto& divisor) {
           return has_divisor(right, divisor.first, divisor.second) &&
                  has_divisor(written, divisor.first, divisor.second);
         });
}

/// Compares the written denominator with the denominator that the written numerator needs; none if
/// the latter is not a sum.
std::optional<DifferingTerms> terms_of_denominators(Algebra& algebra, const Fraction& right,
                                                    const Fraction& written) {
  Arithmetic arithmetic(algebra, most_work_of_terms);
  const Value own = divisor_of(algebra, written);
  const Value needed = arithmetic.divide(arithmetic.multiply(written, own), right);
  if (!needed || !needed->denominator.empty()) return std::nullopt;
  auto terms = terms_over_one(algebra, *needed, *own);
  if (terms) terms->of_denominator = true;
  return terms;
}

}  // namespace

TermsByPowers terms_by_powers(const Algebra& algebra, const Polynomial& sum) {
  return group_terms_by(algebra, sum, is_no_angle);
}

std::optional<DifferingTerms> differing_terms(Algebra& algebra, const Fraction& right,
                                              const Fraction& written) {
  auto terms = terms_over_one(algebra, right, written);
  if (!terms || occur_in_forms(algebra, right, written, *terms)) return terms;
  return terms_of_denominators(algebra, right, written);
}

std::string short_form(const Model& model, const Algebra& algebra, const Fraction& form) {
  const std::optional<Formula> formula = read_form(model, algebra, form);
  std::string text = formula ? text_of(*formula) : "";
  return text.size() <= longest_form ? text : "";
}

std::string differing_terms_text(const Model& model, const Algebra& algebra,
                                 const DifferingTerms& terms) {
  if (terms.count == 0 || terms.count > most_reported_terms) return {};
  bool is_read = true;
  const auto read = [&](const Fraction& form) {
    std::string text = form.numerator.empty() ? "" : short_form(model, algebra, form);
    is_read = is_read && text.empty() == form.numerator.empty();
    return text;
  };
  std::vector<std::string> words;
  for (const auto& [times, form] : terms.multiples) {
    words.push_back(fmt::format("the term {} {}", without_sign(read(form)), times_text(times)));
  }
  const std::string missing = read(terms.missing);
  const std::string surplus = read(terms.surplus);
  if (!missing.empty() && !surplus.empty()) {
    words.push_back(fmt::format("{} replaces {}", surplus, missing));
  } else if (!missing.empty()) {
    words.push_back(fmt::format("the term {} is missing", without_sign(missing)));
  } else if (!surplus.empty()) {
    words.push_back(fmt::format("the term {} is superfluous", without_sign(surplus)));
  }
  const std::string_view place = terms.of_denominator ? "in the denominator " : "";
  return is_read ? fmt::format("{}{}", place, fmt::join(words, ", ")) : "";
}

}  // namespace elgen
