// drawing: draws rows piece by piece. Brackets are as tall as their content.
#include "formula/drawing.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "formula/glyphs.hpp"

namespace elgen {
namespace {

struct SmallGlyph {
  char32_t value;
  std::string_view below;  ///< the subscript; empty if Unicode has none
  std::string_view above;  ///< the superscript; empty if Unicode has none
};

constexpr std::array small_glyphs{
    SmallGlyph{'0', "₀", "⁰"}, SmallGlyph{'1', "₁", "¹"}, SmallGlyph{'2', "₂", "²"},
    SmallGlyph{'3', "₃", "³"}, SmallGlyph{'4', "₄", "⁴"}, SmallGlyph{'5', "₅", "⁵"},
    SmallGlyph{'6', "₆", "⁶"}, SmallGlyph{'7', "₇", "⁷"}, SmallGlyph{'8', "₈", "⁸"},
    SmallGlyph{'9', "₉", "⁹"}, SmallGlyph{',', ",", ","}, SmallGlyph{'+', "₊", "⁺"},
    SmallGlyph{'-', "₋", "⁻"}, SmallGlyph{'a', "ₐ", "ᵃ"}, SmallGlyph{'e', "ₑ", "ᵉ"},
    SmallGlyph{'h', "ₕ", "ʰ"}, SmallGlyph{'i', "ᵢ", "ⁱ"}, SmallGlyph{'j', "ⱼ", "ʲ"},
    SmallGlyph{'k', "ₖ", "ᵏ"}, SmallGlyph{'l', "ₗ", "ˡ"}, SmallGlyph{'m', "ₘ", "ᵐ"},
    SmallGlyph{'n', "ₙ", "ⁿ"}, SmallGlyph{'o', "ₒ", "ᵒ"}, SmallGlyph{'p', "ₚ", "ᵖ"},
    SmallGlyph{'r', "ᵣ", "ʳ"}, SmallGlyph{'s', "ₛ", "ˢ"}, SmallGlyph{'t', "ₜ", "ᵗ"},
    SmallGlyph{'u', "ᵤ", "ᵘ"}, SmallGlyph{'v', "ᵥ", "ᵛ"}, SmallGlyph{'x', "ₓ", "ˣ"},
    SmallGlyph{U'⊤', "", "ᵀ"}};

/// Replaces every character by its small form; none if a character has no small form.
std::optional<std::string> to_small_glyphs(std::string_view text,
                                           std::string_view SmallGlyph::*place) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint point = code_point_at(text, at);
    const auto row = std::ranges::find(small_glyphs, point.value, &SmallGlyph::value);
    if (row == small_glyphs.end() || ((*row).*place).empty()) return std::nullopt;
    result += (*row).*place;
    at += std::max<std::size_t>(1, point.bytes);
  }
  return result;
}

struct VulgarFraction {
  std::string_view above;
  std::string_view below;
  std::string_view glyph;
};

constexpr std::array vulgar_fractions{
    VulgarFraction{"1", "2", "½"}, VulgarFraction{"1", "3", "⅓"}, VulgarFraction{"2", "3", "⅔"},
    VulgarFraction{"1", "4", "¼"}, VulgarFraction{"3", "4", "¾"}, VulgarFraction{"1", "5", "⅕"},
    VulgarFraction{"1", "6", "⅙"}, VulgarFraction{"1", "8", "⅛"}, VulgarFraction{"3", "8", "⅜"},
    VulgarFraction{"5", "8", "⅝"}, VulgarFraction{"7", "8", "⅞"}};

struct AsciiWord {
  std::string_view character;
  std::string_view word;
};

/// The ASCII words for characters other than Greek letters.
constexpr std::array ascii_words{AsciiWord{"⋅", "*"},  AsciiWord{"∂", "d"},   AsciiWord{"∑", "sum"},
                                 AsciiWord{"⊤", "T"},  AsciiWord{"′", "'"},   AsciiWord{"±", "+-"},
                                 AsciiWord{"∓", "-+"}, AsciiWord{"∫", "int"}, AsciiWord{"ℓ", "ell"},
                                 AsciiWord{"×", "x"}};

