// display: widths count letters, a measure that LaTeX, GitHub and HTML pages share.
#include "print/display.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace elgen {
namespace {

constexpr double indent = 4;
constexpr std::size_t largest_matrix = 7;  ///< columns of a pmatrix

/// The width of a left side with the equals sign.
double left_width(const Glyphs& left, const PageMetrics& shape) {
  return std::max(shape.least_left_width, shape.measure_left(left)) + 3;
}

double columns_width(const GlyphRows& entries, std::uint32_t columns, const PageMetrics& shape) {
  std::vector<double> widths(columns, shape.between_columns);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    double& column = widths[i % columns];
    column = std::max(column, shape.measure(entries[i]) + shape.between_columns);
  }
  double sum = 2;
  for (const double column : widths) sum += column;
  return sum;
}

double matrix_width(const TypesetEquation& equation, const PageMetrics& shape) {
  return left_width(equation.left, shape) +
         columns_width(equation.entries, equation.columns, shape);
}

Glyphs equation_row(Glyphs left, Glyphs right) {
  append_sign(left, "=", true);
  append(left, std::move(right), true);
  return left;
}

/// Breaks a right side into lines. If the equation exceeds the width and the left side takes more
/// than half of the width, both sides are broken.
DisplayedEquation lines_display(const Glyphs& left, const Glyphs& right, const PageMetrics& shape) {
  const double first = left_width(left, shape);
  if (first > shape.width / 2 && first + shape.measure(right) > shape.width) {
    return {{}, 0, break_lines(equation_row(left, right), shape.width - indent, shape.measure)};
  }
  return {left, 0, break_lines(right, shape.width - std::max(first, indent), shape.measure)};
}

/// X if the row is \sqrt{X}; null otherwise.
const Glyphs* radicand(const Glyphs& row) {
  const bool is_root = row.parts.size() == 1 && row.parts[0].kind == GlyphKind::root;
  return is_root ? &row.parts[0].parts[0] : nullptr;
}

bool is_one(const Glyphs& row) { return row.parts.size() == 1 && row.parts[0].text == "1"; }

/// The first fraction that, with its sign, exceeds `widest` and that split_fraction() can rewrite.
std::optional<std::size_t> find_wide_fraction(const Glyphs& row, double widest,
                                              const PageMetrics& shape) {
  for (std::size_t i = 0; i < row.parts.size(); ++i) {
    const Glyphs& fraction = row.parts[i];
    if (fraction.kind != GlyphKind::fraction) continue;
    const Glyphs* const square = radicand(fraction.parts[1]);
    const bool has_terms = !is_one(fraction.parts[0]) ||
                           is_sum_or_signed(square != nullptr ? *square : fraction.parts[1]);
    Glyphs with_sign;
    if (i > 0) append_sign(with_sign, "-", false);
    append(with_sign, fraction, false);
    if (has_terms && shape.measure(with_sign) > widest) return i;
  }
  return std::nullopt;
}

Glyphs add_brackets(Glyphs content) { return enclose(std::move(content), "(", ")", true); }

/// The parts [first, last) of a row.
Glyphs row_slice(const Glyphs& row, std::size_t first, std::size_t last) {
  const auto begin = row.parts.begin();
  return {GlyphKind::row,
          "",
          {begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last)}};
}

/// The index of the part with which the last factor of a product begins, if this factor is in
/// brackets; otherwise 0.
std::size_t last_bracket_start(const Glyphs& product) {
  if (bracket_depth_change(product.parts.back()) >= 0) return 0;
  int depth = 0;
  for (std::size_t i = product.parts.size(); i-- > 0;) {
    depth -= bracket_depth_change(product.parts[i]);
    if (depth == 0) return product.parts[i].has_space_before ? i : 0;
  }
  return 0;
}

/// N/D -> 1/D (N), which can be broken into lines; g (N)/D -> g/D (N); 1/D -> D^-1.
Glyphs split_fraction(const Glyphs& fraction) {
  const Glyphs& above = fraction.parts[0];
  const Glyphs& below = fraction.parts[1];
  if (is_one(above)) {
    const Glyphs* const square = radicand(below);
    Glyphs row = add_brackets(square != nullptr ? *square : below);
    add_script(row, 2, read_latex(square != nullptr ? "-1/2" : "-1"));
    return row;
  }
  const std::size_t bracket = is_sum_or_signed(above) ? 0 : last_bracket_start(above);
  Glyphs row = fraction_row(bracket == 0 ? read_latex("1") : row_slice(above, 0, bracket), below);
  append(
      row,
      is_sum_or_signed(above) ? add_brackets(above) : row_slice(above, bracket, above.parts.size()),
      true);
  return row;
}

