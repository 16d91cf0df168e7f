// Constant: a number that depends on no leaf, with its exact form in rational numbers and pi.
//
//     form   1 - cos(3/10)      value   0.0446635108743939…
//
// Two constants are equal if and only if their forms are equal; values are never compared.
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

struct ConstantOperand;

/// A tree of constants: a sum of signed terms, a product of powers, or a function of signed
/// arguments.
struct ConstantForm {
  ConstantKind kind = ConstantKind::rational;
  cln::cl_RA number = 0;                  ///< the value, if `kind` is rational
  FunctionId function = FunctionId::sin;  ///< the function, if `kind` is call
  std::vector<ConstantOperand> operands;  ///< no initializer: ConstantOperand is incomplete here
};

/// An operand of a ConstantForm. `weight` is the exponent (not 0) of a factor, or the sign (1 or
/// -1) of a term or an argument.
struct ConstantOperand {
  ConstantForm form = {};
  std::int32_t weight = 1;
};

[[nodiscard]] bool operator==(const ConstantForm& x, const ConstantForm& y);
[[nodiscard]] bool operator==(const ConstantOperand& x, const ConstantOperand& y);

[[nodiscard]] ConstantForm rational_form(const cln::cl_RA& number);

/// -x. If possible, the sign is absorbed: by a number, the terms of a sum, or an odd function among
/// the factors.
[[nodiscard]] ConstantForm negated_form(ConstantForm x);

/// The value of `form`, with a bound of its error. The value is exact, or a float of at least 220
/// digits with |error| <= 1e-200 |value| (|error| <= 1e-200 if even 1760 digits cancel). None if
/// the form has no real value, or if 1760 digits do not decide whether the value is real.
[[nodiscard]] std::optional<EnclosedNumber> enclosed_value(const ConstantForm& form);

/// The form as a Formula:
///
///     model language    1/2*cos(3/10)     sqrt(3)^(-1)
///     LaTeX             \frac{1}{2} \cos \frac{3}{10}    \frac{1}{\sqrt{3}}
[[nodiscard]] Formula constant_formula(const ConstantForm& form);

/// `form` in the model language: "1/2*pi", "1 - cos(3/10)".
[[nodiscard]] std::string text_of(const ConstantForm& form);

struct Constant {
  /// The value of `form`: rational if `form` is rational, otherwise a float with 200 correct
  /// digits, or 0 if the enclosure of the value contains 0.
  cln::cl_R value = 0;
  ConstantForm form = {};
};

[[nodiscard]] Constant rational_constant(const cln::cl_RA& number);

/// The constant with this form; none if enclosed_value(form) is none.
[[nodiscard]] std::optional<Constant> make_constant(ConstantForm form);

[[nodiscard]] bool is_rational(const Constant& constant);

/// The index of `wanted` in `constants`. If `wanted` is missing, appends `wanted`.
[[nodiscard]] std::uint32_t intern_constant(const Constant& wanted,
                                            std::vector<Constant>& constants);

}  // namespace elgen
