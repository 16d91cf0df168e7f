// formula: formulas, put together from their parts in one language after the other, with as few
// brackets as the order of evaluation allows.
//
//                          model language      LaTeX                  C
//     quotient             m/(k + c)           \frac{m}{k + c}        m / (k + c)
//     product, power       m*l*sin(theta)^2    m l \sin^{2} \theta    m * l * (s * s)
//     negation first       -a*b                -a b                   -a * b
//
// A spelling is one row per language. Products and sums are as read (of many factors, with powers)
// or as executed (of two operands each): operands on the right keep the order of rounding.
#pragma once

#include <cln/rational.h>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/functions.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// How tightly a formula holds together, weakest first. A product that begins with a sign is a
/// negation: -a*b.
enum class Binding : std::uint8_t { sum, negation, product, power, atom };

/// A formula as it is written; a name or a number is an atom.
struct Formula {
  std::string head = {};
  Binding binding = Binding::atom;
  std::string tail = {};  ///< an exponent stands in front of it: `\sin` and ` \theta`

  [[nodiscard]] std::string text() const { return head + tail; }
};

struct Summand {
  Formula term = {};
  bool is_subtracted = false;
};

/// How a language writes what is no name; holes in the order of the operands.
struct Spelling {
  std::string_view times;  ///< between factors
  std::string_view quotient;
  std::string_view power = {};
  std::string_view root = {};
  bool is_two_dimensional = false;  ///< fractions are stacked, factors stand side by side

  [[nodiscard]] bool has_powers() const { return !power.empty(); }
};

inline constexpr Spelling model_spelling{"*", "{}/{}", "{}^{}", "sqrt({})"};
inline constexpr Spelling latex_spelling{" ", "\\frac{{{}}}{{{}}}", "{}^{{{}}}", "\\sqrt{{{}}}",
                                         true};
inline constexpr Spelling code_spelling{" * ", "{} / {}"};  ///< C and C++; without powers

/// In brackets where it binds less tightly than `least`.
[[nodiscard]] Formula at_least(const Spelling& spelling, const Formula& formula, Binding least);

[[nodiscard]] Formula negated(const Spelling& spelling, const Formula& operand);
[[nodiscard]] Formula sum(const Spelling& spelling, const std::vector<Summand>& terms);
/// In LaTeX functions stand last: sin(x) (a + b) is written (a + b) \sin x.
[[nodiscard]] Formula product(const Spelling& spelling, const std::vector<Formula>& factors);
[[nodiscard]] Formula quotient(const Spelling& spelling, const Formula& above,
                               const Formula& below);
[[nodiscard]] Formula power(const Spelling& spelling, const Formula& base, const Formula& exponent);
[[nodiscard]] Formula square_root(const Spelling& spelling, const Formula& radicand);
/// A function of the model language.
[[nodiscard]] Formula call(const Spelling& spelling, FunctionId function,
                           const std::vector<Formula>& arguments);

/// "f(x, y)", whatever the language.
[[nodiscard]] Formula called(std::string_view name, const std::vector<Formula>& arguments);

/// 3, -1/2: a quotient of integers; stacked long ones are decimals where they can be.
[[nodiscard]] Formula number(const Spelling& spelling, const cln::cl_RA& value);

/// An expression of a model, with as few brackets as keep the tree:
///
///     multiply(1/2, add(a, negate(b)))   ->   1/2*(a - b)
///
/// `name` writes what has a name: leaves, pi, definitions, components of points and frames, and
/// rates.
[[nodiscard]] Formula formula_of(const Model& model, ExpressionId expression,
                                 const Spelling& spelling,
                                 const std::function<Formula(ExpressionId)>& name);

}  // namespace elgen
