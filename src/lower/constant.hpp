// Exact arithmetic on constants: rationals stay rationals, everything else keeps 100 digits and its
// own text.
#pragma once

#include <cln/rational.h>

#include <vector>

#include "elgen/program.hpp"

namespace elgen {

/// A constant with its sign apart: constants themselves are never negative.
struct SignedConstant {
  Constant constant;
  bool negative = false;
};

[[nodiscard]] bool is_rational(const Constant& constant);

/// The exact value of a constant for which is_rational holds.
[[nodiscard]] cln::cl_RA rational_value(const Constant& constant);

/// `text` for a value that is not rational; a rational states itself.
[[nodiscard]] SignedConstant make_constant(const cln::cl_R& value, const std::string& text = "");

[[nodiscard]] SignedConstant pi_constant();

/// 1/2 + pi + … in the order of their texts, so that the digits do not depend on the order given.
[[nodiscard]] SignedConstant sum_of(std::vector<SignedConstant> terms);
[[nodiscard]] SignedConstant product_of(std::vector<SignedConstant> factors);

/// Undefined combinations (0 to a negative power) are the caller's to exclude.
[[nodiscard]] SignedConstant power_of(const SignedConstant& base, int exponent);

/// sqrt of a constant that is not negative.
[[nodiscard]] SignedConstant square_root_of(const Constant& radicand);

/// f(x) or f(x, y); an empty text says that it has no real value there.
[[nodiscard]] SignedConstant call_of(FunctionId function,
                                     const std::vector<SignedConstant>& arguments);

}  // namespace elgen
