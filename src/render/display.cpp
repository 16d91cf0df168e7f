// display: measured in letters, which is what a page of LaTeX, of GitHub and of HTML have in
// common.
#include "render/display.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "render/latex_tree.hpp"

namespace elgen {
namespace {

constexpr double indent = 4;
constexpr std::size_t largest_matrix = 7;  ///< columns of a pmatrix

double measured(const std::string& latex, const PageShape& shape) {
  return shape.measured(read_latex(latex));
}

double matrix_width(const SheetEquation& equation, const PageShape& shape) {
  std::vector<double> widths(equation.columns, 0);
  for (std::size_t i = 0; i < equation.entries.size(); ++i) {
    double& column = widths[i % equation.columns];
    column = std::max(column, measured(equation.entries[i], shape));
  }
  double sum = measured(equation.left, shape) + 5;
  for (const double column : widths) sum += column + shape.between_columns;
  return sum;
}

Display lines_display(const std::string& left, const std::string& right, const PageShape& shape) {
  const double first = measured(left, shape) + 3;
  return {left, 0, latex_lines(right, shape.width - std::max(first, indent), shape.measured)};
}

/// Where the brace that opens at `open` closes.
std::size_t closing_brace(const std::string& latex, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < latex.size(); ++i) {
    depth += (latex[i] == '{') - (latex[i] == '}');
    if (depth == 0) return i;
  }
  return std::string::npos;
}

/// A formula with a fraction outside of braces, and what stands around that.
struct WideFraction {
  std::string before = {};
  std::string numerator = {};
  std::string denominator = {};
  std::string after = {};
};

/// The first fraction that is, with its sign, wider than `widest`.
std::optional<WideFraction> wide_fraction(const std::string& latex, double widest,
                                          const PageShape& shape) {
  const std::string command = "\\frac";
  std::size_t end = 0;
  for (std::size_t open = latex.find('{'); open != std::string::npos; open = latex.find('{', end)) {
    const std::size_t begin = open < command.size() ? open : open - command.size();
    const bool is_fraction = latex.substr(begin, open - begin) == command;
    const std::size_t above = closing_brace(latex, open);
    end = is_fraction && above != std::string::npos ? closing_brace(latex, above + 1) : above;
    if (end == std::string::npos) return std::nullopt;
    const std::string sign = begin > 1 ? "-" : latex.substr(0, begin);
    if (is_fraction && measured(sign + latex.substr(begin, end + 1 - begin), shape) > widest) {
      return WideFraction{latex.substr(0, begin), latex.substr(open + 1, above - open - 1),
                          latex.substr(above + 2, end - above - 2), latex.substr(end + 1)};
    }
  }
  return std::nullopt;
}

/// One display, or three where a fraction is too wide: it, its numerator, its denominator.
std::vector<Display> number_displays(const std::string& left, const std::string& right,
                                     const PageShape& shape) {
  const auto fraction = wide_fraction(right, shape.width - measured(left, shape) - 3, shape);
  if (!fraction) return {lines_display(left, right, shape)};
  const std::string numerator = "\\mathrm{numerator}";
  const std::string denominator = "\\mathrm{denominator}";
  const std::string named = fmt::format("{}\\frac{{{}}}{{{}}}{}", fraction->before, numerator,
                                        denominator, fraction->after);
  return {lines_display(left, named, shape), lines_display(numerator, fraction->numerator, shape),
          lines_display(denominator, fraction->denominator, shape)};
}

void append(std::vector<Display>& to, const std::vector<Display>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

bool needs_brackets(const std::string& symbol) {
  return symbol.find(' ') != std::string::npos || symbol.find("\\frac") != std::string::npos;
}

/// M_{1, 2}; "(C \dot{q})_{1}"; the name of a fraction D_i/M_ii is not indexed again.
std::string indexed(const SheetEquation& equation, std::size_t entry) {
  const std::size_t row = entry / equation.columns + 1;
  const std::string index = equation.columns > 1
                                ? fmt::format("{}, {}", row, entry % equation.columns + 1)
                                : std::to_string(row);
  const std::string& left = equation.left;
  const bool has_index = left.back() == '}' && left.find("_{") != std::string::npos;
  const bool is_open = !needs_brackets(left) && !has_index;
  return fmt::format(fmt::runtime(is_open ? "{}_{{{}}}" : "\\left( {} \\right)_{{{}}}"), left,
                     index);
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
    append(all, number_displays(left, equation.entries[i], shape));
  }
  return all;
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
    return number_displays(equation.left, equation.entries.front(), shape);
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

std::string latex_block(const Display& display) {
  const std::vector<std::string>& texts = display.texts;
  if (display.columns == 0) {
    if (texts.size() == 1) return fmt::format("{} = {}", display.left, texts.front());
    std::string text = fmt::format("\\begin{{aligned}}\n{} &= {}", display.left, texts.front());
    for (std::size_t i = 1; i < texts.size(); ++i) {
      text += fmt::format(" \\\\\n&\\quad {}", texts[i]);
    }
    return text + "\n\\end{aligned}";
  }
  std::string text = fmt::format("{} = \\begin{{pmatrix}}\n", display.left);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const bool ends_row = (i + 1) % display.columns == 0;
    const char* end = i + 1 == texts.size() ? "\n" : ends_row ? " \\\\\n" : " & ";
    text += texts[i] + end;
  }
  return text + "\\end{pmatrix}";
}

}  // namespace elgen
