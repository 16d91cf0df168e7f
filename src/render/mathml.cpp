// mathml: a LatexTree -> MathML Core, one element per piece.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/utf8.hpp"
#include "render/fill_template.hpp"
#include "render/latex.hpp"

namespace elgen {
namespace {

/// One element, whatever the row holds.
std::string element(const LatexTree& tree) {
  const bool is_single = tree.kind != LatexKind::row || tree.parts.size() == 1;
  return is_single ? mathml(tree) : fmt::format("<mrow>{}</mrow>", mathml(tree));
}

bool is_absent(const LatexTree& tree) { return tree.kind == LatexKind::row && tree.parts.empty(); }

std::string scripts(const LatexTree& tree) {
  const std::string base = element(tree.parts[0]);
  const std::string below = element(tree.parts[1]);
  const std::string above = element(tree.parts[2]);
  if (tree.parts[0].text == "∑") return fmt::format("<munder>{}{}</munder>", base, below);
  if (is_absent(tree.parts[2])) return fmt::format("<msub>{}{}</msub>", base, below);
  if (is_absent(tree.parts[1])) return fmt::format("<msup>{}{}</msup>", base, above);
  return fmt::format("<msubsup>{}{}{}</msubsup>", base, below, above);
}

bool is_function(const LatexTree& tree) {
  return tree.kind == LatexKind::function ||
         (tree.kind == LatexKind::scripts && is_function(tree.parts[0]));
}

bool is_bracket(const LatexTree& tree) {
  return tree.kind == LatexKind::bracket || tree.kind == LatexKind::tall;
}

bool is_opening(const LatexTree& tree) {
  return is_bracket(tree) && (tree.text == "(" || tree.text == "[" || tree.text.empty());
}

/// Functions stand apart from what is before them, and from arguments without brackets.
std::string row(const LatexTree& tree) {
  constexpr const char* thin = R"(<mspace width="0.17em"/>)";
  std::string text;
  for (std::size_t i = 0; i < tree.parts.size(); ++i) {
    const LatexTree& part = tree.parts[i];
    const bool follows =
        i > 0 && tree.parts[i - 1].kind != LatexKind::sign && !is_opening(tree.parts[i - 1]);
    if (is_function(part) && follows) text += thin;
    text += mathml(part);
    if (!is_function(part) || i + 1 == tree.parts.size()) continue;
    text += "<mo>&#x2061;</mo>";
    if (!is_bracket(tree.parts[i + 1])) text += thin;
  }
  return text;
}

/// Blanks at the ends of an element are not shown unless they are fixed.
std::string with_fixed_blanks(std::string text) {
  constexpr std::string_view blank = "&#xA0;";
  if (text.ends_with(' ')) text.replace(text.size() - 1, 1, blank);
  if (text.starts_with(' ')) text.replace(0, 1, blank);
  return text;
}

/// Letters and the bold ones, which Unicode has for mathematics, and MathML no attribute.
struct BoldLetters {
  char32_t first;
  char32_t last;
  char32_t bold;
};
constexpr std::array bold_table{BoldLetters{U'A', U'Z', 0x1D400}, BoldLetters{U'a', U'z', 0x1D41A},
                                BoldLetters{U'0', U'9', 0x1D7CE},
                                BoldLetters{0x391, 0x3A9, 0x1D6A8},
                                BoldLetters{0x3B1, 0x3C9, 0x1D6C2}};

std::string bold(const std::string& text) {
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

std::string sign(const std::string& text) {
  return fmt::format("<mo>{}</mo>", text == "-" ? "−" : xml_text(text));
}

}  // namespace

std::string xml_text(const std::string& text) {
  return escaped(text, {{'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}});
}

std::string mathml(const LatexTree& tree) {
  switch (tree.kind) {
    case LatexKind::row:
      return row(tree);
    case LatexKind::letter:
      return fmt::format("<mi>{}</mi>", tree.text);
    case LatexKind::word:
    case LatexKind::function: {
      const char* upright = tree.text.size() == 1 ? R"( mathvariant="normal")" : "";
      return fmt::format("<mi{}>{}</mi>", upright, xml_text(tree.text));
    }
    case LatexKind::bold:
      return fmt::format("<mi>{}</mi>", bold(tree.text));
    case LatexKind::text:
      return fmt::format("<mtext>{}</mtext>", with_fixed_blanks(xml_text(tree.text)));
    case LatexKind::number:
      return fmt::format("<mn>{}</mn>", tree.text);
    case LatexKind::sign:
      return sign(tree.text);
    case LatexKind::bracket:
      return fmt::format(R"(<mo stretchy="false">{}</mo>)", tree.text);
    case LatexKind::tall:
      return tree.text.empty() ? "" : fmt::format(R"(<mo stretchy="true">{}</mo>)", tree.text);
    case LatexKind::space:
      return fmt::format(R"(<mspace width="{}em"/>)", tree.text);
    case LatexKind::fraction:
      return fmt::format("<mfrac>{}{}</mfrac>", element(tree.parts[0]), element(tree.parts[1]));
    case LatexKind::root:
      return fmt::format("<msqrt>{}</msqrt>", mathml(tree.parts[0]));
    case LatexKind::accent:
      return fmt::format(R"(<mover accent="true">{}<mo>{}</mo></mover>)", element(tree.parts[0]),
                         tree.text);
    case LatexKind::scripts:
      return scripts(tree);
  }
  return "";
}

}  // namespace elgen
