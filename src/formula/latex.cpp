// latex: converts LaTeX to glyphs and back. It reads commands, groups and scripts, and `<q>` as a
// bold q. It prints each glyph in the single form that this project uses.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "elgen/functions.hpp"
#include "formula/glyphs.hpp"

namespace elgen {
namespace {

/// A LaTeX command: one character, a sign, a space, or a glyph with arguments.
struct CommandRow {
  std::string_view command;
  std::string_view letter;  ///< text of its glyph
  GlyphKind kind = GlyphKind::letter;
  std::size_t parts = 0;  ///< number of arguments, the parts of the glyph
};

constexpr std::array greek_table{
    CommandRow{"alpha", "α"},    CommandRow{"beta", "β"},    CommandRow{"gamma", "γ"},
    CommandRow{"delta", "δ"},    CommandRow{"epsilon", "ϵ"}, CommandRow{"varepsilon", "ε"},
    CommandRow{"zeta", "ζ"},     CommandRow{"eta", "η"},     CommandRow{"theta", "θ"},
    CommandRow{"vartheta", "ϑ"}, CommandRow{"iota", "ι"},    CommandRow{"kappa", "κ"},
    CommandRow{"lambda", "λ"},   CommandRow{"mu", "μ"},      CommandRow{"nu", "ν"},
    CommandRow{"xi", "ξ"},       CommandRow{"pi", "π"},      CommandRow{"rho", "ρ"},
    CommandRow{"varrho", "ϱ"},   CommandRow{"sigma", "σ"},   CommandRow{"tau", "τ"},
    CommandRow{"upsilon", "υ"},  CommandRow{"phi", "ϕ"},     CommandRow{"varphi", "φ"},
    CommandRow{"chi", "χ"},      CommandRow{"psi", "ψ"},     CommandRow{"omega", "ω"},
    CommandRow{"Gamma", "Γ"},    CommandRow{"Delta", "Δ"},   CommandRow{"Theta", "Θ"},
    CommandRow{"Lambda", "Λ"},   CommandRow{"Xi", "Ξ"},      CommandRow{"Pi", "Π"},
    CommandRow{"Sigma", "Σ"},    CommandRow{"Upsilon", "Υ"}, CommandRow{"Phi", "Φ"},
    CommandRow{"Psi", "Ψ"},      CommandRow{"Omega", "Ω"},
};

/// All commands except Greek letters.
constexpr std::array command_table{
    CommandRow{"cdot", "⋅", GlyphKind::sign},
    CommandRow{"partial", "∂", GlyphKind::letter},
    CommandRow{"top", "⊤", GlyphKind::letter},
    CommandRow{"sum", "∑", GlyphKind::sign},
    CommandRow{"int", "∫", GlyphKind::sign},
    CommandRow{"prime", "′", GlyphKind::letter},
    CommandRow{"pm", "±", GlyphKind::letter},
    CommandRow{"mp", "∓", GlyphKind::sign},
    CommandRow{"le", "<=", GlyphKind::sign},
    CommandRow{"times", "×", GlyphKind::sign},
    CommandRow{"ell", "ℓ", GlyphKind::letter},
    CommandRow{"quad", "1", GlyphKind::space},
    CommandRow{"thinspace", "0.17", GlyphKind::space},
    CommandRow{"left", "", GlyphKind::left},
    CommandRow{"right", "", GlyphKind::right},
    CommandRow{"frac", "", GlyphKind::fraction, 2},
    CommandRow{"sqrt", "", GlyphKind::root, 1},
    CommandRow{"dot", "˙", GlyphKind::accent, 1},
    CommandRow{"ddot", "¨", GlyphKind::accent, 1},
    CommandRow{"mathbf", "", GlyphKind::bold},
    CommandRow{"boldsymbol", "", GlyphKind::bold},
    CommandRow{"bm", "", GlyphKind::bold},
    CommandRow{"text", "", GlyphKind::prose},
    CommandRow{"mathrm", "", GlyphKind::word},
    CommandRow{"operatorname", "", GlyphKind::function},
};

/// True for the commands of functions: \sin, \arctan, \ln.
bool is_function_command(std::string_view name) {
  return name == "ln" || name.starts_with("arc") || find_function(name) != nullptr;
}

/// Concatenates the letters of all parts.
std::string letters_of(const Glyphs& glyphs) {
  std::string text = glyphs.text;
  for (const Glyphs& part : glyphs.parts) text += letters_of(part);
  return text;
}

/// The largest depth of groups. The content of deeper groups is dropped.
constexpr int max_group_depth = 200;

bool continues_number(char c) { return is_digit(c) || c == '.'; }
bool continues_character(char c) { return !starts_code_point(c); }

class LatexReader {
 public:
  explicit LatexReader(std::string_view text) : text_(text) {}

