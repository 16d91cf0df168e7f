// Constant: a number that depends on nothing, with how it is made of rational numbers and pi.
//
//     form   1 - cos(3/10)      value   0.0446635108743939…
//
// Two constants are one where their forms are, never because values or texts are close.
#pragma once

#include <cln/real.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elgen/functions.hpp"

namespace elgen {

struct EnclosedNumber;
struct Formula;

enum class ConstantKind : std::uint8_t { rational, pi, sum, product, square_root, call };

struct ConstantPart;

/// A tree of numbers: terms with their signs, factors with their exponents, arguments with their
/// signs.
struct ConstantForm {
  ConstantKind kind = ConstantKind::rational;
  cln::cl_RA number = 0;                  ///< of a rational
  FunctionId function = FunctionId::sin;  ///< of a call
  std::vector<ConstantPart> parts;        ///< no initializer: ConstantPart is incomplete here
};

/// weight: the exponent in a product (not 0), the sign (1 or -1) elsewhere.
struct ConstantPart {
  ConstantForm form = {};
  std::int32_t weight = 1;
};

[[nodiscard]] bool operator==(const ConstantForm& x, const ConstantForm& y);
[[nodiscard]] bool operator==(const ConstantPart& x, const ConstantPart& y);

[[nodiscard]] ConstantForm rational_form(const cln::cl_RA& number);

/// -x, its sign moved inside where a number, a sum or an odd factor takes it.
[[nodiscard]] ConstantForm negated(ConstantForm x);

/// The value with a bound of the error: a float of at least 220 digits unless exact, its error at
/// most 1e-200 |value|, or 1e-200 where 1760 digits cancelled. None where the form has no real
/// value, or where 1760 digits do not tell whether it has one.
[[nodiscard]] std::optional<EnclosedNumber> enclosure_of(const ConstantForm& form);

/// As a formula:
///
///     model language    1/2*cos(3/10)     sqrt(3)^(-1)
///     LaTeX             \frac{1}{2} \cos \frac{3}{10}    \frac{1}{\sqrt{3}}
[[nodiscard]] Formula constant_formula(const ConstantForm& form);

/// In the model language: `1/2*pi`, `1 - cos(3/10)`.
[[nodiscard]] std::string text_of(const ConstantForm& form);

struct Constant {
  /// Rational where the form is; else to 200 digits, and 0 where these do not tell it from 0.
  cln::cl_R value = 0;
  ConstantForm form = {};
};

[[nodiscard]] Constant rational_constant(const cln::cl_RA& number);

/// The constant of a form; none where it has no value.
[[nodiscard]] std::optional<Constant> constant_of(ConstantForm form);

[[nodiscard]] bool is_rational(const Constant& constant);

/// The position of `wanted` in the list, where it is appended if it is new.
[[nodiscard]] std::uint32_t position_of(const Constant& wanted, std::vector<Constant>& constants);

}  // namespace elgen
