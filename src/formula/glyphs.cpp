// glyphs: operations on rows that all notations need.
#include "formula/glyphs.hpp"

#include <algorithm>
#include <utility>

namespace elgen {
namespace {

bool is_growing(const Glyphs& piece) {
  const GlyphKind kind = base_of(piece).kind;
  return kind == GlyphKind::left || kind == GlyphKind::right;
}

void add_formula(std::vector<GlyphPiece>& all, Glyphs row, bool is_last) {
  const bool ends_with_comma = !is_last && !row.parts.empty() && row.parts.back().text == ",";
  if (ends_with_comma) row.parts.pop_back();
  if (!row.parts.empty()) {
    row.parts.front().is_apart = false;
    all.push_back({false, "", std::move(row)});
  }
  if (ends_with_comma) all.push_back({true, ", ", {}});
}

}  // namespace

std::string without_outer_blanks(std::string text) {
  text.erase(0, text.find_first_not_of(' '));
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

Glyphs row_with(Glyphs piece) { return {GlyphKind::row, "", {std::move(piece)}}; }

Glyphs fraction_row(Glyphs above, Glyphs below) {
  return row_with({GlyphKind::fraction, "", {std::move(above), std::move(below)}});
}

Glyphs enclosed(Glyphs content, std::string_view open, std::string_view close, bool grows) {
  Glyphs row = row_with({grows ? GlyphKind::left : GlyphKind::bracket, std::string(open)});
  append(row, std::move(content), grows);
  append(row, {grows ? GlyphKind::right : GlyphKind::bracket, std::string(close)}, grows);
  return row;
}

const Glyphs& base_of(const Glyphs& piece) {
  return piece.kind == GlyphKind::scripts ? piece.parts[0] : piece;
}

void add_script(Glyphs& row, std::size_t place, Glyphs script) {
  if (row.parts.empty()) row.parts.emplace_back();
  Glyphs& base = row.parts.back();
  if (base.kind != GlyphKind::scripts) {
    Glyphs bare = std::move(base);
    const bool is_apart = std::exchange(bare.is_apart, false);
    base = {GlyphKind::scripts, "", {}, is_apart};
    base.parts.resize(3);
    base.parts[0] = std::move(bare);
  }
  if (script.kind != GlyphKind::row) script = row_with(std::move(script));
  base.parts[place] = std::move(script);
}

void append(Glyphs& row, Glyphs pieces, bool is_apart) {
  if (pieces.kind != GlyphKind::row) pieces = row_with(std::move(pieces));
  if (!pieces.parts.empty()) pieces.parts.front().is_apart = is_apart && !row.parts.empty();
  for (Glyphs& piece : pieces.parts) row.parts.push_back(std::move(piece));
}

void append_sign(Glyphs& row, std::string_view sign, bool is_apart) {
  append(row, {GlyphKind::sign, std::string(sign)}, is_apart);
}

bool is_term_sign(const Glyphs& piece) {
  const std::string& text = base_of(piece).text;
  return text == "+" || text == "-" || text == "±" || text == "∓";
}

int bracket_step(const Glyphs& piece) {
  const Glyphs& base = base_of(piece);
  if (base.kind == GlyphKind::left) return 1;
  if (base.kind == GlyphKind::right) return -1;
  if (base.kind != GlyphKind::bracket || base.text == "|") return 0;
  return base.text == "(" || base.text == "[" ? 1 : -1;
}

bool is_sum(const Glyphs& row) {
  int depth = 0;
  for (std::size_t i = 0; i < row.parts.size(); ++i) {
    const bool is_first_minus = i == 0 && row.parts[i].text == "-";
    if (is_first_minus || (i > 0 && depth == 0 && is_term_sign(row.parts[i]))) return true;
    depth += bracket_step(row.parts[i]);
  }
  return false;
}

std::vector<GlyphPiece> pieces(const Glyphs& row) {
  std::vector<GlyphPiece> all;
  Glyphs formula;
  int depth = 0;
  for (const Glyphs& part : row.parts) {
    if (is_growing(part)) depth += bracket_step(part);
    if (part.kind == GlyphKind::prose && depth == 0) {
      add_formula(all, std::exchange(formula, {}), false);
      all.push_back({true, part.text, {}});
    } else {
      formula.parts.push_back(part);
    }
  }
  add_formula(all, std::move(formula), true);
  return all;
}

Glyphs without_bold(Glyphs glyphs) {
  if (glyphs.kind == GlyphKind::bold) {
    const bool is_letter =
        glyphs.text.size() == 1 || static_cast<unsigned char>(glyphs.text[0]) >= 0x80;
    glyphs.kind = is_letter ? GlyphKind::letter : GlyphKind::word;
  }
  for (Glyphs& part : glyphs.parts) part = without_bold(std::move(part));
  return glyphs;
}

}  // namespace elgen
