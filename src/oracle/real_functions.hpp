// Real arithmetic of the oracle: the functions of the model language to working_digits decimal
// digits. This arithmetic and the code under test share only CLN's sines and cosines.
//
// Exact rationals stay exact while they are short. Exact zeros stay exact, so derivatives that are
// 0 cost nothing. Random doubles become floats, which represent them exactly. Arguments are reduced
// with as many digits as their magnitude needs. Undefined values throw OutsideDomain, which the
// oracle's interface catches.
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

/// Decimal digits of all floats. The oracle's results have at least 60 correct digits, or more
/// inside with_digits(); the other 35 are a reserve for cancellation. For comparison, textbook
/// expressions lose 16 digits at 1e-8 rad from a singular chart.
inline constexpr unsigned working_digits = 95;

/// The quantity is undefined at this state: division by zero, or a root or logarithm of a negative
/// number.
struct OutsideDomain : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The quantity may have a value, but a number in it is too large to be computed.
struct NumberTooLarge : OutsideDomain {
  using OutsideDomain::OutsideDomain;
};

/// `x` in working precision; a float is returned unchanged.
[[nodiscard]] cln::cl_R as_float(const cln::cl_R& x);

/// Rationals of more bits become floats, because their gcds would dominate all other costs.
inline constexpr unsigned max_rational_bits = 4096;
/// Rational leaves of a state with more bits become floats. Decimals of 14 digits and the rationals
/// of exact states are shorter. Random doubles have about 106 bits: as rationals they would make
/// sums and products 2 to 4 times slower.
inline constexpr unsigned max_leaf_bits = 96;

/// `x` itself, or a float if it is a rational of more bits than `max_bits`.
[[nodiscard]] cln::cl_R shorten_rationals(const cln::cl_R& x,
                                          unsigned max_bits = max_rational_bits);

/// pi in working precision.
[[nodiscard]] cln::cl_R real_pi();

/// x / y; OutsideDomain if y = 0.
[[nodiscard]] cln::cl_R quotient(const cln::cl_R& x, const cln::cl_R& y);

/// x ^ exponent for x > 0; exact if the exponent is n/2, n odd, and sqrt(x) is rational.
[[nodiscard]] cln::cl_R real_power(const cln::cl_R& x, const cln::cl_RA& exponent);

/// Memoises every value, because all directions of a derivative use the same arguments.
class RealFunctions {
 public:
  /// f(x), or f(x, y) for binary functions.
  [[nodiscard]] cln::cl_R value(FunctionId function, const cln::cl_R& x, const cln::cl_R& y = 0);

 private:
  using Call = std::tuple<FunctionId, cln::cl_R, cln::cl_R>;
  cln::cl_R compute_and_store(FunctionId function, const cln::cl_R& x, const cln::cl_R& y);

  std::map<Call, cln::cl_R> memoised_values_ = {};
};

/// The computed value; empty if CLN or the oracle throws because the value does not exist.
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

/// attempt() with as many digits as large angles need. With fewer digits a value may seem
/// undefined.
template <class Computation>
auto attempt_with_enough_digits(const Computation& computation)
    -> std::optional<decltype(computation())> {
  return with_enough_digits([&] { return attempt(computation); });
}

}  // namespace elgen::oracle
