// Compares an equation with f times a row of the equations of motion. A candidate f is the quotient
// of a term of the equation by a term of the row with the same velocities, accelerations and
// inputs; both terms must contain an acceleration. Numbers are compared in 60 digits, and only if
// more digits do not change them.
#include "verify/structure/stated.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "analyse/formulas.hpp"
#include "elgen/references.hpp"
#include "forms/present/arithmetic.hpp"
#include "forms/present/polynomial.hpp"
#include "model/requests.hpp"
#include "numbers/exact_number.hpp"
#include "sample/states.hpp"
#include "verify/structure/differing_terms.hpp"

namespace elgen {
namespace {

using cln::cl_R;

/// The closed forms of M a + bias - B u - A^T lambda, by row; none if an entry has no closed form.
std::optional<std::vector<Fraction>> motion_equation_rows(const ExpectationProver& proofs) {
  const Model& model = proofs.subject().model;
  auto rows = proofs.entry_forms(OutputKind::inverse_dynamics);
  if (!rows) return std::nullopt;
  Arithmetic arithmetic(*proofs.algebra());
  const auto subtract = [&](std::size_t row, const Fraction& gain, Opcode kind, std::size_t leaf) {
    const OptionalFraction term =
        arithmetic.multiply(gain, arithmetic.leaf(kind, static_cast<std::uint32_t>(leaf)));
    const OptionalFraction rest = arithmetic.subtract((*rows)[row], term);
    if (rest) (*rows)[row] = *rest;
    return rest.has_value();
  };
  const std::size_t inputs = model.inputs.size();
  const auto gains = inputs == 0 ? std::optional<std::vector<Fraction>>(std::in_place)
                                 : proofs.entry_forms(OutputKind::input_matrix);
  const auto jacobian = model.constraints.empty()
                            ? std::optional<std::vector<Fraction>>(std::in_place)
                            : proofs.entry_forms(OutputKind::constraint_jacobian);
  if (!gains || !jacobian) return std::nullopt;
  for (std::size_t k = 0; k < gains->size(); ++k) {
    if (!subtract(k / inputs, (*gains)[k], Opcode::input, k % inputs)) return std::nullopt;
  }
  const std::size_t n = rows->size();
  for (std::size_t k = 0; k < jacobian->size(); ++k) {
    if (!subtract(k % n, (*jacobian)[k], Opcode::multiplier, k / n)) return std::nullopt;
  }
  return rows;
}

constexpr LeafSet motion_leaves =
    Opcode::velocity | Opcode::acceleration | Opcode::input | Opcode::multiplier;

/// The terms of a form that contain accelerations, each with its powers of velocities,
/// accelerations, inputs and multipliers.
std::vector<std::pair<Monomial, Fraction>> terms_with_accelerations(Algebra& algebra,
                                                                    const Fraction& form) {
  Arithmetic arithmetic(algebra);
  const OptionalFraction divisor = full_denominator(algebra, form);
  const OptionalFraction sum = arithmetic.multiply(form, divisor);
  std::vector<std::pair<Monomial, Fraction>> terms;
  if (!sum || !sum->denominator.empty()) return terms;
  for (const auto& [powers, part] : group_by_powers(algebra, sum->numerator)) {
    Monomial rates;
    bool accelerates = false;
    for (const AtomPower& power : powers) {
      const Atom& atom = algebra.atoms[power.atom];
      if (atom.kind != AtomKind::leaf || !motion_leaves.has_any(atom.leaf)) continue;
      rates.push_back(power);
      accelerates = accelerates || atom.leaf == Opcode::acceleration;
    }
    const OptionalFraction term =
        arithmetic.divide(fraction_of(multiply_by_term(part, {1, 0}, powers)), divisor);
    if (accelerates && term) terms.emplace_back(rates, *term);
  }
  return terms;
}

/// The form at a = 0.
OptionalFraction substitute_zero_accelerations(const Model& model, Algebra& algebra,
                                               const Fraction& form) {
  Replacements rest;
  for (std::uint32_t i = 0; i < model.velocities.size(); ++i) rest[{Opcode::acceleration, i}] = {};
  return substitute(algebra, form, rest);
}

/// The distinct quotients of a term of the equation by a term of the row.
std::vector<Fraction> candidate_factors(Algebra& algebra, const Fraction& equation,
                                        const Fraction& row) {
  Arithmetic arithmetic(algebra);
  std::vector<Fraction> factors;
  const auto others = terms_with_accelerations(algebra, row);
  for (const auto& [rates, own] : terms_with_accelerations(algebra, equation)) {
    for (const auto& [other_rates, other] : others) {
      const OptionalFraction factor =
          rates == other_rates ? arithmetic.divide(own, other) : std::nullopt;
      if (factor && std::ranges::count(factors, *factor) == 0) factors.push_back(*factor);
    }
  }
  return factors;
}

/// The right form that has the fewest differing terms so far.
struct NearestForm {
  std::string right = {};  ///< the right form in words
  std::optional<DifferingTerms> terms = {};

