// Enclosure: a closed interval of doubles that contains all values of an expression on a box; the
// scalar type of interval arithmetic.
//
//     [1, 2] - [0, 3]   ->   [-2, 2]            sin([1, 2])   ->   [0.8414…, 1]
//
// Sums, products, quotients and roots are rounded outwards by at most one ulp. Exact results that
// are not tiny are not rounded. Functions are widened by 8 ulp, because C libraries have errors of
// a few ulp. An operand times itself (the same object) is a square.
//
// Source: R. E. Moore, R. B. Kearfott, M. J. Cloud, Introduction to Interval Analysis, 2009.
#pragma once

#include "elgen/real.hpp"

namespace elgen {

/// Whether an expression is defined and continuous on the box.
enum class Definedness : std::uint8_t {
  everywhere,
  somewhere,  ///< not everywhere; the bounds hold at all points with a value
  nowhere,    ///< the bounds are empty
};

struct Enclosure {
  double low = 0;
  double high = 0;
  Definedness definedness = Definedness::everywhere;
};

/// [x, x]
[[nodiscard]] inline Enclosure point_enclosure(double x) { return {x, x}; }

/// False if the enclosure excludes the value x.
[[nodiscard]] bool may_contain(const Enclosure& enclosure, double x);

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

/// Encloses an exact number between the nearest doubles.
template <>
struct ScalarTraits<Enclosure> {
  [[nodiscard]] static Enclosure from_real(const cln::cl_R& value);
};

}  // namespace elgen
