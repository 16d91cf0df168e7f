// Arithmetic: field operations and functions on closed forms over one algebra, within a budget.
//
// A result is none if an operand is none, if the budget is used up, or if the value is undefined
// (division by zero). Atoms are identified by the canonical forms of their arguments.
#pragma once

#include "elgen/closed_forms.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

using OptionalFraction = std::optional<Fraction>;

/// The atom of an exponential is e^(i m/12), with m a monomial of the angle. Therefore e^(i m/2),
/// e^(i m/3) and e^(i m/4) are integer powers of the atom.
inline constexpr int units_per_angle = 12;

[[nodiscard]] Fraction fraction_of(const Polynomial& numerator);
[[nodiscard]] Fraction fraction_of(const cln::cl_RA& value);

class Arithmetic {
 public:
  /// Limits: `work` products of terms in total, and `terms` terms in one sum.
  explicit Arithmetic(Algebra& algebra, std::size_t work = ClosedFormBudget{}.products,
                      std::size_t terms = ClosedFormBudget{}.terms)
      : algebra_(algebra), remaining_products_(work), most_terms_(terms) {}

  /// The remaining budget of term products.
  [[nodiscard]] std::size_t remaining_products() const { return remaining_products_; }

  [[nodiscard]] OptionalFraction add(const OptionalFraction& x, const OptionalFraction& y);
  [[nodiscard]] OptionalFraction subtract(const OptionalFraction& x, const OptionalFraction& y) {
    return add(x, negate(y));
  }
  [[nodiscard]] OptionalFraction negate(const OptionalFraction& x) const;
  [[nodiscard]] OptionalFraction multiply(const OptionalFraction& x, const OptionalFraction& y);
  [[nodiscard]] OptionalFraction divide(const OptionalFraction& x, const OptionalFraction& y);
  [[nodiscard]] OptionalFraction power(const OptionalFraction& x, std::int32_t exponent);
  [[nodiscard]] OptionalFraction square_root(const OptionalFraction& x);
  /// The value of `function` at (x, y). A function of one argument ignores y.
  [[nodiscard]] OptionalFraction call(FunctionId function, const OptionalFraction& x,
                                      const OptionalFraction& y);

  [[nodiscard]] OptionalFraction leaf(Opcode leaf, std::uint32_t index);
  [[nodiscard]] OptionalFraction pi();
  /// The atom in place of an unexpanded sum: `index` is the number of the sum in
  /// Algebra::unexpanded_sums, `form` its expanded value.
  [[nodiscard]] OptionalFraction unexpanded_sum(std::uint32_t index, const Fraction& form);
  /// Converts a constant operation by operation: sums, products, roots and calls.
  [[nodiscard]] OptionalFraction constant(const ConstantForm& form);
  [[nodiscard]] OptionalFraction constant(const Constant& constant) {
    return this->constant(constant.form);
  }

 private:
  Fraction intern_atom(Atom wanted);
  [[nodiscard]] OptionalFraction check_term_limit(Fraction x) const;
  std::optional<Polynomial> multiply_sums(const Polynomial& x, const Polynomial& y);
  std::optional<Polynomial> multiply_by_factor(Polynomial x, std::uint32_t factor,
                                               std::int32_t exponent);
  std::optional<Polynomial> expand_numerator(
      const Fraction& x, const std::map<std::uint32_t, std::int32_t>& denominator);
  OptionalFraction cancel_factors(Fraction x);
  OptionalFraction reduce_roots(Fraction x);
  OptionalFraction reciprocal(const Fraction& x);
  void add_circular_factors(const Polynomial& rest);
  bool split_factors(Polynomial& rest, std::map<std::uint32_t, std::int32_t>& denominator);
  std::uint32_t factor_index(const Polynomial& polynomial, Polynomial& unit);

  OptionalFraction root_of_integer(cln::cl_I value);
  /// e^(i x), or e^(-i x) if `conjugate`; x must be real.
  OptionalFraction exponential(const Fraction& x, bool conjugate);
  OptionalFraction exponential_of_term(const Monomial& monomial, const cln::cl_RA& coefficient);
  OptionalFraction root_of_unity(long twelfths);
  OptionalFraction sine_or_cosine(FunctionId function, const Fraction& x);
  OptionalFraction stumpff_quotient(const Fraction& x, const cln::cl_I& order);
  OptionalFraction real_exponential(const Fraction& x);
  OptionalFraction expand_in_exponentials(FunctionId function, const Fraction& x);

  Algebra& algebra_;
  std::size_t remaining_products_;
  std::size_t most_terms_;
};

}  // namespace elgen