/// The display `left` = `right`. Wide fractions are split, so that lines can break inside them.
DisplayedEquation scalar_display(const Glyphs& left, const Glyphs& right,
                                 const PageMetrics& shape) {
  const double widest = std::max(shape.width / 2, shape.width - left_width(left, shape));
  Glyphs row = right;
  for (auto wide = find_wide_fraction(row, widest, shape); wide;
       wide = find_wide_fraction(row, widest, shape)) {
    Glyphs split = split_fraction(row.parts[*wide]);
    split.parts.front().has_space_before = row.parts[*wide].has_space_before;
    const auto place = row.parts.begin() + static_cast<std::ptrdiff_t>(*wide);
    row.parts.insert(row.parts.erase(place), split.parts.begin(), split.parts.end());
  }
  return lines_display(left, row, shape);
}

bool needs_brackets(const Glyphs& symbol) {
  return std::ranges::any_of(symbol.parts, [](const Glyphs& part) {
    return part.has_space_before || part.kind == GlyphKind::fraction;
  });
}

/// The name of an entry: M_{1, 2}; g_{1} of \mathbf{g}; "(C \dot{q})_{1}". A name that has an index
/// already, such as D_i/M_ii, is put into brackets.
Glyphs entry_name(const TypesetEquation& equation, std::size_t entry) {
  const std::size_t row = entry / equation.columns + 1;
  const Glyphs index =
      read_latex(equation.columns > 1 ? fmt::format("{}, {}", row, entry % equation.columns + 1)
                                      : std::to_string(row));
  const Glyphs& last = equation.left.parts.back();
  const bool has_index = last.kind == GlyphKind::scripts && !last.parts[1].parts.empty();
  Glyphs symbol = needs_brackets(equation.left) || has_index ? add_brackets(equation.left)
                                                             : remove_bold(equation.left);
  add_script(symbol, 1, index);
  return symbol;
}

bool has_letter(const Glyphs& glyphs, const std::string& letter) {
  if (glyphs.kind == GlyphKind::letter && glyphs.text == letter) return true;
  return std::ranges::any_of(glyphs.parts,
                             [&letter](const Glyphs& part) { return has_letter(part, letter); });
}

bool is_zero_entry(const Glyphs& row) { return row.parts.size() == 1 && row.parts[0].text == "0"; }

bool is_symmetric(const TypesetEquation& equation) {
  if (equation.rows != equation.columns) return false;
  const std::uint32_t n = equation.rows;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < i; ++j) {
      if (equation.entries[i * n + j] != equation.entries[j * n + i]) return false;
    }
  }
  return true;
}

std::vector<DisplayedEquation> entry_displays(const TypesetEquation& equation,
                                              const PageMetrics& shape) {
  std::vector<DisplayedEquation> all;
  const bool is_half = equation.columns > 1 && is_symmetric(equation);
  for (std::size_t i = 0; i < equation.entries.size(); ++i) {
    const std::size_t row = i / equation.columns;
    const std::size_t column = i % equation.columns;
    if (is_zero_entry(equation.entries[i]) || (is_half && row > column)) continue;
    Glyphs left = entry_name(equation, i);
    if (is_half && row < column) {
      left = equation_row(std::move(left), entry_name(equation, column * equation.columns + row));
    }
    all.push_back(scalar_display(left, equation.entries[i], shape));
  }
  return all;
}

/// The widths of both sides of an equation.
struct SideWidths {
  double left = 0;
  double right = 0;
};

SideWidths larger_widths(const SideWidths& x, const SideWidths& y) {
  return {std::max(x.left, y.left), std::max(x.right, y.right)};
}

/// The widths of both sides of an equation. A side that takes several lines counts as the full
/// width.
SideWidths side_widths(const TypesetEquation& equation, const PageMetrics& shape) {
  SideWidths sides;
  for (const DisplayedEquation& display : lay_out_equation(equation, shape)) {
    SideWidths own{shape.width, shape.width};
    if (!display.left.parts.empty()) own.left = left_width(display.left, shape);
    if (display.columns > 0) {
      own.right = columns_width(display.rows, display.columns, shape);
    } else if (display.rows.size() == 1) {
      own.right = shape.measure(display.rows.front());
    }
    sides = larger_widths(sides, own);
  }
  return sides;
}

/// The right sides of a display, line by line.
std::vector<std::string> latex_right_sides(const DisplayedEquation& display) {
  std::vector<std::string> texts;
  for (const Glyphs& row : display.rows) texts.push_back(to_latex(row));
  if (display.columns == 0) return texts;
  std::string text = "\\begin{pmatrix}\n";
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const bool ends_row = (i + 1) % display.columns == 0;
    const char* end = i + 1 == texts.size() ? "\n" : ends_row ? " \\\\\n" : " & ";
    text += texts[i] + end;
  }
  return {text + "\\end{pmatrix}"};
}

/// The equation in a line such as "S = int L dt"; none if words precede the equals sign.
std::optional<TypesetEquation> find_equation(const Glyphs& row) {
  for (std::size_t i = 0; i < row.parts.size(); ++i) {
    if (row.parts[i].kind == GlyphKind::prose) break;
    if (row.parts[i].text != "=") continue;
    Glyphs right = row_slice(row, i + 1, row.parts.size());
    right.parts.front().has_space_before = false;
    return TypesetEquation{row_slice(row, 0, i), 1, 1, {std::move(right)}};
  }
  return std::nullopt;
}

}  // namespace

