// Arithmetic: the field operations and functions on closed forms over one algebra, within a budget.
//
// A Form is none where an operand was, where the budget is used up, or where there is no value
// (division by zero). Atoms are found again by the canonical form of what they stand for.
#pragma once

#include "elgen/closed_forms.hpp"
#include "elgen/syntax.hpp"

namespace elgen::presenting {

using Form = std::optional<Fraction>;

[[nodiscard]] Fraction fraction_of(const Polynomial& numerator);
[[nodiscard]] Fraction fraction_of(const cln::cl_RA& value);

class Arithmetic {
 public:
  /// `work`: term products left; it is lowered as they are made.
  Arithmetic(Algebra& algebra, std::size_t& work, std::size_t terms)
      : algebra_(algebra), work_(work), terms_(terms) {}

  [[nodiscard]] Form add(const Form& x, const Form& y);
  [[nodiscard]] Form negate(const Form& x) const;
  [[nodiscard]] Form multiply(const Form& x, const Form& y);
  [[nodiscard]] Form divide(const Form& x, const Form& y);
  /// x^exponent, exponent an integer.
  [[nodiscard]] Form power(const Form& x, std::int32_t exponent);
  [[nodiscard]] Form square_root(const Form& x);
  [[nodiscard]] Form call(FunctionId function, const std::vector<Form>& arguments);

  [[nodiscard]] Form leaf(Opcode leaf, std::uint32_t index);
  /// Rational, or by its text: sums, products, roots and multiples of pi are taken apart.
  [[nodiscard]] Form constant(const Constant& value);

 private:
  Fraction atom(Atom atom);
  Form opaque(Atom atom);
  [[nodiscard]] Form limited(Fraction x) const;
  std::optional<Polynomial> multiplied(const Polynomial& x, const Polynomial& y);
  std::optional<Polynomial> over(const Fraction& x,
                                 const std::map<std::uint32_t, std::int32_t>& denominator);
  Form cancelled(Fraction x);
  Form reduced_roots(Fraction x);
  Form reciprocal(const Fraction& x);
  void note_circular_factors(const Polynomial& rest);
  bool split_factors(Polynomial& rest, std::map<std::uint32_t, std::int32_t>& denominator);
  std::uint32_t factor_index(const Polynomial& polynomial, Polynomial& unit);

  Form root_of_integer(cln::cl_I value);
  /// e^(i x), x real.
  Form exponential(const Fraction& x, bool conjugate);
  Form exponential_of_term(const Monomial& monomial, const cln::cl_RA& coefficient);
  Form circle_twelfths(long twelfths);
  Form sine_or_cosine(FunctionId function, const Fraction& x);

  Algebra& algebra_;
  std::size_t& work_;
  std::size_t terms_;
};

}  // namespace elgen::presenting
