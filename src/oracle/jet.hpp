// Jet: a number with nilpotent parts; nested dual numbers of any depth, stored sparsely.
//
//     x = sum over subsets S of generators:  x_S * product of e_i, i in S,    e_i * e_i = 0
//
// Dual numbers are jets in one generator, duals of duals jets in two. The coefficient of e_0 e_1 of
// f(x + w e_0 + y e_1) is the second derivative of f in the directions w and y, exactly. Absent
// terms are exact zeros and take no part in any operation.
//
// One further symbol s has powers. A power of s has a grade; grades add in products, and terms of
// grade 256 or more vanish. If s has grade 64, s^3 is the last power, and the coefficients of 1, s,
// s^2, s^3 in f(x + y s) are the Taylor coefficients.
//
// Functions of jets, by the chain rule from the table of derivatives:
//
//     f(x0 + x1 e, y0 + y1 e) = f(x0, y0) + (f_x x1 + f_y y1) e
//
// applied to one generator after another, until only real functions remain. Powers of s become
// generators first: with e = e_1 + ... + e_n, the coefficient of e_1 ... e_j in f(x0 + x1(s) e) is
// j! times the part of f(x0 + x1(s)) of degree j in x1.
//
// With x = 0 + e, x^2 has no terms. Therefore a jet also stores the generators on which it depends,
// and its order: the lowest power of these generators with which the jet may deviate from its real
// part. sqrt(x^2) deviates from 0 with power 1: it has a kink at 0, and its derivatives are unknown
// coefficients. Reading an unknown coefficient throws OutsideDomain; a product with an exact zero,
// as in sqrt(x^2)^2, drops it.
#pragma once
#include <cln/rational.h>
#include <cln/real.h>

#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "elgen/functions.hpp"
#include "oracle/real_functions.hpp"

namespace elgen::oracle {

/// A set of generators, one bit each. The eight highest bits hold the grade of the power of s.
using Generators = std::uint32_t;

[[nodiscard]] constexpr Generators generator(unsigned index) { return Generators{1} << index; }

inline constexpr unsigned first_grade_bit = 24;
inline constexpr Generators all_generators = generator(first_grade_bit) - 1;

/// s; powers above `order` vanish.
[[nodiscard]] constexpr Generators graded_symbol(unsigned order) {
  return ((256 + order) / (order + 1)) << first_grade_bit;
}

class Jet {
 public:
  using Term = std::pair<Generators, cln::cl_R>;

  Jet() = default;
  Jet(const cln::cl_R& real);
  Jet(int real) : Jet(cln::cl_R(real)) {}

  /// coefficient times the product of the generators.
  Jet(Generators generators, const cln::cl_R& coefficient);

  [[nodiscard]] const std::vector<Term>& terms() const { return terms_; }
  /// The coefficient of the product of `generators`; OutsideDomain if this coefficient is unknown.
  [[nodiscard]] cln::cl_R coefficient(Generators generators) const;
  [[nodiscard]] cln::cl_R real() const { return coefficient(0); }

  /// True if every coefficient is an exact zero.
  [[nodiscard]] bool is_zero() const { return terms_.empty() && unknown_coefficients_.empty(); }

  /// The union of the generators of all terms and unknown coefficients.
  [[nodiscard]] Generators support() const;

  /// All generators on which the value may depend, even if no term contains them.
  [[nodiscard]] Generators dependencies() const { return dependencies_; }

  /// A lower bound on the power p with which the value deviates from its real part: by |d|^p for
  /// displacements d along dependencies().
  [[nodiscard]] unsigned deviation_order() const;

  /// The coefficient of the generator `one`, which is the derivative along `one`.
  [[nodiscard]] Jet tangent(Generators one) const { return part(one, one); }

  /// The jet without the terms that contain any of these generators.
  [[nodiscard]] Jet without(Generators any) const { return part(any, 0); }

  /// The grade bits of the lowest power of s in any term; 0 if no term contains s.
  [[nodiscard]] Generators lowest_grade() const;

  /// The coefficient of exactly these generators.
  [[nodiscard]] Jet part(Generators exactly) const { return part(all_generators, exactly); }

  /// The value at s = 1: terms of all grades summed.
  [[nodiscard]] Jet sum_grades() const;

  /// Every coefficient replaced by its absolute value.
  [[nodiscard]] Jet absolute_coefficients() const;

  /// The jet without its real part and without float zeros, so that some power of the result
  /// vanishes.
  [[nodiscard]] Jet nilpotent_part() const;

  /// Sets dependencies() and `order_` as for a smooth function of x and y.
  void depend_on(const Jet& x, const Jet& y);

  /// real + c |d|^order with c unknown and d a displacement along the generators `moving`.
  /// Derivatives of lower order are 0, all others unknown. OutsideDomain if order < 1: the first
  /// derivative is infinite.
  [[nodiscard]] static Jet with_kink(const cln::cl_R& real, Generators moving,
                                     const cln::cl_RA& order);

  /// Converts coefficients that are rationals of more than max_rational_bits bits to floats.
  void shorten();

  friend Jet operator+(const Jet& x, const Jet& y);
  friend Jet operator-(const Jet& x);
  friend Jet operator*(const Jet& x, const Jet& y);
  /// OutsideDomain if the real part of y is zero.
  friend Jet operator/(const Jet& x, const Jet& y);
  /// True if coefficients (and their exactness), dependencies() and `order_` of x and y are equal.
  friend bool is_same(const Jet& x, const Jet& y);

 private:
  /// The terms whose generators among `of` are exactly `exactly`, divided by these generators.
  [[nodiscard]] Jet part(Generators of, Generators exactly) const;
  void add_term(Generators generators, const cln::cl_R& coefficient);
  void add_unknown_coefficient(Generators generators);
  void depend_on_factors(const Jet& x, const Jet& y);

  /// The `order_` of a constant, which never deviates from its real part.
  static constexpr unsigned constant_order = 255;

  std::vector<Term> terms_ = {};  ///< ascending by generators, no exact zeros
  /// The generators of each coefficient that is unknown, because the derivative does not exist.
  std::vector<Generators> unknown_coefficients_ = {};
  Generators dependencies_ = 0;
  unsigned order_ = constant_order;
};

[[nodiscard]] Jet operator-(const Jet& x, const Jet& y);

[[nodiscard]] bool is_same(const Jet& x, const Jet& y);

class JetFunctions {
 public:
  /// f(x), or f(x, y).
  [[nodiscard]] Jet value(FunctionId function, const Jet& x, const Jet& y = {});

  /// x ^ exponent. Integer exponents: any x, but x != 0 if exponent <= 0. Other exponents: x > 0,
  /// or x = 0 if the value exists. Derivatives that do not exist are unknown coefficients.
  [[nodiscard]] Jet power(const Jet& x, const cln::cl_RA& exponent);

 private:
  struct Gradient {
    Jet x;
    Jet y;
  };
  struct Call {
    FunctionId function;
    Jet x;
    Jet y;
    Jet value;
  };
  Gradient gradient(FunctionId function, const Jet& x, const Jet& y, const Jet& f);

  RealFunctions real_ = {};
  std::deque<Call> memoised_calls_ = {};  ///< calls with generators, the latest first
};

}  // namespace elgen::oracle