TextBlock make_line(std::string text) { return {{std::move(text)}, 0}; }

/// The role of a piece. The roles of two neighbours decide whether a blank separates them.
enum class PieceRole : std::uint8_t { none, operand, function, sign, comma, prefix, prose };

/// True for an opening bracket that is printed, as in `(1, 2)`; false for scripts and for `\left.`.
bool is_open_bracket(const Glyphs& part) {
  return part.kind != GlyphKind::scripts && bracket_depth_change(part) > 0 && !part.text.empty();
}

/// True for a group {\delta}: its delta marks a variation and is not a factor.
bool is_variation(const Glyphs& part) {
  return part.kind == GlyphKind::row && part.parts.size() == 1 && part.parts[0].text == "δ";
}

/// True for a word such as \mathrm{elbow}: a dot over one of its letters would be misread.
bool is_word(const Glyphs& glyphs) {
  if (glyphs.kind == GlyphKind::row && glyphs.parts.size() == 1) return is_word(glyphs.parts[0]);
  return glyphs.kind == GlyphKind::word && terminal_width(glyphs.text) > 1;
}

bool is_closing_bracket(const Glyphs& part) {
  return bracket_depth_change(part) < 0 && !base_of(part).text.empty();
}

std::string letter_text(const std::string& text, bool is_unicode) {
  if (is_unicode) return text;
  const auto row = std::ranges::find(ascii_words, text, &AsciiWord::character);
  if (row != ascii_words.end()) return std::string(row->word);
  const std::string_view name = greek_command(text);
  return name.empty() ? text : std::string(name);
}

PieceRole role_of(const Glyphs& part) {
  const Glyphs& base = base_of(part);
  if (base.kind == GlyphKind::function) return PieceRole::function;
  if (base.kind == GlyphKind::prose) return PieceRole::prose;
  if (base.text == "∂" || base.text == "±" || is_variation(base)) return PieceRole::prefix;
  if (base.kind != GlyphKind::sign || base.text == "∫") return PieceRole::operand;
  return base.text == "," ? PieceRole::comma : PieceRole::sign;
}

/// The position of the bracket that closes the bracket at `open`; parts.size() if there is none.
std::size_t find_closing_bracket(const std::vector<Glyphs>& parts, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < parts.size(); ++i) {
    depth += is_open_bracket(parts[i]) ? 1 : is_closing_bracket(parts[i]) ? -1 : 0;
    if (depth == 0) return i;
  }
  return parts.size();
}

/// True if a row has a sign, such as + or =, outside brackets.
bool has_outer_sign(const Glyphs& glyphs) {
  for (std::size_t i = 0; i < glyphs.parts.size(); ++i) {
    if (role_of(glyphs.parts[i]) == PieceRole::sign) return true;
    if (is_open_bracket(glyphs.parts[i])) i = find_closing_bracket(glyphs.parts, i);
  }
  return false;
}

/// True if a row has several factors. dt and ∂q are single factors.
bool is_product(const Glyphs& glyphs) {
  std::size_t factors = 0;
  for (const Glyphs& part : glyphs.parts) {
    const bool begins = factors == 0 || part.has_space_before;
    if (begins && role_of(part) != PieceRole::prefix) ++factors;
  }
  return factors > 1;
}

bool has_fraction(const Glyphs& row) {
  return std::ranges::find(row.parts, GlyphKind::fraction, &Glyphs::kind) != row.parts.end();
}

