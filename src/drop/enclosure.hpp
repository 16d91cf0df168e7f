// Enclosure: an interval of rationals that holds a value; operations widen, never narrow.
#pragma once

#include <cln/rational.h>
#include <cln/real.h>

#include <cstdint>
#include <optional>

namespace elgen {

struct Enclosure {
  cln::cl_RA low = 0;
  cln::cl_RA high = 0;
};

/// The number, or an interval of relative width 1e-90 about one that is not rational.
[[nodiscard]] Enclosure enclosure_of(const cln::cl_R& value);
/// [low, high], outward where they are not rational.
[[nodiscard]] Enclosure enclosure_of(const cln::cl_R& low, const cln::cl_R& high);

[[nodiscard]] Enclosure sum(const Enclosure& x, const Enclosure& y);
[[nodiscard]] Enclosure product(const Enclosure& x, const Enclosure& y);
/// None where x holds 0 and the exponent is negative.
[[nodiscard]] std::optional<Enclosure> power(const Enclosure& x, std::int32_t exponent);
/// Of the part of x that is not negative.
[[nodiscard]] Enclosure square_root(const Enclosure& x);

/// The largest |x|.
[[nodiscard]] cln::cl_RA magnitude(const Enclosure& x);

}  // namespace elgen
