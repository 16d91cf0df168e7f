// Enclosed numbers: numbers known to within an error bound, and the functions of functions.def on
// them, with their domains.
//
//     sin(10^30)  at 220 digits    ->    -0.0901169…  with an error of at most 1e-179
//
// Every operation adds its rounding error, u |x|, to the propagated errors of its operands. The
// sign of a number is therefore either certain or undecided. More digits may decide it.
#pragma once

#include <cln/float.h>
#include <cln/real.h>

#include <cstdint>
#include <optional>

#include "elgen/functions.hpp"

namespace elgen {

/// |value - x| <= error for a number x.
struct EnclosedNumber {
  cln::cl_R value = 0;  ///< exact if rational and the error is 0; otherwise a float
  cln::cl_R error = 0;
};

[[nodiscard]] bool is_exact(const EnclosedNumber& x);
[[nodiscard]] EnclosedNumber operator-(const EnclosedNumber& x);

/// -1, 0 or 1; none if the enclosure contains 0 and other numbers.
[[nodiscard]] std::optional<int> sign_of(const EnclosedNumber& x);

/// Why an operation has no value.
enum class NoValueReason : std::uint8_t {
  unknown,    ///< undecided at this precision
  undefined,  ///< 1/0, log(0), tan(pi/2)
  complex,    ///< sqrt(-1), asin(2)
  too_large,  ///< beyond 10^±10000
};

/// A number, or the reason why it is missing.
struct EnclosedResult {
  std::optional<EnclosedNumber> number = {};
  NoValueReason reason = NoValueReason::unknown;

  EnclosedResult(EnclosedNumber value) : number(std::move(value)) {}
  EnclosedResult(NoValueReason no_value) : reason(no_value) {}
};

/// Operations in floats of `digits` decimal digits. For rational operands, a rational result is
/// exact if it is known without rounding.
class EnclosedArithmetic {
 public:
  explicit EnclosedArithmetic(int digits);

  [[nodiscard]] EnclosedNumber pi() const;
  [[nodiscard]] EnclosedNumber sum(const EnclosedNumber& x, const EnclosedNumber& y) const;
  [[nodiscard]] EnclosedNumber product(const EnclosedNumber& x, const EnclosedNumber& y) const;
  [[nodiscard]] EnclosedResult reciprocal(const EnclosedNumber& x) const;
  [[nodiscard]] EnclosedResult power(const EnclosedNumber& x, const cln::cl_RA& exponent) const;
  /// f(x), or f(x, y) for a function of two arguments.
  [[nodiscard]] EnclosedResult call(FunctionId function, const EnclosedNumber& x,
                                    const EnclosedNumber& y) const;

 private:
  [[nodiscard]] cln::cl_F as_float(const cln::cl_R& x) const { return cln::cl_float(x, format_); }
  [[nodiscard]] EnclosedNumber add_rounding_error(const cln::cl_R& value,
                                                  const cln::cl_R& error) const;
  [[nodiscard]] EnclosedNumber to_float(const EnclosedNumber& x) const;
  [[nodiscard]] EnclosedNumber call_with_slope(FunctionId function, const EnclosedNumber& x,
                                               const cln::cl_R& slope) const;
  [[nodiscard]] EnclosedNumber square_root(const EnclosedNumber& x) const;
  [[nodiscard]] EnclosedResult integer_power(const EnclosedNumber& x,
                                             const cln::cl_I& exponent) const;
  [[nodiscard]] EnclosedResult tangent(const EnclosedNumber& x) const;
  [[nodiscard]] EnclosedResult inverse_circular(FunctionId function, const EnclosedNumber& x) const;
  [[nodiscard]] EnclosedResult arc_tangent_2(const EnclosedNumber& y,
                                             const EnclosedNumber& x) const;
  [[nodiscard]] EnclosedResult logarithm(FunctionId function, const EnclosedNumber& x) const;
  [[nodiscard]] EnclosedResult exponential(FunctionId function, const EnclosedNumber& x) const;
  [[nodiscard]] EnclosedResult stumpff(const EnclosedNumber& x, const EnclosedNumber& k) const;

  cln::float_format_t format_;
  cln::cl_R roundoff_;
};

/// f(x) or f(x, y) if this value is rational and known without computing: cos(0), log(1), hypot(3,
/// 4). Functions of one argument ignore y.
[[nodiscard]] std::optional<cln::cl_RA> exact_function_value(FunctionId function,
                                                             const cln::cl_RA& x,
                                                             const cln::cl_RA& y);

/// f(x) or f(x, y) for arguments in the domain. CLN throws if the result exceeds its exponents.
[[nodiscard]] cln::cl_R function_value(FunctionId function, const cln::cl_F& x, const cln::cl_F& y);

/// Sine and cosine from CLN, which computes both at the cost of one. The latest results are cached,
/// because derivatives and other functions at the same state need them again. The cache is
/// thread-local, because `sin` and `cos` of Real take one number and cannot pass on a cache.
[[nodiscard]] cln::cos_sin_t cos_sin_of(const cln::cl_F& x);

/// A constant with a larger decimal exponent is too large.
inline constexpr double largest_decimal_exponent = 10'000;

}  // namespace elgen
