// display: measured in letters, which is what a page of LaTeX, of GitHub and of HTML have in
// common.
#include "render/display.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace elgen {
namespace {

constexpr double indent = 4;
constexpr std::size_t largest_matrix = 7;  ///< columns of a pmatrix

double measured(const std::string& latex, const PageShape& shape) {
  return shape.measured(read_latex(latex));
}

/// With its sign.
double left_width(const std::string& left, const PageShape& shape) {
  return std::max(shape.left, shape.left_measured(read_latex(left))) + 3;
}

double columns_width(const std::vector<std::string>& entries, std::uint32_t columns,
                     const PageShape& shape) {
  std::vector<double> widths(columns, shape.between_columns);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    double& column = widths[i % columns];
    column = std::max(column, measured(entries[i], shape) + shape.between_columns);
  }
  double sum = 2;
  for (const double column : widths) sum += column;
  return sum;
}

double matrix_width(const SheetEquation& equation, const PageShape& shape) {
  return left_width(equation.left, shape) +
         columns_width(equation.entries, equation.columns, shape);
}

/// A left side that takes most of a line is broken, too.
Display lines_display(const std::string& left, const std::string& right, const PageShape& shape) {
  const double first = left_width(left, shape);
  if (first > shape.width / 2 && first + measured(right, shape) > shape.width) {
    const std::string whole = fmt::format("{} = {}", left, right);
    return {"", 0, latex_lines(whole, shape.width - indent, shape.measured)};
  }
  return {left, 0, latex_lines(right, shape.width - std::max(first, indent), shape.measured)};
}

/// X of \sqrt{X}; none of anything else.
std::optional<std::string> radicand(const std::string& latex) {
  constexpr std::string_view root = "\\sqrt{";
  const bool is_root =
      latex.starts_with(root) && closing_brace(latex, root.size() - 1) + 1 == latex.size();
  if (!is_root) return std::nullopt;
  return latex.substr(root.size(), latex.size() - root.size() - 1);
}

/// The first fraction that is, with its sign, wider than `widest` and can be taken apart.
std::optional<FractionPlace> wide_fraction(const std::string& latex, double widest,
                                           const PageShape& shape) {
  for (FractionPlace& fraction : fractions(latex)) {
    const std::string sign = fraction.begin > 1 ? "-" : latex.substr(0, fraction.begin);
    const std::string text = sign + latex.substr(fraction.begin, fraction.end - fraction.begin);
    const bool has_terms =
        fraction.above != "1" || is_sum(radicand(fraction.below).value_or(fraction.below));
    if (has_terms && measured(text, shape) > widest) return std::move(fraction);
  }
  return std::nullopt;
}

/// N/D -> 1/D (N), of which lines can be made; g (N)/D -> g/D (N); 1/D -> D^-1.
std::string taken_apart(const FractionPlace& fraction) {
  const std::string& above = fraction.above;
  if (above == "1") {
    const std::optional<std::string> square = radicand(fraction.below);
    return fmt::format("\\left( {} \\right)^{{{}}}", square.value_or(fraction.below),
                       square ? "-1/2" : "-1");
  }
  if (is_sum(above)) {
    return fmt::format("\\frac{{1}}{{{}}} \\left( {} \\right)", fraction.below, above);
  }
  const std::size_t bracket = last_bracket(above);
  return fmt::format("\\frac{{{}}}{{{}}} {}", bracket == 0 ? "1" : above.substr(0, bracket - 1),
                     fraction.below, above.substr(bracket));
}

/// Fractions too wide for a line stand in front of their numerators, or become powers.
Display number_display(const std::string& left, const std::string& right, const PageShape& shape) {
  const double widest = std::max(shape.width / 2, shape.width - left_width(left, shape));
  std::string text = right;
  for (auto wide = wide_fraction(text, widest, shape); wide;
       wide = wide_fraction(text, widest, shape)) {
    text.replace(wide->begin, wide->end - wide->begin, taken_apart(*wide));
  }
  return lines_display(left, text, shape);
}

bool needs_brackets(const std::string& symbol) {
  return symbol.find(' ') != std::string::npos || symbol.find("\\frac") != std::string::npos;
}

/// M_{1, 2}; g_{1} of \mathbf{g}; "(C \dot{q})_{1}"; the name of a fraction D_i/M_ii is not indexed
/// again.
std::string indexed(const SheetEquation& equation, std::size_t entry) {
  const std::size_t row = entry / equation.columns + 1;
  const std::string index = equation.columns > 1
                                ? fmt::format("{}, {}", row, entry % equation.columns + 1)
                                : std::to_string(row);
  const std::string& left = equation.left;
  const bool has_index = left.back() == '}' && left.find("_{") != std::string::npos;
  if (needs_brackets(left) || has_index) {
    return fmt::format("\\left( {} \\right)_{{{}}}", left, index);
  }
  return fmt::format("{}_{{{}}}", without_bold(left), index);
}

bool is_symmetric(const SheetEquation& equation) {
  if (equation.rows != equation.columns) return false;
  const std::uint32_t n = equation.rows;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < i; ++j) {
      if (equation.entries[i * n + j] != equation.entries[j * n + i]) return false;
    }
  }
  return true;
}

