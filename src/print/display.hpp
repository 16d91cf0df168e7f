// display: fits equations into a page, as a matrix, on one line or on several.
//
//     M = ( 2 x 2 )        if the columns fit side by side
//     M_{1 2} = …          entry by entry if the columns do not fit; zeros are omitted
//     a = b - 1/Δ (…       if a fraction is too wide: its numerator, in brackets, can be broken
//     a = (…)^-1           a wide 1/(…) becomes a power, whose base can be broken
//
// A block is a list of equations with aligned equals signs.
#pragma once

#include <string>
#include <vector>

#include "elgen/page.hpp"
#include "formula/glyphs.hpp"

namespace elgen {

/// An equation of a page, in glyphs.
struct TypesetEquation {
  Glyphs left = {};
  std::uint32_t rows = 1;
  std::uint32_t columns = 1;
  GlyphRows entries = {};
};
[[nodiscard]] TypesetEquation typeset_equation(const PageEquation& equation);
/// The lines and the equations of a section. In an aligned section, a line that is an equation
/// moves to the equations, before the other equations.
struct TypesetSection {
  GlyphRows lines = {};
  std::vector<TypesetEquation> equations = {};
};
[[nodiscard]] TypesetSection typeset_section(const PageSection& section);

/// The width available for formulas, and the functions that measure formulas.
struct PageMetrics {
  double width = 78;
  double (*measure)(const Glyphs&) = &elgen::width;  ///< in letters by default
  double (*measure_left)(const Glyphs&) = &elgen::width;
  double between_columns = 2.5;
  double least_left_width = 0;  ///< the minimal width of left sides
};

/// The equation `left` = a matrix. If `columns` is 0, the right side is text on one or more lines.
/// If `left` is empty, these lines contain both sides of a long equation.
struct DisplayedEquation {
  Glyphs left = {};
  std::uint32_t columns = 0;
  GlyphRows rows = {};  ///< row-major entries, or lines
};

[[nodiscard]] std::vector<DisplayedEquation> lay_out_equation(const TypesetEquation& equation,
                                                              const PageMetrics& shape = {});

/// Displays below each other, with aligned equals signs.
using DisplayBlock = std::vector<DisplayedEquation>;

/// Groups equations into as few blocks as possible. An equation with a long left side gets its own
/// block, because it would leave too little room for the lines of other equations.
[[nodiscard]] std::vector<DisplayBlock> aligned_blocks(
    const std::vector<TypesetEquation>& equations, const PageMetrics& shape = {});

/// True if a pmatrix of all entries fits the page.
[[nodiscard]] bool fits_as_matrix(const TypesetEquation& equation, const PageMetrics& shape);

/// True if the entries are listed one by one, because their matrix does not fit.
[[nodiscard]] bool is_listed(const TypesetEquation& equation, const PageMetrics& shape = {});

/// True if the entries are listed one by one and an entry that is 0 is omitted.
[[nodiscard]] bool omits_zeros(const TypesetEquation& equation, const PageMetrics& shape = {});

/// A matrix in which a name replaces each entry that is wider than the name, and the matrix of
/// these entries (0 elsewhere). In a symmetric matrix, M_21 has the name M_12.
struct NamedEntries {
  TypesetEquation matrix = {};
  TypesetEquation named = {};
};
[[nodiscard]] NamedEntries named_entries(const TypesetEquation& equation, const PageMetrics& shape);

/// The number of lines of a block; a matrix counts as one line.
[[nodiscard]] std::size_t line_count(const DisplayBlock& block);

/// The LaTeX between \[ and \]: aligned or pmatrix.
[[nodiscard]] std::string latex_block(const DisplayBlock& block);

}  // namespace elgen
