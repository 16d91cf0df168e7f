// Enclosure: a closed interval of doubles that holds all values of an expression on a box; the
// scalar type of interval arithmetic.
//
//     [1, 2] - [0, 3]   ->   [-2, 2]            sin([1, 2])   ->   [0.8414…, 1]
//
// Sums, products, quotients and roots are rounded outwards by at most one place, and not at all
// where they are exact; functions by 8 units of the last place, since C libraries may be off by
// some. An operand times itself (the same object) is a square.
//
// Source: R. E. Moore, R. B. Kearfott, M. J. Cloud, Introduction to Interval Analysis, 2009.
#pragma once

#include "elgen/real.hpp"

namespace elgen {

/// Whether an expression has a value, and is continuous, on the box.
enum class Definedness : std::uint8_t {
  everywhere,
  somewhere,  ///< the bounds hold where there is a value
  nowhere,    ///< there are no bounds
};

struct Enclosure {
  double low = 0;
  double high = 0;
  Definedness defined = Definedness::everywhere;
};

/// [x, x]
[[nodiscard]] inline Enclosure enclosure_of(double x) { return {x, x}; }

/// Whether x may be a value; true where nothing is known.
[[nodiscard]] bool may_be(const Enclosure& enclosure, double x);

/// max |x|
[[nodiscard]] double magnitude(const Enclosure& x);

[[nodiscard]] Enclosure operator-(const Enclosure& x);
[[nodiscard]] Enclosure operator+(const Enclosure& x, const Enclosure& y);
[[nodiscard]] Enclosure operator-(const Enclosure& x, const Enclosure& y);
[[nodiscard]] Enclosure operator*(const Enclosure& x, const Enclosure& y);
[[nodiscard]] Enclosure operator*(const Enclosure& x, int factor);
[[nodiscard]] Enclosure operator/(const Enclosure& x, const Enclosure& y);
[[nodiscard]] Enclosure sqrt(const Enclosure& x);
#define ELGEN_ENCLOSURE_1(name) [[nodiscard]] Enclosure name(const Enclosure& x);
#define ELGEN_ENCLOSURE_2(name) \
  [[nodiscard]] Enclosure name(const Enclosure& x, const Enclosure& y);
#define ELGEN_FUNCTION(name, arity) ELGEN_ENCLOSURE_##arity(name)
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
#undef ELGEN_ENCLOSURE_2
#undef ELGEN_ENCLOSURE_1

/// The nearest doubles around an exact number.
template <>
struct ScalarTraits<Enclosure> {
  [[nodiscard]] static Enclosure from_real(const cln::cl_R& value);
};

}  // namespace elgen