/// The text between two pieces: empty or a blank.
std::string blank_between(PieceRole left, const Glyphs& part) {
  if (base_of(part).text == "′") return "";
  if (part.kind == GlyphKind::prose && part.text.find_first_of(";:,") == 0) return "";
  const PieceRole right = role_of(part);
  const bool is_bracket = is_open_bracket(part);
  if (left == PieceRole::none || left == PieceRole::prefix || right == PieceRole::comma) return "";
  if (left == PieceRole::comma && !part.has_space_before) return "";
  if (left == PieceRole::operand && right == PieceRole::operand && !part.has_space_before)
    return "";
  const bool is_argument = is_bracket && (left == PieceRole::function || !part.has_space_before);
  return is_argument && left != PieceRole::sign && left != PieceRole::comma ? "" : " ";
}

/// True if dots are written as calls, as in the model language: dot(theta1).
bool writes_accent_as_call(const Glyphs& glyphs, bool is_unicode) {
  return glyphs.kind == GlyphKind::accent && (!is_unicode || is_word(glyphs.parts[0]));
}

/// Puts the dots over the first letter of `base`, or writes dot(base) or ddot(base).
std::string add_dots(const Glyphs& glyphs, const std::string& base, bool is_unicode) {
  if (base.empty()) return base;
  const bool is_double = glyphs.text == "¨";
  if (writes_accent_as_call(glyphs, is_unicode))
    return is_double ? "ddot(" + base + ")" : "dot(" + base + ")";
  const std::size_t first = std::max<std::size_t>(1, code_point_at(base, 0).bytes);
  return base.substr(0, first) + (is_double ? "\u0308" : "\u0307") + base.substr(first);
}

bool is_number(const std::string& text) {
  return std::ranges::all_of(text, [](char c) { return is_digit(c); });
}

/// A quotient of two numbers on one line: "½"; "7/9" if no character shows the quotient.
std::string numeric_fraction_text(const std::string& above, const std::string& below,
                                  bool is_unicode) {
  for (const VulgarFraction& vulgar : vulgar_fractions) {
    const bool is_this = vulgar.above == above && vulgar.below == below;
    if (is_unicode && is_this) return std::string(vulgar.glyph);
  }
  return above + "/" + below;
}

/// An index on one line: "₁₂" from "1, 2"; "_cart"; "_left_hip" from "left, hip", as in names.
std::string subscript_text(std::string text, bool is_unicode) {
  std::erase(text, ' ');
  std::string without_commas = text;
  std::erase(without_commas, ',');
  const bool is_digits = is_number(without_commas);
  const bool is_short = without_commas.size() * 2 == text.size() + 1;
  if (is_digits && is_short) text = without_commas;
  const bool is_long = without_commas.size() < text.size() || terminal_width(text) > 4;
  const bool is_name = is_long && !is_digits;  // hard to read in small letters
  if (is_name) std::ranges::replace(text, ',', '_');
  const bool is_small = is_unicode && !is_name;
  const auto small = is_small ? to_small_glyphs(text, &SmallGlyph::below) : std::nullopt;
  if (small) return *small;
  return is_digits ? text : "_" + text;
}

std::string superscript_text(const std::string& text, bool is_unicode) {
  const auto small = is_unicode ? to_small_glyphs(text, &SmallGlyph::above) : std::nullopt;
  if (small) return *small;
  return terminal_width(text) == 1 ? "^" + text : "^(" + text + ")";
}

class GlyphRenderer {
 public:
  GlyphRenderer(Alphabet alphabet, FractionStyle fractions)
      : alphabet_(alphabet), fractions_(fractions) {}

  /// Draws a block of at least one line.
  [[nodiscard]] TextBlock draw(const Glyphs& glyphs) const {
    TextBlock block = draw_piece(glyphs);
    return block.lines.empty() ? make_line("") : block;
  }

