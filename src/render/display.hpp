// display: equations -> what fits a page: a matrix, one line, or several.
//
//     M = ( 2 x 2 )        where the columns fit side by side
//     M_{1 2} = …          entry by entry where they do not; zeros are left out
//     a = b - numerator/denominator, each of which follows, where a fraction is too wide
#pragma once

#include <string>
#include <vector>

#include "elgen/render.hpp"
#include "render/latex_tree.hpp"

namespace elgen {

/// How wide formulas may be, and how wide one is.
struct PageShape {
  double width = 78;
  double (*measured)(const LatexTree&) = &elgen::width;  ///< in letters, unless told otherwise
  double between_columns = 2.5;
};

/// `left` = a matrix of columns, or (columns 0) lines that continue each other. Without `left`, the
/// lines stand alone.
struct Display {
  std::string left = {};
  std::uint32_t columns = 0;
  std::vector<std::string> texts = {};  ///< LaTeX: entries, row-major, or lines
};

[[nodiscard]] std::vector<Display> displays(const SheetEquation& equation,
                                            const PageShape& shape = {});

/// Whether a pmatrix of all entries fits.
[[nodiscard]] bool fits_as_matrix(const SheetEquation& equation, const PageShape& shape);

/// Whether entries stand one by one, since a matrix of them does not fit.
[[nodiscard]] bool is_listed(const SheetEquation& equation, const PageShape& shape = {});

/// Whether entries that are 0 are left out of a list.
[[nodiscard]] bool leaves_out_zeros(const SheetEquation& equation, const PageShape& shape = {});

/// A matrix that has names where its entries are wider than their names, and those entries, 0
/// elsewhere. In a symmetric matrix the names are those above its diagonal.
struct NamedEntries {
  SheetEquation matrix = {};
  SheetEquation named = {};
};
[[nodiscard]] NamedEntries named_entries(const SheetEquation& equation, const PageShape& shape);

/// The LaTeX between \[ and \]: aligned or pmatrix.
[[nodiscard]] std::string latex_block(const Display& display);

}  // namespace elgen