  Glyphs read_row(char end, int depth = 0) {
    Glyphs result;
    bool is_apart = false;
    while (at_ < text_.size() && text_[at_] != end) {
      const char c = text_[at_];
      if (c == '_' || c == '^') {
        ++at_;
        add_script(result, c == '_' ? 1 : 2, read_argument(depth));
      } else if (c == ' ' || c == '}') {
        is_apart = text_[at_++] == ' ' || is_apart;
      } else {
        result.parts.push_back(read_piece(depth));
        result.parts.back().has_space_before = std::exchange(is_apart, false);
      }
    }
    at_ = std::min(at_ + 1, text_.size());
    return result;
  }

 private:
  Glyphs read_argument(int depth) {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return read_piece(depth);
  }

  Glyphs read_piece(int depth) {
    if (depth == max_group_depth) at_ = text_.size();
    if (at_ == text_.size()) return {};
    const char c = text_[at_];
    if (c == '\\') return read_command(depth + 1);
    if (is_digit(c)) return {GlyphKind::number, read_while(continues_number)};
    if (c == '<' && text_.find('>', at_) != std::string_view::npos) {
      std::string name = read_enclosed_text('>');
      const std::string_view greek = greek_letter(name);
      return {GlyphKind::bold, greek.empty() ? std::move(name) : std::string(greek)};
    }
    const bool is_ascii = static_cast<unsigned char>(c) < 0x80;
    if (is_letter(c) || !is_ascii) return {GlyphKind::letter, read_while(continues_character)};
    ++at_;
    if (c == '{') return read_row('}', depth + 1);
    if (c == '\'') return {GlyphKind::letter, "′"};
    const bool is_bracket = std::string_view("()[]|").find(c) != std::string_view::npos;
    return {is_bracket ? GlyphKind::bracket : GlyphKind::sign, std::string(1, c)};
  }

  /// Reads one character, then further characters until `continues` is false.
  std::string read_while(const auto& continues) {
    const std::size_t begin = at_++;
    while (at_ < text_.size() && continues(text_[at_])) ++at_;
    return std::string(text_.substr(begin, at_ - begin));
  }

  /// Reads an opening bracket and the text after it, up to the next `end`. Returns this text.
  std::string read_enclosed_text(char end) {
    const std::string text = read_while([end](char c) { return c != end; });
    at_ = std::min(at_ + 1, text_.size());
    return text.substr(1);
  }

  Glyphs read_command(int depth) {
    std::string name = read_while(is_letter).substr(1);
    if (name.empty() && at_ < text_.size()) name = read_while(continues_character);
    const auto row = std::ranges::find(command_table, name, &CommandRow::command);
    if (row != command_table.end()) return read_arguments(*row, depth);
    const std::string_view greek = greek_letter(name);
    if (!greek.empty()) return {GlyphKind::letter, std::string(greek)};
    return {is_function_command(name) ? GlyphKind::function : GlyphKind::command, std::move(name)};
  }

