// display: measured in letters, which is what a page of LaTeX, of GitHub and of HTML have in
// common.
#include "display.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "latex_tree.hpp"

namespace elgen::rendering {
namespace {

constexpr double between_columns = 2.5;
constexpr double indent = 4;
constexpr std::size_t largest_matrix = 10;  ///< columns of a pmatrix

double measured(const std::string& latex) { return width(read_latex(latex)); }

double matrix_width(const SheetEquation& equation) {
  std::vector<double> widths(equation.columns, 0);
  for (std::size_t i = 0; i < equation.entries.size(); ++i) {
    double& column = widths[i % equation.columns];
    column = std::max(column, measured(equation.entries[i]));
  }
  double sum = measured(equation.left) + 5;
  for (const double column : widths) sum += column + between_columns;
  return sum;
}

Display lines_display(const std::string& left, const std::string& right) {
  const double first = measured(left) + 3;
  return {left, 0, latex_lines(right, page_width - std::max(first, indent))};
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

std::vector<Display> entry_displays(const SheetEquation& equation) {
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
    all.push_back(lines_display(left, equation.entries[i]));
  }
  return all;
}

}  // namespace

std::vector<Display> displays(const SheetEquation& equation) {
  if (equation.entries.size() == 1) {
    return {lines_display(equation.left, equation.entries.front())};
  }
  const bool is_matrix = equation.columns <= largest_matrix && matrix_width(equation) <= page_width;
  if (is_matrix) return {{equation.left, equation.columns, equation.entries}};
  return entry_displays(equation);
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

}  // namespace elgen::rendering
