// pieces: parts of formulas, written in one notation, put together with as few brackets as
// precedence allows.
//
//                       text                latex
//     power, quotient   x^2, m/(k + c)      x^{2}, \frac{m}{k + c}
//     product           m*l*dot(theta)      m l \dot{\theta}
//     call              sin(theta)^2        \sin^{2} \theta
//
// A notation is one row of spellings; nothing else knows which one is being written.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/functions.hpp"

namespace elgen::rendering {

enum class Precedence : std::uint8_t { sum, product, power, atom };

/// How a notation writes what is not a name; holes in the order of the operands.
struct Notation {
  std::string_view add, subtract, negate;
  std::string_view power, quotient, root;
  std::string_view rate, second_rate;
  bool is_two_dimensional;  ///< fractions are stacked, factors stand side by side
};

[[nodiscard]] const Notation& text_notation();  ///< the model language
[[nodiscard]] const Notation& latex_notation();

/// An exponent goes between head and tail: `\sin` and ` \theta`.
struct Piece {
  std::string head = {};
  Precedence precedence = Precedence::atom;
  std::string tail = {};

  [[nodiscard]] std::string text() const { return head + tail; }
};

struct Factor {
  Piece base;
  long exponent = 1;
};

[[nodiscard]] Piece negated(const Notation& notation, const Piece& operand);
[[nodiscard]] Piece sum(const Notation& notation, const Piece& left, const Piece& right);
[[nodiscard]] Piece difference(const Notation& notation, const Piece& left, const Piece& right);
[[nodiscard]] Piece quotient(const Notation& notation, const Piece& above, const Piece& below);
[[nodiscard]] Piece product(const Notation& notation, const std::vector<Factor>& factors);
[[nodiscard]] Piece square_root(const Notation& notation, const Piece& radicand);
[[nodiscard]] Piece call(const Notation& notation, FunctionId function,
                         const std::vector<Piece>& arguments);

}  // namespace elgen::rendering