  /// The glyph of `row` and its arguments. Parts are moved: copies would cost depth squared.
  Glyphs read_arguments(const CommandRow& row, int depth) {
    Glyphs glyphs{row.kind, std::string(row.letter)};
    for (std::size_t i = 0; i < row.parts; ++i) glyphs.parts.push_back(read_argument(depth));
    if (row.parts > 0 || !row.letter.empty()) return glyphs;
    const bool grows = row.kind == GlyphKind::left || row.kind == GlyphKind::right;
    const bool is_group = !grows && at_ < text_.size() && text_[at_] == '{';
    glyphs.text = row.kind == GlyphKind::bold ? letters_of(read_argument(depth))
                  : is_group                  ? read_enclosed_text('}')
                                              : read_argument(depth).text;
    if (grows && glyphs.text == ".") glyphs.text.clear();
    return glyphs;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

std::string group_latex(const Glyphs& glyphs) { return fmt::format("{{{}}}", to_latex(glyphs)); }

/// True if the text ends with a command, which a following letter would extend.
bool ends_with_command(std::string_view text) {
  const auto end = std::find_if_not(text.rbegin(), text.rend(), is_letter);
  return end != text.rbegin() && end != text.rend() && *end == '\\';
}

/// \theta, \partial, \quad; the character itself if it has no command.
std::string letter_latex(const Glyphs& glyphs) {
  if (glyphs.text == "′") return "'";
  const std::string_view greek = greek_command(glyphs.text);
  if (!greek.empty()) return fmt::format("\\{}", greek);
  for (const CommandRow& row : command_table) {
    if (row.kind == glyphs.kind && row.letter == glyphs.text) {
      return fmt::format("\\{}", row.command);
    }
  }
  return glyphs.text;
}

std::string bracket_latex(const std::string& text) { return text.empty() ? "." : text; }

std::string piece_latex(const Glyphs& glyphs) {
  const std::string& text = glyphs.text;
  switch (glyphs.kind) {
    case GlyphKind::row:
      return group_latex(glyphs);
    case GlyphKind::letter:
    case GlyphKind::sign:
    case GlyphKind::space:
      return letter_latex(glyphs);
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
      return "\\left" + bracket_latex(text);
    case GlyphKind::right:
      return "\\right" + bracket_latex(text);
    case GlyphKind::fraction:
      return "\\frac" + group_latex(glyphs.parts[0]) + group_latex(glyphs.parts[1]);
    case GlyphKind::root:
      return "\\sqrt" + group_latex(glyphs.parts[0]);
    case GlyphKind::accent:
      return (text == "¨" ? "\\ddot" : "\\dot") + group_latex(glyphs.parts[0]);
    case GlyphKind::scripts: {
      std::string all = piece_latex(glyphs.parts[0]);
      if (is_present(glyphs.parts[1])) all += "_" + group_latex(glyphs.parts[1]);
      if (is_present(glyphs.parts[2])) all += "^" + group_latex(glyphs.parts[2]);
      return all;
    }
  }
  return "";
}

}  // namespace

std::string_view greek_letter(std::string_view command) {
  const auto row = std::ranges::find(greek_table, command, &CommandRow::command);
  return row == greek_table.end() ? std::string_view() : row->letter;
}

std::string_view greek_command(std::string_view letter) {
  const auto row = std::ranges::find(greek_table, letter, &CommandRow::letter);
  return row == greek_table.end() ? std::string_view() : row->command;
}

Glyphs read_latex(std::string_view latex) { return LatexReader(latex).read_row('\0'); }

std::string to_latex(const Glyphs& glyphs) {
  if (glyphs.kind != GlyphKind::row) return piece_latex(glyphs);
  std::string text;
  for (const Glyphs& part : glyphs.parts) {
    const std::string next = piece_latex(part);
    const bool is_needed = !next.empty() && is_letter(next.front()) && ends_with_command(text);
    text += (part.has_space_before || is_needed ? " " : "") + next;
  }
  return text;
}

}  // namespace elgen
