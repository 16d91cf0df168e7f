// mathml: converts glyphs to MathML Core, one element per piece.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/fill_template.hpp"
#include "base/utf8.hpp"
#include "formula/glyphs.hpp"

namespace elgen {
namespace {

/// Wraps a row in a single element.
std::string wrap_element(const Glyphs& glyphs) {
  const bool is_single = glyphs.kind != GlyphKind::row || glyphs.parts.size() == 1;
  return is_single ? to_mathml(glyphs) : fmt::format("<mrow>{}</mrow>", to_mathml(glyphs));
}

std::string scripts_mathml(const Glyphs& glyphs) {
  const std::string base = wrap_element(glyphs.parts[0]);
  const std::string below = wrap_element(glyphs.parts[1]);
  const std::string above = wrap_element(glyphs.parts[2]);
  if (glyphs.parts[0].text == "∑") return fmt::format("<munder>{}{}</munder>", base, below);
  if (!is_present(glyphs.parts[2])) return fmt::format("<msub>{}{}</msub>", base, below);
  if (!is_present(glyphs.parts[1])) return fmt::format("<msup>{}{}</msup>", base, above);
  return fmt::format("<msubsup>{}{}{}</msubsup>", base, below, above);
}

bool is_function(const Glyphs& glyphs) {
  return glyphs.kind == GlyphKind::function ||
         (glyphs.kind == GlyphKind::scripts && is_function(glyphs.parts[0]));
}

bool is_bracket(const Glyphs& glyphs) {
  return glyphs.kind == GlyphKind::bracket || glyphs.kind == GlyphKind::left ||
         glyphs.kind == GlyphKind::right;
}

bool is_opening(const Glyphs& glyphs) {
  return is_bracket(glyphs) && (glyphs.text == "(" || glyphs.text == "[" || glyphs.text.empty());
}

/// Writes a row. A function has space before it, and before an argument without brackets.
std::string row_mathml(const Glyphs& glyphs) {
  constexpr const char* thin = R"(<mspace width="0.17em"/>)";
  std::string text;
  for (std::size_t i = 0; i < glyphs.parts.size(); ++i) {
    const Glyphs& part = glyphs.parts[i];
    const bool follows =
        i > 0 && glyphs.parts[i - 1].kind != GlyphKind::sign && !is_opening(glyphs.parts[i - 1]);
    if (is_function(part) && follows) text += thin;
    text += to_mathml(part);
    if (!is_function(part) || i + 1 == glyphs.parts.size()) continue;
    text += "<mo>&#x2061;</mo>";
    if (!is_bracket(glyphs.parts[i + 1])) text += thin;
  }
  return text;
}

/// Replaces blanks at both ends by no-break spaces, because browsers drop blanks at ends.
std::string fix_outer_blanks(std::string text) {
  constexpr std::string_view blank = "&#xA0;";
  if (text.ends_with(' ')) text.replace(text.size() - 1, 1, blank);
  if (text.starts_with(' ')) text.replace(0, 1, blank);
  return text;
}

/// A range of letters and their bold forms in Unicode; MathML Core has no attribute for bold.
struct BoldLetters {
  char32_t first;
  char32_t last;
  char32_t bold;
};
constexpr std::array bold_table{BoldLetters{U'A', U'Z', 0x1D400}, BoldLetters{U'a', U'z', 0x1D41A},
                                BoldLetters{U'0', U'9', 0x1D7CE},
                                BoldLetters{0x391, 0x3A9, 0x1D6A8},
                                BoldLetters{0x3B1, 0x3C9, 0x1D6C2}};

std::string bold_letters(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint point = code_point_at(text, at);
    const auto range = std::ranges::find_if(bold_table, [&point](const BoldLetters& letters) {
      return letters.first <= point.value && point.value <= letters.last;
    });
    const bool has_bold = range != bold_table.end();
    append_utf8(result, has_bold ? range->bold + (point.value - range->first) : point.value);
    at += std::max<std::size_t>(1, point.bytes);
  }
  return result;
}

std::string sign_mathml(const std::string& text) {
  return fmt::format("<mo>{}</mo>", text == "-" ? "−" : text == "<=" ? "≤" : escape_xml(text));
}

/// Writes a bracket. A bar looks equal on both sides, so its attribute `form` states the side.
std::string bracket_mathml(const Glyphs& glyphs) {
  if (glyphs.text.empty()) return "";
  const char* const form = glyphs.text != "|"               ? ""
                           : glyphs.kind == GlyphKind::left ? R"( form="prefix")"
                                                            : R"( form="postfix")";
  return fmt::format(R"(<mo stretchy="true"{}>{}</mo>)", form, glyphs.text);
}

}  // namespace

std::string escape_xml(const std::string& text) {
  return escape_markup(text, {{'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}});
}

std::string to_mathml(const Glyphs& glyphs) {
  switch (glyphs.kind) {
    case GlyphKind::row:
      return row_mathml(glyphs);
    case GlyphKind::letter:
      return fmt::format("<mi>{}</mi>", glyphs.text);
    case GlyphKind::word:
    case GlyphKind::command:
    case GlyphKind::function: {
      const char* upright = glyphs.text.size() == 1 ? R"( mathvariant="normal")" : "";
      return fmt::format("<mi{}>{}</mi>", upright, escape_xml(glyphs.text));
    }
    case GlyphKind::bold:
      return fmt::format("<mi>{}</mi>", bold_letters(glyphs.text));
    case GlyphKind::prose:
      return fmt::format("<mtext>{}</mtext>", fix_outer_blanks(escape_xml(glyphs.text)));
    case GlyphKind::number:
      return fmt::format("<mn>{}</mn>", glyphs.text);
    case GlyphKind::sign:
      return sign_mathml(glyphs.text);
    case GlyphKind::bracket:
      return fmt::format(R"(<mo stretchy="false">{}</mo>)", glyphs.text);
    case GlyphKind::left:
    case GlyphKind::right:
      return bracket_mathml(glyphs);
    case GlyphKind::space:
      return fmt::format(R"(<mspace width="{}em"/>)", glyphs.text);
    case GlyphKind::fraction:
      return fmt::format("<mfrac>{}{}</mfrac>", wrap_element(glyphs.parts[0]),
                         wrap_element(glyphs.parts[1]));
    case GlyphKind::root:
      return fmt::format("<msqrt>{}</msqrt>", to_mathml(glyphs.parts[0]));
    case GlyphKind::accent:
      return fmt::format(R"(<mover accent="true">{}<mo>{}</mo></mover>)",
                         wrap_element(glyphs.parts[0]), glyphs.text);
    case GlyphKind::scripts:
      return scripts_mathml(glyphs);
  }
  return "";
}

}  // namespace elgen