 private:
  [[nodiscard]] TextBlock draw_piece(const Glyphs& glyphs) const {
    switch (glyphs.kind) {
      case GlyphKind::row:
        return draw_row(glyphs.parts);
      case GlyphKind::fraction:
        return draw_fraction(glyphs);
      case GlyphKind::root:
        return draw_root(glyphs);
      case GlyphKind::accent:
        return make_line(add_dots(glyphs, base_line_text(glyphs.parts[0]), is_unicode()));
      case GlyphKind::scripts:
        return draw_scripts(glyphs);
      case GlyphKind::space:
        return make_line("");
      case GlyphKind::prose:  // draw_row() sets the blanks between pieces
        return make_line(trim_blanks(glyphs.text));
      default:
        return make_line(letter_text(glyphs.text, is_unicode()));
    }
  }

  [[nodiscard]] bool is_unicode() const { return alphabet_ == Alphabet::unicode; }

  [[nodiscard]] std::string base_line_text(const Glyphs& glyphs) const {
    const TextBlock block = draw(glyphs);
    return block.lines[block.base];
  }

  [[nodiscard]] TextBlock draw_fraction(const Glyphs& glyphs) const {
    const TextBlock above = draw(glyphs.parts[0]);
    const TextBlock below = draw(glyphs.parts[1]);
    const std::string& top = above.lines.front();
    const std::string& bottom = below.lines.front();
    if (above.lines.size() + below.lines.size() == 2 && is_number(top) && is_number(bottom)) {
      return make_line(numeric_fraction_text(top, bottom, is_unicode()));
    }
    if (fractions_ == FractionStyle::in_line) {
      const bool is_sum = has_outer_sign(glyphs.parts[0]);
      const Glyphs& divisor = glyphs.parts[1];
      const bool has_factors =
          is_product(divisor) || has_fraction(divisor) || has_outer_sign(divisor);
      return join_blocks(
          join_blocks(is_sum ? draw_in_brackets("(", above, ")") : above, make_line("/")),
          has_factors ? draw_in_brackets("(", below, ")") : below);
    }
    return stack_blocks(above, below, is_unicode() ? "─" : "-");
  }

  [[nodiscard]] TextBlock draw_root(const Glyphs& glyphs) const {
    const TextBlock inside = draw(glyphs.parts[0]);
    return join_blocks(make_line(is_unicode() ? "√" : "sqrt"), draw_in_brackets("(", inside, ")"));
  }

  [[nodiscard]] TextBlock draw_in_brackets(std::string_view open, const TextBlock& inside,
                                           std::string_view close) const {
    const TextBlock left = draw_bracket(open, inside, alphabet_);
    return join_blocks(join_blocks(left, inside), draw_bracket(close, inside, alphabet_));
  }

  [[nodiscard]] std::string draw_subscript(const Glyphs& script) const {
    return is_present(script) ? subscript_text(base_line_text(script), is_unicode()) : "";
  }

  [[nodiscard]] std::string draw_superscript(const Glyphs& script) const {
    return is_present(script) ? superscript_text(base_line_text(script), is_unicode()) : "";
  }

  /// Draws scripts. If a dot is written as a call, the call contains the index: dot(theta1_2).
  [[nodiscard]] TextBlock draw_scripts(const Glyphs& glyphs) const {
    const Glyphs& base = glyphs.parts[0];
    if (base.kind == GlyphKind::fraction && fractions_ == FractionStyle::in_line) {
      return attach_scripts(draw_in_brackets("(", draw(base), ")"), glyphs);
    }
    if (!writes_accent_as_call(base, is_unicode())) return attach_scripts(draw(base), glyphs);
    Glyphs exponent_alone = glyphs;
    exponent_alone.parts[1] = {};
    const std::string inside = base_line_text(base.parts[0]) + draw_subscript(glyphs.parts[1]);
    return attach_scripts(make_line(add_dots(base, inside, is_unicode())), exponent_alone);
  }