  bool is_farther(const std::optional<DifferingTerms>& other) const {
    return other && (!terms || other->count < terms->count);
  }
};

std::string row_text(const Model& model, const Algebra& algebra, std::size_t row,
                     const Fraction& factor) {
  const std::string text = short_form_text(model, algebra, factor);
  const bool is_plain = text.empty() || text == "1";
  return fmt::format("row {} of the equations of motion{}{}", model.velocities[row].name,
                     is_plain ? "" : ", times ", is_plain ? "" : text);
}

/// The oracle's values of the expected field; no values if the field is undefined.
StableValues expected_field_values(const Model& model, const Expectation& expectation,
                                   const State& state) {
  const auto request = find_request(model, expectation.output);
  if (!request) return {};
  StableValues field = stable_values(model, *request, state);
  const std::size_t end = expectation.first + expectation.entries.size();
  if (!field.values || field.values->size() < end) return {.is_decided = field.is_decided};
  const auto first = field.values->begin();
  field.values = std::vector(first + expectation.first, first + static_cast<std::ptrdiff_t>(end));
  return field;
}

/// The value in 15 digits, the precision of a double.
std::string double_text(const cl_R& value) { return fmt::format("{:.15g}", to_double(value)); }

}  // namespace

std::string matching_row(const ExpectationProver& proofs, const Fraction& equation) {
  const auto rows = motion_equation_rows(proofs);
  if (!rows) return {};
  Algebra& algebra = *proofs.algebra();
  Arithmetic arithmetic(algebra);
  for (std::size_t i = 0; i < rows->size(); ++i) {
    for (const Fraction& factor : candidate_factors(algebra, equation, (*rows)[i])) {
      const OptionalFraction difference =
          arithmetic.subtract(equation, arithmetic.multiply(factor, (*rows)[i]));
      if (!difference || !difference->numerator.empty()) continue;
      return row_text(proofs.subject().model, algebra, i, factor);
    }
  }
  return {};
}

std::string difference_from_motion(const ExpectedEntry& entry, const ExpectationProver& proofs,
                                   const Fraction& equation) {
  const Model& model = entry.subject.model;
  const bool has_multipliers = contains_leaf(model, entry.expression(), Opcode::multiplier);
  if (!model.constraints.empty() && !has_multipliers) return {};
  const auto rows = motion_equation_rows(proofs);
  if (!rows) return {};
  Algebra& algebra = *proofs.algebra();
  Arithmetic arithmetic(algebra);
  NearestForm nearest;
  for (std::size_t i = 0; i < rows->size(); ++i) {
    for (const Fraction& factor : candidate_factors(algebra, equation, (*rows)[i])) {
      // If the author divided by a sum to solve for an acceleration, the terms do not match the
      // row's.
      const OptionalFraction divisor = full_denominator(algebra, factor);
      if (!divisor || divisor->numerator.size() > 1) continue;
      const OptionalFraction right = arithmetic.multiply(factor, (*rows)[i]);
      if (!right) continue;
      auto terms = differing_terms(algebra, *right, equation);
      if (!nearest.is_farther(terms)) continue;
      nearest = {row_text(model, algebra, i, factor), std::move(terms)};
    }
  }
  const std::optional<Fraction> rest = proofs.substitute_motion(equation);
  const OptionalFraction written = substitute_zero_accelerations(model, algebra, equation);
  const OptionalFraction right = rest ? arithmetic.subtract(written, *rest) : std::nullopt;
  auto terms = right ? differing_terms(algebra, *right, *written) : std::nullopt;
  if (nearest.is_farther(terms)) {
    nearest = {has_multipliers ? "the multipliers and accelerations of the motion"
                               : "the accelerations of the motion",
               std::move(terms)};
  }
  const std::string text =
      nearest.terms ? differing_terms_text(model, algebra, *nearest.terms) : "";
  if (!text.empty()) return fmt::format("compared with {}: {}", nearest.right, text);
  const std::string whole = rest ? short_form_text(model, algebra, *rest) : "";
  return whole.empty() ? "" : fmt::format("left - right is {} along the motion", whole);
}

/// The sum becomes constant if t (1 - r/r_t) replaces its term t; r is the rate of the sum, r_t the
/// rate of t. Each term t with a rational r/r_t is reported.
std::string difference_from_constant(const ExpectationProver& proofs, const Fraction& written) {
  Algebra& algebra = *proofs.algebra();
  Arithmetic arithmetic(algebra);
  const OptionalFraction divisor = full_denominator(algebra, written);
  const OptionalFraction sum = arithmetic.multiply(written, divisor);
  const std::optional<Fraction> rate = proofs.free_rate(written);
  if (!rate || !sum || !sum->denominator.empty()) return {};
  const TermsByPowers terms = group_by_powers(algebra, sum->numerator);
  std::vector<std::string> words;
  for (const auto& [powers, part] : terms) {
    const OptionalFraction term =
        arithmetic.divide(fraction_of(multiply_by_term(part, {1, 0}, powers)), divisor);
    const auto own = term && terms.size() > 1 ? proofs.free_rate(*term) : std::nullopt;
    const OptionalFraction share = own ? arithmetic.divide(rate, own) : std::nullopt;
    if (!share || !share->denominator.empty()) continue;
    const std::optional<cln::cl_RA> number = rational_value(share->numerator);
    if (!number || cln::zerop(*number)) continue;
    DifferingTerms difference{.count = 1};
    const cln::cl_RA factor = 1 - *number;
    const OptionalFraction right = arithmetic.multiply(term, fraction_of(factor));
    if (!right) continue;
    if (cln::zerop(factor)) difference.surplus = *term;
    if (!cln::zerop(factor)) difference.rescaled_terms[1 / factor] = *right;
    const std::string text = differing_terms_text(proofs.subject().model, algebra, difference);
    if (!text.empty()) words.push_back(text);
  }
  return words.empty()
             ? ""
             : fmt::format("compared with a conserved quantity: {}", fmt::join(words, ", or "));
}

/// Compares at one state in 60 digits. For an expectation of the model, parameters have the values
/// of its file, even if the scene fixes others.
void check_numbers(ExpectationReport& report, const Expectation& expectation,
                   const SystemUnderTest& subject) {
  const Model& model = subject.model;
  const State start = start_state(model, fixing_scene(subject, expectation));
  const State state = with_leaves(model, start, expectation.state->leaves);
  const std::string where = describe_state(subject, state);
  const StableValues settled = expected_field_values(model, expectation, state);
  const std::vector<cl_R> field = settled.values.value_or(std::vector<cl_R>());
  const cl_R largest = max_magnitude(field);
  const std::string within = short_number_text(expectation.state->tolerance);
  for (std::size_t index = 0; index < expectation.entries.size(); ++index) {
    const ExpectedEntry entry{expectation, index, subject};
    const StableValues number = stable_expression_value(model, entry.expression(), state);
    CertificateRow& row = report.rows.emplace_back(unjudged_row(entry));
    row.output += " at a state";
    row.tolerance = fmt::format("{} of the largest entry, at the state of the file", within);
    if (!settled.is_decided || !number.is_decided) {
      row.verdict = Verdict::skipped;
      row.skipped = {{SkipReason::undecided, 1}};
      continue;
    }
    if (!number.values || field.empty()) {
      row.verdict = Verdict::fails;
      row.worst_value = "no value";
      report.diagnostics.push_back(
          {Code::E510, entry.span(), fmt::format("{} has no value at {}", name_of(entry), where)});
      continue;
    }
    const cl_R written = number.values->front();
    const cl_R difference = written - field[index];
    const cl_R scale = cln::zerop(largest) ? cln::abs(written) : largest;
    const cl_R share = cln::zerop(difference) ? cl_R(0) : cln::abs(difference) / scale;
    row.samples = 1;
    row.worst_value = fmt::format("{} of the largest entry", short_number_text(share));
    if (share <= expectation.state->tolerance) continue;
    row.verdict = Verdict::fails;
    row.worst_state = where;
    report.diagnostics.push_back(
        {Code::E510, entry.span(),
         fmt::format("{} is {} in the file, {} as derived, {} too much: {}, more than {}, at {}",
                     name_of(entry), double_text(written), double_text(field[index]),
                     short_number_text(difference), row.worst_value, within, where)});
  }
}

}  // namespace elgen
