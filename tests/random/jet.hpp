// Numbers that know how they change: polynomials in a scale s, cut at an order, and in
// infinitesimals whose squares are 0. The coefficient of e1 e2 … is the mixed derivative along the
// directions that e1, e2, … multiply; two infinitesimals on one direction give its second
// derivative. s carries Taylor series (approximations); a model without one has order 0. Arithmetic
// in Number, no code of src/.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <map>
#include <string_view>
#include <vector>

namespace elgen::random {

/// 80 decimal digits.
using Number = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<80>,
                                             boost::multiprecision::et_off>;

[[nodiscard]] const Number& pi();

class Jet {
 public:
  Jet() = default;
  Jet(const Number& value);  // NOLINT(google-explicit-constructor): numbers are constant jets
  Jet(int value) : Jet(Number(value)) {}  // NOLINT(google-explicit-constructor)

  /// The infinitesimal of this index, 0 … 5.
  [[nodiscard]] static Jet infinitesimal(unsigned index);
  /// s to the first power.
  [[nodiscard]] static Jet scale();

  [[nodiscard]] Number value() const;
  /// The part that the infinitesimal multiplies, without it.
  [[nodiscard]] Jet along(unsigned index) const;
  /// The part without the infinitesimal.
  [[nodiscard]] Jet without(unsigned index) const;
  /// The sum of the coefficients of s^0 … s^order: s becomes 1, higher powers are left out.
  [[nodiscard]] Jet up_to(int order) const;

  Jet& operator+=(const Jet& other);
  Jet& operator-=(const Jet& other);

  /// Powers of s above this are dropped; of all jets, for they are of one computation at a time.
  static int order;

 private:
  using Key = unsigned;  ///< power of s times 64, plus a bit for every infinitesimal
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

/// Throws std::domain_error where there is no real value.
[[nodiscard]] Jet power(const Jet& base, int numerator, int denominator);
/// A function of the model language: sin, atan2, abs, …; throws like power.
[[nodiscard]] Jet call(std::string_view function, const std::vector<Jet>& arguments);

using Vector = std::vector<Jet>;
using Matrix = std::vector<Vector>;

[[nodiscard]] Vector along(const Vector& x, unsigned index);
[[nodiscard]] Vector cross(const Vector& a, const Vector& b);
[[nodiscard]] Jet dot(const Vector& a, const Vector& b);
[[nodiscard]] Matrix product(const Matrix& a, const Matrix& b);
[[nodiscard]] Vector product(const Matrix& a, const Vector& b);
[[nodiscard]] Matrix transposed(const Matrix& a);

}  // namespace elgen::random