TypesetEquation typeset_equation(const PageEquation& equation) {
  TypesetEquation set{glyphs_of(equation.left), equation.rows, equation.columns, {}};
  for (const Formula& entry : equation.entries) set.entries.push_back(glyphs_of(entry));
  return set;
}

TypesetSection typeset_section(const PageSection& section) {
  TypesetSection set;
  for (const Formula& line : section.lines) {
    Glyphs row = glyphs_of(line);
    std::optional<TypesetEquation> equation =
        section.is_aligned ? find_equation(row) : std::nullopt;
    if (equation) {
      set.equations.push_back(std::move(*equation));
    } else {
      set.lines.push_back(std::move(row));
    }
  }
  for (const PageEquation& equation : section.equations) {
    set.equations.push_back(typeset_equation(equation));
  }
  return set;
}

bool fits_as_matrix(const TypesetEquation& equation, const PageMetrics& shape) {
  return equation.columns <= largest_matrix && matrix_width(equation, shape) <= shape.width;
}

bool is_listed(const TypesetEquation& equation, const PageMetrics& shape) {
  return equation.entries.size() > 1 && !fits_as_matrix(equation, shape);
}

bool omits_zeros(const TypesetEquation& equation, const PageMetrics& shape) {
  return is_listed(equation, shape) && std::ranges::any_of(equation.entries, is_zero_entry);
}

std::vector<DisplayedEquation> lay_out_equation(const TypesetEquation& equation,
                                                const PageMetrics& shape) {
  if (equation.entries.size() == 1) {
    // The symbol of a single number loses its bold type. A definition keeps the bold type of the
    // vectors in it; a symbol keeps it if the number contains its letter, as in g = m g l.
    const Glyphs& entry = equation.entries.front();
    const bool keeps_bold = std::ranges::any_of(equation.left.parts, [&entry](const Glyphs& part) {
      return part.text == "=" || bracket_depth_change(part) != 0 || has_letter(entry, part.text);
    });
    return {scalar_display(keeps_bold ? equation.left : remove_bold(equation.left), entry, shape)};
  }
  if (fits_as_matrix(equation, shape)) {
    return {{equation.left, equation.columns, equation.entries}};
  }
  return entry_displays(equation, shape);
}

NamedEntries named_entries(const TypesetEquation& equation, const PageMetrics& shape) {
  NamedEntries result{equation, equation};
  const bool is_half = equation.columns > 1 && is_symmetric(equation);
  for (std::size_t i = 0; i < equation.entries.size(); ++i) {
    const std::size_t row = i / equation.columns;
    const std::size_t column = i % equation.columns;
    const bool is_below = is_half && row > column;
    Glyphs name = entry_name(equation, is_below ? column * equation.columns + row : i);
    const bool is_wider = shape.measure(equation.entries[i]) > shape.measure(name);
    if (is_wider) {
      result.matrix.entries[i] = std::move(name);
    } else {
      result.named.entries[i] = read_latex("0");
    }
  }
  return result;
}

std::vector<DisplayBlock> aligned_blocks(const std::vector<TypesetEquation>& equations,
                                         const PageMetrics& shape) {
  std::vector<DisplayBlock> blocks;
  const auto fit_together = [&shape](const SideWidths& sides) {
    return sides.left <= shape.width / 3 || sides.left + sides.right <= shape.width;
  };
  for (auto first = equations.begin(); first != equations.end();) {
    SideWidths sides = side_widths(*first, shape);
    auto end = first + 1;
    for (; end != equations.end(); ++end) {
      const SideWidths wider = larger_widths(sides, side_widths(*end, shape));
      if (!fit_together(wider)) break;
      sides = wider;
    }
    PageMetrics aligned = shape;
    if (end - first > 1) aligned.least_left_width = sides.left - 3;
    DisplayBlock& block = blocks.emplace_back();
    for (; first != end; ++first) {
      for (DisplayedEquation& display : lay_out_equation(*first, aligned))
        block.push_back(std::move(display));
    }
  }
  return blocks;
}

std::size_t line_count(const DisplayBlock& block) {
  std::size_t count = 0;
  for (const DisplayedEquation& display : block)
    count += display.columns > 0 ? 1 : display.rows.size();
  return count;
}

std::string latex_block(const DisplayBlock& block) {
  const bool is_one_line = line_count(block) == 1;
  std::string text;
  for (const DisplayedEquation& display : block) {
    const std::vector<std::string> rights = latex_right_sides(display);
    const bool is_whole = display.left.parts.empty();
    const std::string left = to_latex(display.left);
    if (is_one_line && !is_whole) return fmt::format("{} = {}", left, rights.front());
    text += text.empty() ? "" : " \\\\\n";
    text += is_whole ? "& " : left + " &= ";
    text += fmt::format("{}", fmt::join(rights, " \\\\\n&\\quad "));
  }
  return fmt::format("\\begin{{aligned}}\n{}\n\\end{{aligned}}", text);
}

}  // namespace elgen
