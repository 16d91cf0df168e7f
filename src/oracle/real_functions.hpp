// Real arithmetic of the oracle: the functions of the model language to working_digits decimal
// digits. It is the oracle's own, and shares no value of a function with what it judges but CLN's
// sines and cosines.
//
// Exact rationals stay exact as long as they are short, and exact zeros stay exact, so that
// derivatives that vanish cost nothing. Drawn doubles are floats, in which they are exact, too.
// Arguments of any size are reduced with as many digits as their magnitude asks for. Undefined
// values throw OutsideDomain, which is caught at the oracle's interface.
#pragma once

#include <cln/exception.h>
#include <cln/float.h>
#include <cln/real.h>

#include <map>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "elgen/functions.hpp"
#include "numbers/more_digits.hpp"

namespace elgen::oracle {

/// 60 digits are promised (more where a computation asks); the other 35 are what sums may cancel:
/// 1e-8 rad from a singular chart the textbook expressions lose 16, and 1e-150 rad is a matter of
/// exponents, not of digits.
inline constexpr unsigned working_digits = 95;

/// The quantity is undefined at this state: division by zero, a root or logarithm of a negative
/// number.
struct OutsideDomain : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The quantity may have a value, but a number in it is too large to be computed.
struct BeyondReach : OutsideDomain {
  using OutsideDomain::OutsideDomain;
};

/// `x` in working precision, unless it already is a float.
[[nodiscard]] cln::cl_R as_float(const cln::cl_R& x);

/// Rationals of more bits become floats: gcds of longer ones dominate the cost of everything else.
inline constexpr unsigned longest_rational = 4096;
/// Likewise leaves: decimals of 14 digits and the rationals of exact states are shorter. Drawn
/// doubles have about 106 bits, and as rationals make sums and products two to four times as slow.
inline constexpr unsigned longest_leaf = 96;

/// `x` itself, or a float if it is a rational of more bits than `longest`.
[[nodiscard]] cln::cl_R shortened(const cln::cl_R& x, unsigned longest = longest_rational);

/// pi in working precision.
[[nodiscard]] cln::cl_R real_pi();

/// x / y; OutsideDomain where y = 0.
[[nodiscard]] cln::cl_R quotient(const cln::cl_R& x, const cln::cl_R& y);

/// x ^ exponent for x > 0 and rational exponents; exact where the square root of a rational is.
[[nodiscard]] cln::cl_R real_power(const cln::cl_R& x, const cln::cl_RA& exponent);

/// Remembers every value: each direction of a derivative meets the same arguments again.
class RealFunctions {
 public:
  /// The value of a function; `y` is the second argument of those that have one.
  [[nodiscard]] cln::cl_R value(FunctionId function, const cln::cl_R& x, const cln::cl_R& y = 0);

 private:
  using Call = std::tuple<FunctionId, cln::cl_R, cln::cl_R>;
  cln::cl_R remembered(FunctionId function, const cln::cl_R& x, const cln::cl_R& y);

  std::map<Call, cln::cl_R> known_ = {};
};

/// CLN and the oracle throw where a value does not exist; callers get an empty optional.
template <class Computation>
auto attempt(const Computation& computation) -> std::optional<decltype(computation())> {
  try {
    return computation();
  } catch (const cln::runtime_exception&) {
    return std::nullopt;
  } catch (const OutsideDomain&) {
    return std::nullopt;
  }
}

/// To as many digits as its angles ask for: without them a value may seem not to exist.
template <class Computation>
auto guarded(const Computation& computation) -> std::optional<decltype(computation())> {
  return with_enough_digits([&] { return attempt(computation); });
}

}  // namespace elgen::oracle
