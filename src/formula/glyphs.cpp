// glyphs: operations on rows that all notations need, the widths of rows, and line breaks in long
// rows.
//
//     a + \left( \frac{b}{c} + d \right) e   ->   a + \left( \frac{b}{c} \right.
//                                                 \left. {} + d \right) e
#include "formula/glyphs.hpp"

#include <algorithm>
#include <utility>

namespace elgen {
namespace {

bool is_growing(const Glyphs& piece) {
  const GlyphKind kind = base_of(piece).kind;
  return kind == GlyphKind::left || kind == GlyphKind::right;
}

void add_formula_piece(std::vector<GlyphPiece>& all, Glyphs row, bool is_last) {
  const bool ends_with_comma = !is_last && !row.parts.empty() && row.parts.back().text == ",";
  if (ends_with_comma) row.parts.pop_back();
  if (!row.parts.empty()) {
    row.parts.front().has_space_before = false;
    all.push_back({false, "", std::move(row)});
  }
  if (ends_with_comma) all.push_back({true, ", ", {}});
}

double width_of_parts(const Glyphs& glyphs) {
  double sum = 0;
  for (const Glyphs& part : glyphs.parts) sum += width(part);
  return sum;
}

/// The pieces between two possible line breaks.
struct Segment {
  Glyphs row = {};
  int brackets = 0;  ///< number of open round brackets before the segment
  int growing = 0;   ///< number of open growing brackets before the segment
  double width = 0;
};

std::vector<Segment> split_segments(const Glyphs& row, double (*measured)(const Glyphs&)) {
  std::vector<Segment> all(1);
  int brackets = 0;
  int growing = 0;
  for (std::size_t i = 0; i < row.parts.size(); ++i) {
    const Glyphs& part = row.parts[i];
    const bool is_behind = i + 1 == row.parts.size() || row.parts[i + 1].has_space_before;
    const bool separates = is_term_sign(part) && part.has_space_before && is_behind;
    if (i > 0 && separates) all.push_back({{}, brackets, growing});
    const GlyphKind kind = base_of(part).kind;
    if (kind == GlyphKind::left || kind == GlyphKind::right) growing += bracket_depth_change(part);
    const std::string& text = base_of(part).text;
    brackets += text == "(" ? 1 : text == ")" ? -1 : 0;
    all.back().row.parts.push_back(part);
  }
  const Glyphs letter{GlyphKind::letter, "x"};
  const double before = measured({GlyphKind::row, "", {letter}});
  all.front().width = measured(all.front().row);
  for (std::size_t i = 1; i < all.size(); ++i) {
    // A sign after a letter separates terms, so it has wider spacing than a leading sign.
    Glyphs behind_letter{GlyphKind::row, "", {letter}};
    append(behind_letter, all[i].row, true);
    all[i].width = measured(behind_letter) - before;
  }
  return all;
}

/// The index behind the last segment of the line that begins with segment `first`.
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

std::string trim_blanks(std::string text) {
  text.erase(0, text.find_first_not_of(' '));
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

Glyphs make_row(Glyphs piece) { return {GlyphKind::row, "", {std::move(piece)}}; }

Glyphs fraction_row(Glyphs above, Glyphs below) {
  return make_row({GlyphKind::fraction, "", {std::move(above), std::move(below)}});
}

Glyphs enclose(Glyphs content, std::string_view open, std::string_view close, bool grows) {
  Glyphs row = make_row({grows ? GlyphKind::left : GlyphKind::bracket, std::string(open)});
  append(row, std::move(content), grows);
  append(row, {grows ? GlyphKind::right : GlyphKind::bracket, std::string(close)}, grows);
  return row;
}

const Glyphs& base_of(const Glyphs& piece) {
  return piece.kind == GlyphKind::scripts ? piece.parts[0] : piece;
}

bool is_present(const Glyphs& script) { return !script.parts.empty() || !script.text.empty(); }

void add_script(Glyphs& row, std::size_t place, Glyphs script) {
  if (row.parts.empty()) row.parts.emplace_back();
  Glyphs& base = row.parts.back();
  if (base.kind != GlyphKind::scripts) {
    Glyphs bare = std::move(base);
    const bool is_apart = std::exchange(bare.has_space_before, false);
    base = {GlyphKind::scripts, "", {}, is_apart};
    base.parts.resize(3);
    base.parts[0] = std::move(bare);
  }
  if (script.kind != GlyphKind::row) script = make_row(std::move(script));
  base.parts[place] = std::move(script);
}

void append(Glyphs& row, Glyphs pieces, bool has_space_before) {
  if (pieces.kind != GlyphKind::row) pieces = make_row(std::move(pieces));
  if (!pieces.parts.empty())
    pieces.parts.front().has_space_before = has_space_before && !row.parts.empty();
  for (Glyphs& piece : pieces.parts) row.parts.push_back(std::move(piece));
}

void append_sign(Glyphs& row, std::string_view sign, bool is_apart) {
  append(row, {GlyphKind::sign, std::string(sign)}, is_apart);
}

bool is_term_sign(const Glyphs& piece) {
  const std::string& text = base_of(piece).text;
  return text == "+" || text == "-" || text == "±" || text == "∓";
}

int bracket_depth_change(const Glyphs& piece) {
  const Glyphs& base = base_of(piece);
  if (base.kind == GlyphKind::left) return 1;
  if (base.kind == GlyphKind::right) return -1;
  if (base.kind != GlyphKind::bracket || base.text == "|") return 0;
  return base.text == "(" || base.text == "[" ? 1 : -1;
}

bool is_sum_or_signed(const Glyphs& row) {
  int depth = 0;
  for (std::size_t i = 0; i < row.parts.size(); ++i) {
    const bool is_first_minus = i == 0 && row.parts[i].text == "-";
    if (is_first_minus || (i > 0 && depth == 0 && is_term_sign(row.parts[i]))) return true;
    depth += bracket_depth_change(row.parts[i]);
  }
  return false;
}

std::vector<GlyphPiece> split_at_prose(const Glyphs& row) {
  std::vector<GlyphPiece> all;
  Glyphs formula;
  int depth = 0;
  for (const Glyphs& part : row.parts) {
    if (is_growing(part)) depth += bracket_depth_change(part);
    if (part.kind == GlyphKind::prose && depth == 0) {
      add_formula_piece(all, std::exchange(formula, {}), false);
      all.push_back({true, part.text, {}});
    } else {
      formula.parts.push_back(part);
    }
  }
  add_formula_piece(all, std::move(formula), true);
  return all;
}

Glyphs remove_bold(Glyphs glyphs) {
  if (glyphs.kind == GlyphKind::bold) {
    const bool is_letter =
        glyphs.text.size() == 1 || static_cast<unsigned char>(glyphs.text[0]) >= 0x80;
    glyphs.kind = is_letter ? GlyphKind::letter : GlyphKind::word;
  }
  for (Glyphs& part : glyphs.parts) part = remove_bold(std::move(part));
  return glyphs;
}

double width(const Glyphs& glyphs) {
  constexpr double smaller = 0.75;  // size of scripts relative to their base
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

GlyphRows break_lines(const Glyphs& row, double widest, double (*measured)(const Glyphs&)) {
  const std::vector<Segment> all = split_segments(row, measured);
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
