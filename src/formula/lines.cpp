// lines: the widths of rows, and long rows broken into lines.
//
//     a + \left( \frac{b}{c} + d \right) e   ->   a + \left( \frac{b}{c} \right.
//                                                 \left. {} + d \right) e
#include <algorithm>
#include <utility>

#include "formula/glyphs.hpp"

namespace elgen {
namespace {

double width_of_parts(const Glyphs& glyphs) {
  double sum = 0;
  for (const Glyphs& part : glyphs.parts) sum += width(part);
  return sum;
}

/// The pieces between two places where a row may be broken.
struct Segment {
  Glyphs row = {};
  int brackets = 0;  ///< open in front of it
  int growing = 0;   ///< those of them that grow
  double width = 0;
};

std::vector<Segment> segments(const Glyphs& row, double (*measured)(const Glyphs&)) {
  std::vector<Segment> all(1);
  int brackets = 0;
  int growing = 0;
  for (std::size_t i = 0; i < row.parts.size(); ++i) {
    const Glyphs& part = row.parts[i];
    const bool is_behind = i + 1 == row.parts.size() || row.parts[i + 1].is_apart;
    const bool separates = is_term_sign(part) && part.is_apart && is_behind;
    if (i > 0 && separates) all.push_back({{}, brackets, growing});
    const GlyphKind kind = base_of(part).kind;
    if (kind == GlyphKind::left || kind == GlyphKind::right) growing += bracket_step(part);
    const std::string& text = base_of(part).text;
    brackets += text == "(" ? 1 : text == ")" ? -1 : 0;
    all.back().row.parts.push_back(part);
  }
  const Glyphs letter{GlyphKind::letter, "x"};
  const double before = measured({GlyphKind::row, "", {letter}});
  all.front().width = measured(all.front().row);
  for (std::size_t i = 1; i < all.size(); ++i) {
    Glyphs behind_letter{GlyphKind::row, "", {letter}};  // its sign stands between terms
    append(behind_letter, all[i].row, true);
    all[i].width = measured(behind_letter) - before;
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

}  // namespace

double width(const Glyphs& glyphs) {
  constexpr double smaller = 0.75;  // scripts, beside their base
  switch (glyphs.kind) {
    case GlyphKind::letter:
      return 1.1;
    case GlyphKind::number:
      return 0.95 * static_cast<double>(glyphs.text.size());
    case GlyphKind::word:
    case GlyphKind::command:
    case GlyphKind::bold:
    case GlyphKind::prose:
    case GlyphKind::function:
      return 0.9 * static_cast<double>(glyphs.text.size()) + 0.6;
    case GlyphKind::sign:
      return glyphs.text == "," ? 0.9 : 2.4;
    case GlyphKind::bracket:
      return 0.8;
    case GlyphKind::left:
    case GlyphKind::right:
      return 1.4;
    case GlyphKind::space:
      return 0.4;
    case GlyphKind::fraction:
      return 0.6 + std::max(width(glyphs.parts[0]), width(glyphs.parts[1]));
    case GlyphKind::root:
      return 1.8 + width(glyphs.parts[0]);
    case GlyphKind::scripts:
      return width(glyphs.parts[0]) +
             smaller * std::max(width(glyphs.parts[1]), width(glyphs.parts[2]));
    case GlyphKind::row:
    case GlyphKind::accent:
      return width_of_parts(glyphs);
  }
  return 0;
}

GlyphRows broken_lines(const Glyphs& row, double widest, double (*measured)(const Glyphs&)) {
  const std::vector<Segment> all = segments(row, measured);
  GlyphRows lines;
  for (std::size_t first = 0; first < all.size();) {
    const std::size_t end = next_break(all, first, widest);
    Glyphs& line = lines.emplace_back();
    for (int i = 0; i < all[first].growing; ++i) append(line, {GlyphKind::left, ""}, true);
    if (all[first].growing > 0) append(line, {GlyphKind::row, "", {Glyphs{}}}, true);
    for (std::size_t i = first; i < end; ++i) append(line, all[i].row, true);
    for (int i = 0; end < all.size() && i < all[end].growing; ++i) {
      append(line, {GlyphKind::right, ""}, true);
    }
    first = end;
  }
  return lines;
}

}  // namespace elgen
