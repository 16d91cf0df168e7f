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

Block line_of(std::string text) { return {{std::move(text)}, 0}; }

/// The role of a piece. The roles of two neighbours decide whether a blank separates them.
enum class Role : std::uint8_t { none, operand, function, sign, comma, prefix, prose };

/// True for an opening bracket that is printed, as in `(1, 2)`; false for scripts and for `\left.`.
bool is_open_bracket(const Glyphs& part) {
  return part.kind != GlyphKind::scripts && bracket_step(part) > 0 && !part.text.empty();
}

/// True for a group {\delta}: its delta marks a variation and is not a factor.
bool is_variation(const Glyphs& part) {
  return part.kind == GlyphKind::row && part.parts.size() == 1 && part.parts[0].text == "δ";
}

/// True for a word such as \mathrm{elbow}: a dot over one of its letters would be misread.
bool is_word(const Glyphs& glyphs) {
  if (glyphs.kind == GlyphKind::row && glyphs.parts.size() == 1) return is_word(glyphs.parts[0]);
  return glyphs.kind == GlyphKind::word && columns_of(glyphs.text) > 1;
}

bool is_closing_bracket(const Glyphs& part) {
  return bracket_step(part) < 0 && !base_of(part).text.empty();
}

std::string letter(const std::string& text, bool is_unicode) {
  if (is_unicode) return text;
  const auto row = std::ranges::find(ascii_words, text, &AsciiWord::character);
  if (row != ascii_words.end()) return std::string(row->word);
  const std::string_view name = greek_command(text);
  return name.empty() ? text : std::string(name);
}

Role role_of(const Glyphs& part) {
  const Glyphs& base = base_of(part);
  if (base.kind == GlyphKind::function) return Role::function;
  if (base.kind == GlyphKind::prose) return Role::prose;
  if (base.text == "∂" || base.text == "±" || is_variation(base)) return Role::prefix;
  if (base.kind != GlyphKind::sign || base.text == "∫") return Role::operand;
  return base.text == "," ? Role::comma : Role::sign;
}

/// The position of the bracket that closes the bracket at `open`; the end of the row if none does.
std::size_t closing_position(const std::vector<Glyphs>& parts, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < parts.size(); ++i) {
    depth += is_open_bracket(parts[i]) ? 1 : is_closing_bracket(parts[i]) ? -1 : 0;
    if (depth == 0) return i;
  }
  return parts.size();
}

/// True if a row is a sum. Signs inside brackets do not count.
bool has_sign(const Glyphs& glyphs) {
  for (std::size_t i = 0; i < glyphs.parts.size(); ++i) {
    if (role_of(glyphs.parts[i]) == Role::sign) return true;
    if (is_open_bracket(glyphs.parts[i])) i = closing_position(glyphs.parts, i);
  }
  return false;
}

/// True if a row has several factors. dt and ∂q are single factors.
bool is_product(const Glyphs& glyphs) {
  std::size_t factors = 0;
  for (const Glyphs& part : glyphs.parts) {
    const bool begins = factors == 0 || part.has_space_before;
    if (begins && role_of(part) != Role::prefix) ++factors;
  }
  return factors > 1;
}

bool has_fraction(const Glyphs& row) {
  return std::ranges::find(row.parts, GlyphKind::fraction, &Glyphs::kind) != row.parts.end();
}

