// latex_lines: formula -> lines, broken before + and - outside of braces.
//
//     a + \left( \frac{b}{c} + d \right) e   ->   a + \left( \frac{b}{c} \right.
//                                                 \left. {} + d \right) e
#include <algorithm>

#include "render/latex_tree.hpp"

namespace elgen {
namespace {

/// What stands between two places where the formula may be broken.
struct Segment {
  std::string text = {};
  int brackets = 0;  ///< open in front of it
  int tall = 0;      ///< those of them that are `\left`
  double width = 0;
};

bool stands_at(std::string_view text, std::size_t at, std::string_view word) {
  return text.substr(at, word.size()) == word;
}

std::vector<Segment> segments(const std::string& latex, double (*measured)(const LatexTree&)) {
  std::vector<Segment> all(1);
  int braces = 0;
  int brackets = 0;
  int tall = 0;
  for (std::size_t i = 0; i < latex.size(); ++i) {
    const bool is_break = braces == 0 && (stands_at(latex, i, " + ") || stands_at(latex, i, " - "));
    if (is_break) all.push_back({"", brackets, tall});
    tall += stands_at(latex, i, "\\left") ? 1 : stands_at(latex, i, "\\right") ? -1 : 0;
    braces += (latex[i] == '{') - (latex[i] == '}');
    brackets += (latex[i] == '(') - (latex[i] == ')');
    if (!is_break) all.back().text += latex[i];
  }
  const auto width_of = [measured](const std::string& text) { return measured(read_latex(text)); };
  const double before = width_of("x");
  all.front().width = width_of(all.front().text);
  for (std::size_t i = 1; i < all.size(); ++i) {
    all[i].width = width_of("x " + all[i].text) - before;  // its sign stands between terms
  }
  return all;
}

/// The segment the next line begins with, where the line begins with `first`.
std::size_t next_break(const std::vector<Segment>& all, std::size_t first, double widest) {
  double filled = all[first].width;
  std::size_t best = first + 1;
  for (std::size_t i = first + 1; i < all.size(); ++i) {
    const bool is_outer = all[i].brackets <= all[best].brackets;
    if (is_outer || filled < widest / 3) best = i;
    filled += all[i].width;
    if (filled > widest) return best;
  }
  return all.size();
}

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

}  // namespace

std::vector<std::string> latex_lines(const std::string& latex, double widest,
                                     double (*measured)(const LatexTree&)) {
  const std::vector<Segment> all = segments(latex, measured);
  std::vector<std::string> lines;
  for (std::size_t first = 0; first < all.size();) {
    const std::size_t end = next_break(all, first, widest);
    const int open = all[first].tall;
    std::string line = repeated("\\left. ", open) + (open > 0 ? "{} " : "");
    for (std::size_t i = first; i < end; ++i) {
      line += i > first ? " " + all[i].text : all[i].text;
    }
    if (end < all.size()) line += repeated(" \\right.", all[end].tall);
    lines.push_back(line);
    first = end;
  }
  return lines;
}

}  // namespace elgen
