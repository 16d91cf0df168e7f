// latex_text: scans that count braces and brackets.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "render/latex.hpp"

namespace elgen {
namespace {

constexpr std::string_view prose_command = "\\text";
constexpr std::string_view tall_command = "\\left";
constexpr std::string_view tall_end = "\\right";

/// 1 where a brace or bracket opens, -1 where one closes.
int bracket_step(char c) {
  if (c == '{' || c == '(' || c == '[') return 1;
  return c == '}' || c == ')' || c == ']' ? -1 : 0;
}

/// Where a factor in brackets begins, of which the bracket is at `open`: in front of its `\left`.
/// npos where the bracket holds the argument of a function.
std::size_t factor_begin(std::string_view latex, std::size_t open) {
  const bool is_tall = latex.substr(0, open).ends_with(tall_command);
  const std::size_t begin = is_tall ? open - tall_command.size() : open;
  return begin == 0 || latex[begin - 1] == ' ' ? begin : std::string_view::npos;
}

void add_formula(std::vector<LatexPiece>& all, std::string_view latex, bool is_last) {
  std::string text = without_outer_blanks(latex);
  const bool ends_with_comma = !is_last && text.ends_with(',');
  if (ends_with_comma) text.pop_back();
  if (!text.empty()) all.push_back({false, text});
  if (ends_with_comma) all.push_back({true, ", "});
}

}  // namespace

std::string without_outer_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(' ') + 1 - first));
}

std::size_t closing_brace(std::string_view latex, std::size_t open) {
  if (open >= latex.size() || latex[open] != '{') return std::string_view::npos;
  int depth = 0;
  for (std::size_t i = open; i < latex.size(); ++i) {
    depth += (latex[i] == '{') - (latex[i] == '}');
    if (depth == 0) return i;
  }
  return std::string_view::npos;
}

std::vector<FractionPlace> fractions(const std::string& latex) {
  constexpr std::string_view command = "\\frac";
  std::vector<FractionPlace> all;
  std::size_t end = 0;
  for (std::size_t open = latex.find('{'); open != std::string::npos; open = latex.find('{', end)) {
    const bool is_fraction = std::string_view(latex).substr(0, open).ends_with(command);
    const std::size_t above = closing_brace(latex, open);
    end = is_fraction && above != std::string::npos ? closing_brace(latex, above + 1) : above;
    if (end == std::string::npos) return all;
    if (!is_fraction) continue;
    all.push_back({open - command.size(), end + 1, latex.substr(open + 1, above - open - 1),
                   latex.substr(above + 2, end - above - 2)});
  }
  return all;
}

bool separates_terms(std::string_view rest) {
  constexpr std::array<std::string_view, 4> signs{" + ", " - ", " \\pm ", " \\mp "};
  return std::ranges::any_of(signs, [&](std::string_view sign) { return rest.starts_with(sign); });
}

bool is_sum(std::string_view latex) {
  if (latex.starts_with('-')) return true;
  int depth = 0;
  for (std::size_t i = 0; i < latex.size(); ++i) {
    depth += bracket_step(latex[i]);
    if (depth == 0 && separates_terms(latex.substr(i))) return true;
  }
  return false;
}

std::size_t last_bracket(std::string_view product) {
  if (!product.ends_with(')')) return 0;
  int depth = 0;
  for (std::size_t i = product.size(); i-- > 0;) {
    depth += (product[i] == ')') - (product[i] == '(');
    if (depth > 0) continue;
    const std::size_t begin = factor_begin(product, i);
    return begin == std::string_view::npos ? 0 : begin;
  }
  return 0;
}

std::vector<LatexPiece> pieces(const std::string& latex) {
  std::vector<LatexPiece> all;
  const std::string_view view = latex;
  std::size_t begin = 0;
  int depth = 0;
  for (std::size_t i = 0; i < latex.size(); ++i) {
    const std::string_view rest = view.substr(i);
    const std::size_t open = i + prose_command.size();
    const bool is_prose = depth == 0 && rest.starts_with(prose_command);
    const std::size_t close = is_prose ? closing_brace(latex, open) : std::string_view::npos;
    if (close == std::string_view::npos) {
      depth += (latex[i] == '{') - (latex[i] == '}');
      depth += rest.starts_with(tall_command) ? 1 : rest.starts_with(tall_end) ? -1 : 0;
      continue;
    }
    add_formula(all, view.substr(begin, i - begin), false);
    all.push_back({true, latex.substr(open + 1, close - open - 1)});
    begin = close + 1;
    i = close;
  }
  add_formula(all, view.substr(begin), true);
  return all;
}

std::string without_bold(std::string latex) {
  for (const std::string_view command : {"\\mathbf", "\\boldsymbol"}) {
    for (std::size_t at = latex.find(command); at != std::string::npos; at = latex.find(command)) {
      const std::size_t open = at + command.size();
      const std::size_t close = closing_brace(latex, open);
      if (close == std::string::npos) break;
      const std::string inside = latex.substr(open + 1, close - open - 1);
      const bool is_letter = inside.size() == 1 || inside.starts_with('\\');
      latex.replace(at, close + 1 - at, is_letter ? inside : fmt::format("\\mathrm{{{}}}", inside));
    }
  }
  return latex;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
    text.replace(at, from.size(), to);
    at += to.size();
  }
  return text;
}

}  // namespace elgen
