// latex_printer: glyphs -> LaTeX, in the one way in which this project writes it.
#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.hpp"
#include "elgen/functions.hpp"
#include "formula/glyphs.hpp"

namespace elgen {
namespace {

std::string group(const Glyphs& glyphs) { return fmt::format("{{{}}}", latex(glyphs)); }

/// Whether a letter behind the text would be one of a command.
bool ends_with_command(std::string_view text) {
  const auto end = std::find_if_not(text.rbegin(), text.rend(), is_letter);
  return end != text.rbegin() && end != text.rend() && *end == '\\';
}

bool has_pieces(const Glyphs& script) { return !script.parts.empty() || !script.text.empty(); }

/// \theta, \partial, \quad; the character itself where it has no command.
std::string letter(const Glyphs& glyphs) {
  if (glyphs.text == "′") return "'";
  const std::string_view greek = greek_command(glyphs.text);
  if (!greek.empty()) return fmt::format("\\{}", greek);
  for (const CommandRow& row : commands()) {
    if (row.kind == glyphs.kind && row.letter == glyphs.text) {
      return fmt::format("\\{}", row.command);
    }
  }
  return glyphs.text;
}

std::string bracket(const std::string& text) { return text.empty() ? "." : text; }

std::string piece_latex(const Glyphs& glyphs) {
  const std::string& text = glyphs.text;
  switch (glyphs.kind) {
    case GlyphKind::row:
      return group(glyphs);
    case GlyphKind::letter:
    case GlyphKind::sign:
    case GlyphKind::space:
      return letter(glyphs);
    case GlyphKind::command:
      return "\\" + text;
    case GlyphKind::word:
      return fmt::format("\\mathrm{{{}}}", text);
    case GlyphKind::bold: {
      const std::string_view greek = greek_command(text);
      return greek.empty() ? fmt::format("\\mathbf{{{}}}", text)
                           : fmt::format("\\boldsymbol{{\\{}}}", greek);
    }
    case GlyphKind::prose:
      return fmt::format("\\text{{{}}}", text);
    case GlyphKind::function:
      return is_function_command(text) ? "\\" + text : fmt::format("\\operatorname{{{}}}", text);
    case GlyphKind::number:
    case GlyphKind::bracket:
      return text;
    case GlyphKind::left:
      return "\\left" + bracket(text);
    case GlyphKind::right:
      return "\\right" + bracket(text);
    case GlyphKind::fraction:
      return "\\frac" + group(glyphs.parts[0]) + group(glyphs.parts[1]);
    case GlyphKind::root:
      return "\\sqrt" + group(glyphs.parts[0]);
    case GlyphKind::accent:
      return (text == "¨" ? "\\ddot" : "\\dot") + group(glyphs.parts[0]);
    case GlyphKind::scripts: {
      std::string all = piece_latex(glyphs.parts[0]);
      if (has_pieces(glyphs.parts[1])) all += "_" + group(glyphs.parts[1]);
      if (has_pieces(glyphs.parts[2])) all += "^" + group(glyphs.parts[2]);
      return all;
    }
  }
  return "";
}

}  // namespace

bool is_function_command(std::string_view name) {
  return name == "ln" || name.starts_with("arc") || find_function(name) != nullptr;
}

std::string latex(const Glyphs& glyphs) {
  if (glyphs.kind != GlyphKind::row) return piece_latex(glyphs);
  std::string text;
  for (const Glyphs& part : glyphs.parts) {
    const std::string next = piece_latex(part);
    const bool is_needed = !next.empty() && is_letter(next.front()) && ends_with_command(text);
    text += (part.is_apart || is_needed ? " " : "") + next;
  }
  return text;
}

}  // namespace elgen