  /// Puts an index on the base line, and an exponent at the top of a tall base.
  [[nodiscard]] TextBlock attach_scripts(const TextBlock& base, const Glyphs& glyphs) const {
    TextBlock scripts = make_line(draw_subscript(glyphs.parts[1]));
    const std::string above = draw_superscript(glyphs.parts[2]);
    if (base.lines.size() == 1 || above.empty()) {
      scripts.lines.front() += above;
      return join_blocks(base, scripts);
    }
    TextBlock result = join_blocks(base, make_line(std::string(terminal_width(above), ' ')));
    std::string& top = result.lines.front();
    top = top.substr(0, top.size() - terminal_width(above)) + above;
    return join_blocks(result, scripts);
  }

  [[nodiscard]] TextBlock draw_row(const std::vector<Glyphs>& parts) const {
    TextBlock result;
    PieceRole last = PieceRole::none;
    bool is_in_bars = false;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const PieceRole role = role_of(parts[i]);
      if (base_of(parts[i]).kind == GlyphKind::space) {
        const bool is_quad = base_of(parts[i]).text == "1";
        if (is_quad && last != PieceRole::none) result = join_blocks(result, make_line("  "));
        continue;
      }
      const bool is_unary = is_term_sign(parts[i]) && role == PieceRole::sign &&
                            (last == PieceRole::none || last == PieceRole::comma ||
                             last == PieceRole::sign || last == PieceRole::prose);
      const bool is_bar = parts[i].kind == GlyphKind::bracket && parts[i].text == "|";
      const bool is_closing_bar = is_bar && std::exchange(is_in_bars, is_bar != is_in_bars);
      const bool is_open_argument = fractions_ == FractionStyle::in_line &&
                                    last == PieceRole::function &&
                                    parts[i].kind == GlyphKind::fraction;
      if (!is_closing_bar && !is_open_argument) {
        result = join_blocks(result, make_line(blank_between(last, parts[i])));
      }
      const std::size_t close =
          is_open_bracket(parts[i]) ? find_closing_bracket(parts, i) : parts.size();
      if (close < parts.size()) {
        result = join_blocks(result, draw_bracketed_range(parts, i, close));
        i = close;
      } else {
        const TextBlock drawn = draw(parts[i]);
        if (needs_blank(result, drawn)) result = join_blocks(result, make_line(" "));
        result = join_blocks(result, is_open_argument ? draw_in_brackets("(", drawn, ")") : drawn);
      }
      const bool is_opening_bar = is_bar && !is_closing_bar;
      last = is_unary || is_opening_bar || is_open_bracket(parts[i]) ? PieceRole::none : role;
    }
    return result;
  }

  /// True if two words would be read as one if no blank separated them: delta q.
  [[nodiscard]] bool needs_blank(const TextBlock& left, const TextBlock& right) const {
    if (is_unicode() || left.width() < 2 || right.width() == 0) return false;
    const std::string& line = left.lines[left.base];
    const bool is_word = is_letter(line.back()) && is_letter(line[line.size() - 2]);
    return is_word && is_letter(right.lines[right.base].front());
  }

  [[nodiscard]] TextBlock draw_bracketed_range(const std::vector<Glyphs>& parts, std::size_t open,
                                               std::size_t close) const {
    const auto begin = parts.begin();
    const std::vector<Glyphs> inside(begin + static_cast<std::ptrdiff_t>(open) + 1,
                                     begin + static_cast<std::ptrdiff_t>(close));
    const TextBlock drawn =
        draw_in_brackets(parts[open].text, draw_row(inside), base_of(parts[close]).text);
    return parts[close].kind == GlyphKind::scripts ? attach_scripts(drawn, parts[close]) : drawn;
  }

  Alphabet alphabet_;
  FractionStyle fractions_;
};

}  // namespace

TextBlock draw_glyphs(const Glyphs& glyphs, Alphabet alphabet, FractionStyle fractions) {
  return GlyphRenderer(alphabet, fractions).draw(glyphs);
}

std::string small_exponent(const std::string& exponent) {
  return to_small_glyphs(exponent, &SmallGlyph::above).value_or("^(" + exponent + ")");
}

}  // namespace elgen