std::vector<Display> entry_displays(const SheetEquation& equation, const PageShape& shape) {
  std::vector<Display> all;
  const bool is_half = equation.columns > 1 && is_symmetric(equation);
  for (std::size_t i = 0; i < equation.entries.size(); ++i) {
    const std::size_t row = i / equation.columns;
    const std::size_t column = i % equation.columns;
    if (equation.entries[i] == "0" || (is_half && row > column)) continue;
    std::string left = indexed(equation, i);
    if (is_half && row < column) {
      left += " = " + indexed(equation, column * equation.columns + row);
    }
    all.push_back(number_display(left, equation.entries[i], shape));
  }
  return all;
}

/// The widths of both sides of displays.
struct Sides {
  double left = 0;
  double right = 0;
};

Sides wider_of(const Sides& x, const Sides& y) {
  return {std::max(x.left, y.left), std::max(x.right, y.right)};
}

/// Lines that are continued take the whole page, and so does a left side that is broken.
Sides sides_of(const SheetEquation& equation, const PageShape& shape) {
  Sides sides;
  for (const Display& display : displays(equation, shape)) {
    Sides own{shape.width, shape.width};
    if (!display.left.empty()) own.left = left_width(display.left, shape);
    if (display.columns > 0) {
      own.right = columns_width(display.texts, display.columns, shape);
    } else if (display.texts.size() == 1) {
      own.right = measured(display.texts.front(), shape);
    }
    sides = wider_of(sides, own);
  }
  return sides;
}

/// The right sides of a display, line by line.
std::vector<std::string> latex_right_sides(const Display& display) {
  const std::vector<std::string>& texts = display.texts;
  if (display.columns == 0) return texts;
  std::string text = "\\begin{pmatrix}\n";
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const bool ends_row = (i + 1) % display.columns == 0;
    const char* end = i + 1 == texts.size() ? "\n" : ends_row ? " \\\\\n" : " & ";
    text += texts[i] + end;
  }
  return {text + "\\end{pmatrix}"};
}

}  // namespace

bool fits_as_matrix(const SheetEquation& equation, const PageShape& shape) {
  return equation.columns <= largest_matrix && matrix_width(equation, shape) <= shape.width;
}

bool is_listed(const SheetEquation& equation, const PageShape& shape) {
  return equation.entries.size() > 1 && !fits_as_matrix(equation, shape);
}

bool leaves_out_zeros(const SheetEquation& equation, const PageShape& shape) {
  return is_listed(equation, shape) && std::ranges::count(equation.entries, "0") > 0;
}

std::vector<Display> displays(const SheetEquation& equation, const PageShape& shape) {
  if (equation.entries.size() == 1) {
    // A definition of its own keeps its vectors; the symbol of one number is none.
    const bool is_defined = equation.left.find(" = ") != std::string::npos;
    return {number_display(is_defined ? equation.left : without_bold(equation.left),
                           equation.entries.front(), shape)};
  }
  if (fits_as_matrix(equation, shape)) {
    return {{equation.left, equation.columns, equation.entries}};
  }
  return entry_displays(equation, shape);
}

NamedEntries named_entries(const SheetEquation& equation, const PageShape& shape) {
  NamedEntries result{equation, equation};
  const bool is_half = equation.columns > 1 && is_symmetric(equation);
  for (std::size_t i = 0; i < equation.entries.size(); ++i) {
    const std::size_t row = i / equation.columns;
    const std::size_t column = i % equation.columns;
    const bool is_below = is_half && row > column;
    std::string name = indexed(equation, is_below ? column * equation.columns + row : i);
    const bool is_wider = measured(equation.entries[i], shape) > measured(name, shape);
    if (is_wider) {
      result.matrix.entries[i] = std::move(name);
    } else {
      result.named.entries[i] = "0";
    }
  }
  return result;
}

std::vector<DisplayBlock> aligned_blocks(const std::vector<SheetEquation>& equations,
                                         const PageShape& shape) {
  std::vector<DisplayBlock> blocks;
  const auto stand_together = [&shape](const Sides& sides) {
    return sides.left <= shape.width / 3 || sides.left + sides.right <= shape.width;
  };
  for (auto first = equations.begin(); first != equations.end();) {
    Sides sides = sides_of(*first, shape);
    auto end = first + 1;
    for (; end != equations.end(); ++end) {
      const Sides wider = wider_of(sides, sides_of(*end, shape));
      if (!stand_together(wider)) break;
      sides = wider;
    }
    PageShape aligned = shape;
    if (end - first > 1) aligned.left = sides.left - 3;
    DisplayBlock& block = blocks.emplace_back();
    for (; first != end; ++first) {
      for (Display& display : displays(*first, aligned)) block.push_back(std::move(display));
    }
  }
  return blocks;
}

std::size_t line_count(const DisplayBlock& block) {
  std::size_t count = 0;
  for (const Display& display : block) count += display.columns > 0 ? 1 : display.texts.size();
  return count;
}

std::string latex_block(const DisplayBlock& block) {
  const bool is_one_line = line_count(block) == 1;
  std::string text;
  for (const Display& display : block) {
    const std::vector<std::string> rights = latex_right_sides(display);
    const bool is_whole = display.left.empty();
    if (is_one_line && !is_whole) return fmt::format("{} = {}", display.left, rights.front());
    text += text.empty() ? "" : " \\\\\n";
    text += is_whole ? "& " : display.left + " &= ";
    text += fmt::format("{}", fmt::join(rights, " \\\\\n&\\quad "));
  }
  return fmt::format("\\begin{{aligned}}\n{}\n\\end{{aligned}}", text);
}

}  // namespace elgen