/// The text between two pieces: empty or a blank.
std::string blank_between(Role left, const Glyphs& part) {
  if (base_of(part).text == "′") return "";
  if (part.kind == GlyphKind::prose && part.text.find_first_of(";:,") == 0) return "";
  const Role right = role_of(part);
  const bool is_bracket = is_open_bracket(part);
  if (left == Role::none || left == Role::prefix || right == Role::comma) return "";
  if (left == Role::comma && !part.has_space_before) return "";
  if (left == Role::operand && right == Role::operand && !part.has_space_before) return "";
  const bool is_argument = is_bracket && (left == Role::function || !part.has_space_before);
  return is_argument && left != Role::sign && left != Role::comma ? "" : " ";
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

/// A quotient of two numbers on one line: "½", or "7/9" if there is no character for it.
std::string number_fraction(const std::string& above, const std::string& below, bool is_unicode) {
  for (const VulgarFraction& vulgar : vulgar_fractions) {
    const bool is_this = vulgar.above == above && vulgar.below == below;
    if (is_unicode && is_this) return std::string(vulgar.glyph);
  }
  return above + "/" + below;
}

/// An index on one line: "₁₂" from "1, 2"; "_cart"; "_left_hip" from "left, hip", as in names.
std::string index_of(std::string text, bool is_unicode) {
  std::erase(text, ' ');
  std::string without_commas = text;
  std::erase(without_commas, ',');
  const bool is_digits = is_number(without_commas);
  const bool is_short = without_commas.size() * 2 == text.size() + 1;
  if (is_digits && is_short) text = without_commas;
  const bool is_long = without_commas.size() < text.size() || columns_of(text) > 4;
  const bool is_name = is_long && !is_digits;  // hard to read in small letters
  if (is_name) std::ranges::replace(text, ',', '_');
  const bool is_small = is_unicode && !is_name;
  const auto small = is_small ? to_small_glyphs(text, &SmallGlyph::below) : std::nullopt;
  if (small) return *small;
  return is_digits ? text : "_" + text;
}

std::string exponent_of(const std::string& text, bool is_unicode) {
  const auto small = is_unicode ? to_small_glyphs(text, &SmallGlyph::above) : std::nullopt;
  if (small) return *small;
  return columns_of(text) == 1 ? "^" + text : "^(" + text + ")";
}

class Drawer {
 public:
  Drawer(Alphabet alphabet, Fractions fractions) : alphabet_(alphabet), fractions_(fractions) {}

  /// Draws a block of at least one line.
  [[nodiscard]] Block draw(const Glyphs& glyphs) const {
    Block block = drawn(glyphs);
    return block.lines.empty() ? line_of("") : block;
  }

 private:
  [[nodiscard]] Block drawn(const Glyphs& glyphs) const {
    switch (glyphs.kind) {
      case GlyphKind::row:
        return row(glyphs.parts);
      case GlyphKind::fraction:
        return fraction(glyphs);
      case GlyphKind::root:
        return root(glyphs);
      case GlyphKind::accent:
        return line_of(add_dots(glyphs, text_of_line(glyphs.parts[0]), is_unicode()));
      case GlyphKind::scripts:
        return scripts(glyphs);
      case GlyphKind::space:
        return line_of("");
      case GlyphKind::prose:  // row() sets the blanks between pieces
        return line_of(without_outer_blanks(glyphs.text));
      default:
        return line_of(letter(glyphs.text, is_unicode()));
    }
  }

  [[nodiscard]] bool is_unicode() const { return alphabet_ == Alphabet::unicode; }

  [[nodiscard]] std::string text_of_line(const Glyphs& glyphs) const {
    const Block block = draw(glyphs);
    return block.lines[block.base];
  }

  [[nodiscard]] Block fraction(const Glyphs& glyphs) const {
    const Block above = draw(glyphs.parts[0]);
    const Block below = draw(glyphs.parts[1]);
    const std::string& top = above.lines.front();
    const std::string& bottom = below.lines.front();
    if (above.lines.size() + below.lines.size() == 2 && is_number(top) && is_number(bottom)) {
      return line_of(number_fraction(top, bottom, is_unicode()));
    }
    if (fractions_ == Fractions::in_line) {
      const bool is_sum = has_sign(glyphs.parts[0]);
      const Glyphs& divisor = glyphs.parts[1];
      const bool has_factors = is_product(divisor) || has_fraction(divisor) || has_sign(divisor);
      return join_blocks(join_blocks(is_sum ? in_brackets("(", above, ")") : above, line_of("/")),
                         has_factors ? in_brackets("(", below, ")") : below);
    }
    return stacked(above, below, is_unicode() ? "─" : "-");
  }

  [[nodiscard]] Block root(const Glyphs& glyphs) const {
    const Block inside = draw(glyphs.parts[0]);
    return join_blocks(line_of(is_unicode() ? "√" : "sqrt"), in_brackets("(", inside, ")"));
  }

  [[nodiscard]] Block in_brackets(std::string_view open, const Block& inside,
                                  std::string_view close) const {
    const Block left = bracket_drawing(open, inside, alphabet_);
    return join_blocks(join_blocks(left, inside), bracket_drawing(close, inside, alphabet_));
  }

  [[nodiscard]] std::string index(const Glyphs& script) const {
    return is_present(script) ? index_of(text_of_line(script), is_unicode()) : "";
  }

  [[nodiscard]] std::string exponent(const Glyphs& script) const {
    return is_present(script) ? exponent_of(text_of_line(script), is_unicode()) : "";
  }

  /// Draws scripts. If a dot is written as a call, the call contains the index: dot(theta1_2).
  [[nodiscard]] Block scripts(const Glyphs& glyphs) const {
    const Glyphs& base = glyphs.parts[0];
    if (base.kind == GlyphKind::fraction && fractions_ == Fractions::in_line) {
      return with_scripts(in_brackets("(", draw(base), ")"), glyphs);
    }
    if (!writes_accent_as_call(base, is_unicode())) return with_scripts(draw(base), glyphs);
    Glyphs exponent_alone = glyphs;
    exponent_alone.parts[1] = {};
    const std::string inside = text_of_line(base.parts[0]) + index(glyphs.parts[1]);
    return with_scripts(line_of(add_dots(base, inside, is_unicode())), exponent_alone);
  }

  /// Puts an index on the base line, and an exponent at the top of a tall base.
  [[nodiscard]] Block with_scripts(const Block& base, const Glyphs& glyphs) const {
    Block scripts = line_of(index(glyphs.parts[1]));
    const std::string above = exponent(glyphs.parts[2]);
    if (base.lines.size() == 1 || above.empty()) {
      scripts.lines.front() += above;
      return join_blocks(base, scripts);
    }
    Block result = join_blocks(base, line_of(std::string(columns_of(above), ' ')));
    std::string& top = result.lines.front();
    top = top.substr(0, top.size() - columns_of(above)) + above;
    return join_blocks(result, scripts);
  }

  [[nodiscard]] Block row(const std::vector<Glyphs>& parts) const {
    Block result;
    Role last = Role::none;
    bool is_in_bars = false;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Role role = role_of(parts[i]);
      if (base_of(parts[i]).kind == GlyphKind::space) {
        const bool is_quad = base_of(parts[i]).text == "1";
        if (is_quad && last != Role::none) result = join_blocks(result, line_of("  "));
        continue;
      }
      const bool is_unary =
          is_term_sign(parts[i]) && role == Role::sign &&
          (last == Role::none || last == Role::comma || last == Role::sign || last == Role::prose);
      const bool is_bar = parts[i].kind == GlyphKind::bracket && parts[i].text == "|";
      const bool is_closing_bar = is_bar && std::exchange(is_in_bars, is_bar != is_in_bars);
      const bool is_open_argument = fractions_ == Fractions::in_line && last == Role::function &&
                                    parts[i].kind == GlyphKind::fraction;
      if (!is_closing_bar && !is_open_argument) {
        result = join_blocks(result, line_of(blank_between(last, parts[i])));
      }
      const std::size_t close =
          is_open_bracket(parts[i]) ? closing_position(parts, i) : parts.size();
      if (close < parts.size()) {
        result = join_blocks(result, parse_brackets(parts, i, close));
        i = close;
      } else {
        const Block drawn = draw(parts[i]);
        if (needs_blank(result, drawn)) result = join_blocks(result, line_of(" "));
        result = join_blocks(result, is_open_argument ? in_brackets("(", drawn, ")") : drawn);
      }
      const bool is_opening_bar = is_bar && !is_closing_bar;
      last = is_unary || is_opening_bar || is_open_bracket(parts[i]) ? Role::none : role;
    }
    return result;
  }

  /// True if two words would be read as one if no blank separated them: delta q.
  [[nodiscard]] bool needs_blank(const Block& left, const Block& right) const {
    if (is_unicode() || left.width() < 2 || right.width() == 0) return false;
    const std::string& line = left.lines[left.base];
    const bool is_word = is_letter(line.back()) && is_letter(line[line.size() - 2]);
    return is_word && is_letter(right.lines[right.base].front());
  }

  [[nodiscard]] Block parse_brackets(const std::vector<Glyphs>& parts, std::size_t open,
                                     std::size_t close) const {
    const auto begin = parts.begin();
    const std::vector<Glyphs> inside(begin + static_cast<std::ptrdiff_t>(open) + 1,
                                     begin + static_cast<std::ptrdiff_t>(close));
    const Block drawn = in_brackets(parts[open].text, row(inside), base_of(parts[close]).text);
    return parts[close].kind == GlyphKind::scripts ? with_scripts(drawn, parts[close]) : drawn;
  }

  Alphabet alphabet_;
  Fractions fractions_;
};

}  // namespace

Block drawing(const Glyphs& glyphs, Alphabet alphabet, Fractions fractions) {
  return Drawer(alphabet, fractions).draw(glyphs);
}

std::string small_exponent(const std::string& exponent) {
  return to_small_glyphs(exponent, &SmallGlyph::above).value_or("^(" + exponent + ")");
}

}  // namespace elgen
