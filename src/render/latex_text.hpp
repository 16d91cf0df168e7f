// latex_text: where fractions, sums and prose stand in the LaTeX of our own formulas, which stays
// text: it is printed again as it is, but for the part that was looked for.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace elgen {

/// Where the brace that opens at `open` closes; npos where it does not, or none opens there.
[[nodiscard]] std::size_t closing_brace(std::string_view latex, std::size_t open);

/// \frac{above}{below}, the characters [begin, end).
struct FractionPlace {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string above = {};
  std::string below = {};
};

/// Fractions outside of braces, from left to right.
[[nodiscard]] std::vector<FractionPlace> fractions(const std::string& latex);

/// Whether the text begins with a sign between terms and its blanks.
[[nodiscard]] bool separates_terms(std::string_view rest);

/// Whether a sign stands in front, or between terms outside of braces and brackets.
[[nodiscard]] bool is_sum(std::string_view latex);

/// Where the last factor of a product begins, if it stands in brackets; else 0.
[[nodiscard]] std::size_t last_bracket(std::string_view product);

/// A formula, or prose between formulas.
struct LatexPiece {
  bool is_prose = false;
  std::string text = {};
};

/// \text{…} outside of braces is prose; so is a comma in front of it.
[[nodiscard]] std::vector<LatexPiece> pieces(const std::string& latex);

/// The components of a vector are not bold: \mathbf{g} -> g, \mathbf{bias} -> \mathrm{bias}.
[[nodiscard]] std::string without_bold(std::string latex);

[[nodiscard]] std::string without_outer_blanks(std::string_view text);

[[nodiscard]] std::string replaced(std::string text, std::string_view from, std::string_view to);

}  // namespace elgen
