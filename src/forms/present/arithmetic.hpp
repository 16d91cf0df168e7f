// Arithmetic: field operations and functions on closed forms over one algebra, within a budget.
//
// A Value is none if an operand is none, if the budget is used up, or if the result is undefined
// (division by zero). Atoms are identified by the canonical forms of their arguments.
#pragma once

#include "elgen/closed_forms.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

using Value = std::optional<Fraction>;

/// The atom of an exponential is e^(i m/12), with m a monomial of the angle. Therefore e^(i m/2),
/// e^(i m/3) and e^(i m/4) are integer powers of the atom.
inline constexpr int angle_parts = 12;

[[nodiscard]] Fraction fraction_of(const Polynomial& numerator);
[[nodiscard]] Fraction fraction_of(const cln::cl_RA& value);

class Arithmetic {
 public:
  /// Limits: `work` products of terms in total, and `terms` terms in one sum.
  explicit Arithmetic(Algebra& algebra, std::size_t work = PresentBudget{}.products,
                      std::size_t terms = PresentBudget{}.terms)
      : algebra_(algebra), work_(work), terms_(terms) {}

  /// The remaining budget of term products.
  [[nodiscard]] std::size_t work() const { return work_; }

  [[nodiscard]] Value add(const Value& x, const Value& y);
  [[nodiscard]] Value subtract(const Value& x, const Value& y) { return add(x, negate(y)); }
  [[nodiscard]] Value negate(const Value& x) const;
  [[nodiscard]] Value multiply(const Value& x, const Value& y);
  [[nodiscard]] Value divide(const Value& x, const Value& y);
  [[nodiscard]] Value power(const Value& x, std::int32_t exponent);
  [[nodiscard]] Value square_root(const Value& x);
  /// The value of `function` at (x, y). A function of one argument ignores y.
  [[nodiscard]] Value call(FunctionId function, const Value& x, const Value& y);

  [[nodiscard]] Value leaf(Opcode leaf, std::uint32_t index);
  [[nodiscard]] Value pi();
  /// The atom in place of an unexpanded sum: `index` is its number in Algebra::sums, `form` its
  /// expanded value.
  [[nodiscard]] Value whole_sum(std::uint32_t index, const Fraction& form);
  /// Converts a constant operation by operation: sums, products, roots and calls.
  [[nodiscard]] Value constant(const ConstantForm& form);
  [[nodiscard]] Value constant(const Constant& constant) { return this->constant(constant.form); }

 private:
  Fraction atom(Atom wanted);
  [[nodiscard]] Value within_term_limit(Fraction x) const;
  std::optional<Polynomial> multiply_sums(const Polynomial& x, const Polynomial& y);
  std::optional<Polynomial> times_factor(Polynomial x, std::uint32_t factor, std::int32_t exponent);
  std::optional<Polynomial> numerator_over(
      const Fraction& x, const std::map<std::uint32_t, std::int32_t>& denominator);
  Value cancel_factors(Fraction x);
  Value reduce_roots(Fraction x);
  Value reciprocal(const Fraction& x);
  void note_circular_factors(const Polynomial& rest);
  bool split_factors(Polynomial& rest, std::map<std::uint32_t, std::int32_t>& denominator);
  std::uint32_t factor_index(const Polynomial& polynomial, Polynomial& unit);

  Value root_of_integer(cln::cl_I value);
  /// e^(i x), or e^(-i x) if `conjugate`; x must be real.
  Value exponential(const Fraction& x, bool conjugate);
  Value exponential_of_term(const Monomial& monomial, const cln::cl_RA& coefficient);
  Value circle_twelfths(long twelfths);
  Value sine_or_cosine(FunctionId function, const Fraction& x);
  Value stumpff_quotient(const Fraction& x, const cln::cl_I& order);
  Value real_exponential(const Fraction& x);
  Value by_exponentials(FunctionId function, const Fraction& x);

  Algebra& algebra_;
  std::size_t work_;
  std::size_t terms_;
};

}  // namespace elgen
