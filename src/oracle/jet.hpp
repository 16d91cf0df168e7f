// Jet: a number with nilpotent parts; nested dual numbers of any depth, stored sparsely.
//
//     x = sum over subsets S of generators:  x_S * product of e_i, i in S,    e_i * e_i = 0
//
// Dual numbers are jets in one generator, duals of duals jets in two. The coefficient of e_0 e_1 of
// f(x + w e_0 + y e_1) is the second derivative of f in the directions w and y, exactly. Absent
// terms are exact zeros and take no part in any operation.
#pragma once

#include <cln/real.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace elgen::oracle {

/// A set of generators, one bit each.
using Generators = std::uint32_t;

[[nodiscard]] constexpr Generators generator(unsigned index) { return Generators{1} << index; }

class Jet {
 public:
  using Term = std::pair<Generators, cln::cl_R>;

  Jet() = default;
  Jet(const cln::cl_R& real);
  Jet(int real) : Jet(cln::cl_R(real)) {}

  /// coefficient * product of the generators.
  Jet(Generators generators, const cln::cl_R& coefficient);

  [[nodiscard]] const std::vector<Term>& terms() const { return terms_; }
  [[nodiscard]] cln::cl_R coefficient(Generators generators) const;
  [[nodiscard]] cln::cl_R real() const { return coefficient(0); }

  /// All generators that occur.
  [[nodiscard]] Generators support() const;

  /// The factor of a generator: the derivative, itself a jet in the others.
  [[nodiscard]] Jet tangent(Generators one) const;

  /// Without every term in which one of the generators occurs.
  [[nodiscard]] Jet without(Generators any) const;

  /// Too long rationals become floats.
  void shorten();

  friend Jet operator+(const Jet& x, const Jet& y);
  friend Jet operator-(const Jet& x);
  friend Jet operator*(const Jet& x, const Jet& y);

 private:
  void add(Generators generators, const cln::cl_R& coefficient);

  std::vector<Term> terms_ = {};  ///< ascending in their generators, no exact zeros
};

[[nodiscard]] Jet operator-(const Jet& x, const Jet& y);

/// OutsideDomain where the real part of y is zero.
[[nodiscard]] Jet operator/(const Jet& x, const Jet& y);

}  // namespace elgen::oracle
