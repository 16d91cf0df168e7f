// Numbers with derivatives: truncated polynomials in a scale s and in infinitesimals e_i with e_i^2
// = 0. The coefficient of e1 e2 in f(x + e1 a + e2 b) is the second derivative of f along a and b.
// Approximations are Taylor series in s. A model without approximation has order 0. Uses Number and
// no code of src/.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <map>
#include <string_view>
#include <vector>

namespace elgen::test::random {

/// 80 decimal digits.
using Number = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<80>,
                                             boost::multiprecision::et_off>;

[[nodiscard]] const Number& pi();

class Jet {
 public:
  Jet() = default;
  Jet(const Number& value);  // NOLINT(google-explicit-constructor): numbers are constant jets
  Jet(int value) : Jet(Number(value)) {}  // NOLINT(google-explicit-constructor)

  /// The infinitesimal with this index, 0 ... 5.
  [[nodiscard]] static Jet infinitesimal(unsigned index);
  /// The scale s.
  [[nodiscard]] static Jet scale();

  [[nodiscard]] Number value() const;
  /// The coefficient of infinitesimal `index`.
  [[nodiscard]] Jet along(unsigned index) const;
  /// The terms without infinitesimal `index`.
  [[nodiscard]] Jet without(unsigned index) const;
  /// The sum of the terms up to s^`order`, at s = 1.
  [[nodiscard]] Jet up_to(int order) const;

  Jet& operator+=(const Jet& other);
  Jet& operator-=(const Jet& other);

  /// The highest power of s that products keep. One value serves all jets, because only one
  /// computation runs at a time.
  static int order;

 private:
  using Key = unsigned;  ///< 64 * exponent of s, plus one bit for each infinitesimal
  std::map<Key, Number> terms_;

  [[nodiscard]] int nilpotency() const;
  friend Jet operator*(const Jet& a, const Jet& b);
  friend Jet composed(const Jet& x, const std::vector<Number>& series);
  friend int terms_needed(const Jet& x);
};

[[nodiscard]] Jet operator+(Jet a, const Jet& b);
[[nodiscard]] Jet operator-(Jet a, const Jet& b);
[[nodiscard]] Jet operator-(const Jet& a);
[[nodiscard]] Jet operator*(const Jet& a, const Jet& b);
[[nodiscard]] Jet operator/(const Jet& a, const Jet& b);

/// base^(numerator/denominator). Throws std::domain_error if there is no real value.
[[nodiscard]] Jet power(const Jet& base, int numerator, int denominator);
/// A function of the model language: sin, atan2, abs, ... Throws std::domain_error like `power`.
[[nodiscard]] Jet call(std::string_view function, const std::vector<Jet>& arguments);

using Vector = std::vector<Jet>;
using Matrix = std::vector<Vector>;

[[nodiscard]] Vector along(const Vector& x, unsigned index);
[[nodiscard]] Vector cross(const Vector& a, const Vector& b);
[[nodiscard]] Jet dot(const Vector& a, const Vector& b);
[[nodiscard]] Matrix product(const Matrix& a, const Matrix& b);
[[nodiscard]] Vector product(const Matrix& a, const Vector& b);
[[nodiscard]] Matrix transposed(const Matrix& a);

}  // namespace elgen::test::random
