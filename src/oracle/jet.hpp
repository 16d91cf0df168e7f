// Jet: a number with nilpotent parts; nested dual numbers of any depth, stored sparsely.
//
//     x = sum over subsets S of generators:  x_S * product of e_i, i in S,    e_i * e_i = 0
//
// Dual numbers are jets in one generator, duals of duals jets in two. The coefficient of e_0 e_1 of
// f(x + w e_0 + y e_1) is the second derivative of f in the directions w and y, exactly. Absent
// terms are exact zeros and take no part in any operation.
//
// One more symbol s is kept to any order: its powers have grades that add up in products, and what
// reaches 256 vanishes. With grade 64 for s, s^3 is the last power, and the coefficients of 1, s,
// s^2, s^3 in f(x + y s) are those of Taylor's formula.
//
// Functions of jets, by the chain rule from the table of derivatives:
//
//     f(x0 + x1 e, y0 + y1 e) = f(x0, y0) + (f_x x1 + f_y y1) e
//
// applied to one generator after another, so that only real functions are left. Powers of s turn
// into generators first: with e = e_1 + ... + e_n, f(x0 + x1(s) e) has at e_1 ... e_j j! times the
// part of f(x0 + x1(s)) of degree j in x1.
//
// x^2 at x = 0 has no terms left. So a jet also knows the generators that it depends on, and the
// lowest power of them by which it may leave its real part. sqrt(x^2) leaves 0 by the power 1: it
// has a bend there, and its derivatives are unknown coefficients. Reading one throws OutsideDomain;
// a product with an exact zero, as in sqrt(x^2)^2, drops it.
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

/// A set of generators, one bit each, and a grade in the eight highest bits.
using Generators = std::uint32_t;

[[nodiscard]] constexpr Generators generator(unsigned index) { return Generators{1} << index; }

inline constexpr unsigned first_grade_bit = 24;
inline constexpr Generators all_generators = generator(first_grade_bit) - 1;

/// s, of which powers up to `order` are kept.
[[nodiscard]] constexpr Generators graded_symbol(unsigned order) {
  return ((256 + order) / (order + 1)) << first_grade_bit;
}

class Jet {
 public:
  using Term = std::pair<Generators, cln::cl_R>;

  Jet() = default;
  Jet(const cln::cl_R& real);
  Jet(int real) : Jet(cln::cl_R(real)) {}

  /// coefficient * product of the generators.
  Jet(Generators generators, const cln::cl_R& coefficient);

  [[nodiscard]] const std::vector<Term>& terms() const { return terms_; }
  /// OutsideDomain if it is unknown.
  [[nodiscard]] cln::cl_R coefficient(Generators generators) const;
  [[nodiscard]] cln::cl_R real() const { return coefficient(0); }

  /// No coefficient but exact zeros.
  [[nodiscard]] bool is_zero() const { return terms_.empty() && unknown_.empty(); }

  /// All generators that occur.
  [[nodiscard]] Generators support() const;

  /// All generators that it may depend on.
  [[nodiscard]] Generators moving() const { return moving_; }

  /// A lower bound of the power of displacements along them by which it leaves its real part.
  [[nodiscard]] unsigned order() const;

  /// The factor of a generator: the derivative, itself a jet in the others.
  [[nodiscard]] Jet tangent(Generators one) const { return part(one, one); }

  /// Drops every term that has one of the generators.
  [[nodiscard]] Jet without(Generators any) const { return part(any, 0); }

  /// The lowest power of s that occurs, by its grade; 0 where none does.
  [[nodiscard]] Generators lowest_grade() const;

  /// The coefficient of exactly these generators.
  [[nodiscard]] Jet part(Generators exactly) const { return part(all_generators, exactly); }

  /// The value at s = 1: terms of all grades summed.
  [[nodiscard]] Jet ungraded() const;

  /// Every coefficient without its sign.
  [[nodiscard]] Jet magnitudes() const;

  /// Without the real part, and without zeros that are floats: some power of it vanishes.
  [[nodiscard]] Jet nilpotent() const;

  /// Depends on what x and y depend on, as a function of both does.
  void depend_on(const Jet& x, const Jet& y);

  /// A number to which |d|^order is added, d a displacement along the generators: derivatives of
  /// lower order are 0, the others unknown. OutsideDomain if the first one is infinite.
  [[nodiscard]] static Jet bent(const cln::cl_R& real, Generators moving, const cln::cl_RA& order);

  /// Too long rationals become floats.
  void shorten();

  friend Jet operator+(const Jet& x, const Jet& y);
  friend Jet operator-(const Jet& x);
  friend Jet operator*(const Jet& x, const Jet& y);
  /// OutsideDomain if the real part of y is zero.
  friend Jet operator/(const Jet& x, const Jet& y);
  /// As numbers, and exact alike.
  friend bool is_same(const Jet& x, const Jet& y);

 private:
  /// The coefficient of exactly these generators `of` some.
  [[nodiscard]] Jet part(Generators of, Generators exactly) const;
  void add(Generators generators, const cln::cl_R& coefficient);
  void add_unknown(Generators generators);
  void depend_on_factors(const Jet& x, const Jet& y);

  /// The order of a constant.
  static constexpr unsigned never = 255;

  std::vector<Term> terms_ = {};          ///< ascending in their generators, no exact zeros
  std::vector<Generators> unknown_ = {};  ///< whose coefficients do not exist
  Generators moving_ = 0;
  unsigned order_ = never;
};

[[nodiscard]] Jet operator-(const Jet& x, const Jet& y);

[[nodiscard]] bool is_same(const Jet& x, const Jet& y);

class JetFunctions {
 public:
  /// f(x), or f(x, y).
  [[nodiscard]] Jet value(FunctionId function, const Jet& x, const Jet& y = {});

  /// x ^ exponent. Whole exponents take every x (negative ones every x but 0), others x > 0, and
  /// x = 0 where the value exists there; derivatives that do not are unknown.
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
  std::deque<Call> known_ = {};  ///< with generators, the latest first
};

}  // namespace elgen::oracle
