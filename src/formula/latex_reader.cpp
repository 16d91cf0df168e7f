// latex_reader: commands, groups and scripts of LaTeX -> glyphs. `<q>` is a vector, as bold q.
#include <algorithm>
#include <utility>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "formula/glyphs.hpp"

namespace elgen {
namespace {

/// The letters of all parts, one after the other.
std::string letters_of(const Glyphs& glyphs) {
  std::string text = glyphs.text;
  for (const Glyphs& part : glyphs.parts) text += letters_of(part);
  return text;
}

/// Formulas are never deeper; the content of deeper ones is left out.
constexpr int deepest = 200;

bool continues_number(char c) { return is_digit(c) || c == '.'; }
bool continues_character(char c) { return !starts_code_point(c); }

class LatexReader {
 public:
  explicit LatexReader(std::string_view text) : text_(text) {}

  Glyphs row(char end, int depth = 0) {
    Glyphs result;
    bool is_apart = false;
    while (at_ < text_.size() && text_[at_] != end) {
      const char c = text_[at_];
      if (c == '_' || c == '^') {
        ++at_;
        add_script(result, c == '_' ? 1 : 2, argument(depth));
      } else if (c == ' ' || c == '}') {
        is_apart = text_[at_++] == ' ' || is_apart;
      } else {
        result.parts.push_back(piece(depth));
        result.parts.back().is_apart = std::exchange(is_apart, false);
      }
    }
    at_ = std::min(at_ + 1, text_.size());
    return result;
  }

 private:
  Glyphs argument(int depth) {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return piece(depth);
  }

  Glyphs piece(int depth) {
    if (depth == deepest) at_ = text_.size();
    if (at_ == text_.size()) return {};
    const char c = text_[at_];
    if (c == '\\') return command(depth + 1);
    if (is_digit(c)) return {GlyphKind::number, taken(continues_number)};
    if (c == '<' && text_.find('>', at_) != std::string_view::npos) {
      std::string name = enclosed_text('>');
      const std::string_view greek = greek_letter(name);
      return {GlyphKind::bold, greek.empty() ? std::move(name) : std::string(greek)};
    }
    const bool is_ascii = static_cast<unsigned char>(c) < 0x80;
    if (is_letter(c) || !is_ascii) return {GlyphKind::letter, taken(continues_character)};
    ++at_;
    if (c == '{') return row('}', depth + 1);
    if (c == '\'') return {GlyphKind::letter, "′"};
    const bool is_bracket = std::string_view("()[]|").find(c) != std::string_view::npos;
    return {is_bracket ? GlyphKind::bracket : GlyphKind::sign, std::string(1, c)};
  }

  /// The character here, and those behind it that go on with it.
  std::string taken(const auto& continues) {
    const std::size_t begin = at_++;
    while (at_ < text_.size() && continues(text_[at_])) ++at_;
    return std::string(text_.substr(begin, at_ - begin));
  }

  /// The text behind the bracket here, up to the next `end`.
  std::string enclosed_text(char end) {
    const std::string text = taken([end](char c) { return c != end; });
    at_ = std::min(at_ + 1, text_.size());
    return text.substr(1);
  }

  Glyphs command(int depth) {
    std::string name = taken(is_letter).substr(1);
    if (name.empty() && at_ < text_.size()) name = taken(continues_character);
    const auto row = std::ranges::find(commands(), name, &CommandRow::command);
    if (row != commands().end()) return with_arguments(*row, depth);
    const std::string_view greek = greek_letter(name);
    if (!greek.empty()) return {GlyphKind::letter, std::string(greek)};
    return {is_function_command(name) ? GlyphKind::function : GlyphKind::command, std::move(name)};
  }

  /// Parts are moved: copies on every level would cost the square of the depth.
  Glyphs with_arguments(const CommandRow& row, int depth) {
    Glyphs glyphs{row.kind, std::string(row.letter)};
    for (std::size_t i = 0; i < row.parts; ++i) glyphs.parts.push_back(argument(depth));
    if (row.parts > 0 || !row.letter.empty()) return glyphs;
    const bool grows = row.kind == GlyphKind::left || row.kind == GlyphKind::right;
    const bool is_group = !grows && at_ < text_.size() && text_[at_] == '{';
    glyphs.text = row.kind == GlyphKind::bold ? letters_of(argument(depth))
                  : is_group                  ? enclosed_text('}')
                                              : argument(depth).text;
    if (grows && glyphs.text == ".") glyphs.text.clear();
    return glyphs;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

Glyphs read_latex(std::string_view latex) { return LatexReader(latex).row('\0'); }

}  // namespace elgen
