// formula_text: formulas on one line, with as few brackets as the order of evaluation allows.
//
//                          model language      C
//     quotient             m/(k + c)           m / (k + c)
//     product              m*(k*c)             m * (k * c)
//     negation first       -a*b                -a * b
//
// Operands on the right keep their brackets, which preserves the order of rounding. Code and
// printed trees follow the same rules.
#pragma once

#include <cln/rational.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/functions.hpp"

namespace elgen {

/// How tightly a formula binds, weakest first. A product with a leading sign is a negation: -a*b.
enum class Binding : std::uint8_t { sum, negation, product, power, atom };

/// A formula as text. Names and numbers are atoms.
struct FormulaText {
  std::string text = {};
  Binding binding = Binding::atom;
};

/// One term of sum_text(): text that is added or subtracted.
struct Summand {
  FormulaText term = {};
  bool is_subtracted = false;
};

/// The operators of a language for products and quotients.
struct OperatorSpelling {
  std::string_view times;  ///< between factors
  std::string_view over;
};

inline constexpr OperatorSpelling model_spelling{"*", "/"};
inline constexpr OperatorSpelling code_spelling{" * ", " / "};  ///< C and C++

/// Adds brackets if the formula binds less tightly than `least`.
[[nodiscard]] FormulaText bracket_if_weaker(const FormulaText& formula, Binding least);

[[nodiscard]] FormulaText negation_text(const FormulaText& operand);
[[nodiscard]] FormulaText sum_text(const std::vector<Summand>& terms);
[[nodiscard]] FormulaText product_text(const OperatorSpelling& spelling,
                                       const std::vector<FormulaText>& factors);
[[nodiscard]] FormulaText quotient_text(const OperatorSpelling& spelling, const FormulaText& above,
                                        const FormulaText& below);
/// The power as written in the model language.
[[nodiscard]] FormulaText power_text(const FormulaText& base, const FormulaText& exponent);
/// The call "f(x, y)" of a function.
[[nodiscard]] FormulaText named_call_text(std::string_view name,
                                          const std::vector<FormulaText>& arguments);

}  // namespace elgen
