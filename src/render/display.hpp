// display: equations -> what fits a page: a matrix, one line, or several.
//
//     M = ( 2 x 2 )        where the columns fit side by side
//     M_{1 2} = …          entry by entry where they do not; zeros are left out
//     a = numerator/denominator, each of which follows, where a fraction is too wide
#pragma once

#include <string>
#include <vector>

#include "elgen/render.hpp"

namespace elgen {

/// Widest formula of a page, in letters.
inline constexpr double page_width = 78;

/// `left` = a matrix of columns, or (columns 0) lines that continue each other. Without `left`, the
/// lines stand alone.
struct Display {
  std::string left = {};
  std::uint32_t columns = 0;
  std::vector<std::string> texts = {};  ///< LaTeX: entries, row-major, or lines
};

[[nodiscard]] std::vector<Display> displays(const SheetEquation& equation);

/// The LaTeX between \[ and \]: aligned or pmatrix.
[[nodiscard]] std::string latex_block(const Display& display);

}  // namespace elgen
