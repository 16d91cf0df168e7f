// display: equations -> what fits a page: a matrix, one line, or several.
//
//     M = ( 2 x 2 )        where the columns fit side by side
//     M_{1 2} = …          entry by entry where they do not; zeros are left out
//     a = b - 1/Δ (…       where a fraction is too wide: in front of the lines of its numerator;
//     a = (…)^-1           1/(…) as a power, of which lines can be made
//
// Aligned equations are blocks, of which the left sides end in one place.
#pragma once

#include <string>
#include <vector>

#include "elgen/page.hpp"
#include "formula/glyphs.hpp"

namespace elgen {

/// An equation of a page as it is set.
struct SetEquation {
  Glyphs left = {};
  std::uint32_t rows = 1;
  std::uint32_t columns = 1;
  GlyphRows entries = {};
};
[[nodiscard]] SetEquation set_equation(const PageEquation& equation);
/// The equations of a section: of an aligned one those lines that are equations, first. They are
/// taken out of the lines.
struct SetSection {
  GlyphRows lines = {};
  std::vector<SetEquation> equations = {};
};
[[nodiscard]] SetSection set_section(const PageSection& section);

/// How wide formulas may be, and how wide one is.
struct PageShape {
  double width = 78;
  double (*measured)(const Glyphs&) = &elgen::width;  ///< in letters, unless told otherwise
  double (*left_measured)(const Glyphs&) = &elgen::width;
  double between_columns = 2.5;
  double left = 0;  ///< the least width of left sides
};

/// `left` = a matrix of columns, or (columns 0) lines that continue each other. Without `left` the
/// lines are both sides of a long equation.
struct Display {
  Glyphs left = {};
  std::uint32_t columns = 0;
  GlyphRows rows = {};  ///< entries, row-major, or lines
};

[[nodiscard]] std::vector<Display> displays(const SetEquation& equation,
                                            const PageShape& shape = {});

/// Displays below each other, their signs in one column.
using DisplayBlock = std::vector<Display>;

/// As few blocks as possible: equations with long left sides stand alone, as they leave too little
/// room for the lines of others.
[[nodiscard]] std::vector<DisplayBlock> aligned_blocks(const std::vector<SetEquation>& equations,
                                                       const PageShape& shape = {});

/// Whether a pmatrix of all entries fits.
[[nodiscard]] bool fits_as_matrix(const SetEquation& equation, const PageShape& shape);

/// Whether entries stand one by one, since a matrix of them does not fit.
[[nodiscard]] bool is_listed(const SetEquation& equation, const PageShape& shape = {});

/// Whether entries that are 0 are left out of a list.
[[nodiscard]] bool leaves_out_zeros(const SetEquation& equation, const PageShape& shape = {});

/// A matrix that has names where its entries are wider than their names, and those entries, 0
/// elsewhere. In a symmetric matrix the names are those above its diagonal.
struct NamedEntries {
  SetEquation matrix = {};
  SetEquation named = {};
};
[[nodiscard]] NamedEntries named_entries(const SetEquation& equation, const PageShape& shape);

/// Lines of the block, of which a matrix is one.
[[nodiscard]] std::size_t line_count(const DisplayBlock& block);

/// The LaTeX between \[ and \]: aligned or pmatrix.
[[nodiscard]] std::string latex_block(const DisplayBlock& block);

}  // namespace elgen
