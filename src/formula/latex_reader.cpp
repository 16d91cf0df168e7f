// latex_reader: commands, groups and scripts of LaTeX -> glyphs. `<q>` is a vector, as bold q.
#include <algorithm>
#include <utility>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "elgen/functions.hpp"
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

class LatexReader {
 public:
  explicit LatexReader(std::string_view text) : text_(text) {}

  Glyphs row(char end) {
    Glyphs result;
    bool is_apart = false;
    while (at_ < text_.size() && text_[at_] != end) {
      if (text_[at_] == ' ' || text_[at_] == '}') {
        is_apart = is_apart || text_[at_] == ' ';
        ++at_;
      } else if (text_[at_] == '_' || text_[at_] == '^') {
        const std::size_t place = text_[at_++] == '_' ? 1 : 2;
        add_script(result, place, argument());
      } else {
        result.parts.push_back(piece());
        result.parts.back().is_apart = std::exchange(is_apart, false);
      }
    }
    at_ = std::min(at_ + 1, text_.size());
    return result;
  }

 private:
  Glyphs argument() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    if (at_ == text_.size()) return {};
    return piece();
  }

  Glyphs piece() {
    if (depth_ == deepest) {
      at_ = text_.size();
      return {};
    }
    ++depth_;
    Glyphs read = piece_of_depth();
    --depth_;
    return read;
  }

  Glyphs piece_of_depth() {
    const char c = text_[at_];
    const std::size_t vector_end = c == '<' ? text_.find('>', at_) : std::string_view::npos;
    if (c == '\\') return command();
    if (is_digit(c))
      return {GlyphKind::number, taken([](char d) { return is_digit(d) || d == '.'; })};
    if (static_cast<unsigned char>(c) >= 0x80) return {GlyphKind::letter, characters(bytes_here())};
    if (vector_end != std::string_view::npos) {
      const std::string name = characters(vector_end + 1 - at_).substr(1);
      const std::string_view greek = greek_letter(name.substr(0, name.size() - 1));
      return {GlyphKind::bold,
              greek.empty() ? name.substr(0, name.size() - 1) : std::string(greek)};
    }
    ++at_;
    if (c == '{') return row('}');
    if (c == '\'') return {GlyphKind::letter, "′"};
    const bool is_bracket = std::string_view("()[]|").find(c) != std::string_view::npos;
    return {is_letter(c) ? GlyphKind::letter
            : is_bracket ? GlyphKind::bracket
                         : GlyphKind::sign,
            std::string(1, c)};
  }

  std::string characters(std::size_t count) {
    at_ += count;
    return std::string(text_.substr(at_ - count, count));
  }

  template <class Holds>
  std::string taken(const Holds& holds) {
    const auto* const begin = text_.begin() + at_;
    return characters(
        static_cast<std::size_t>(std::find_if_not(begin, text_.end(), holds) - begin));
  }

  [[nodiscard]] std::size_t bytes_here() const {
    return std::max<std::size_t>(1, code_point_at(text_, at_).bytes);
  }

  Glyphs command() {
    ++at_;
    std::string name = taken(is_letter);
    if (name.empty() && at_ < text_.size()) name = characters(bytes_here());
    if (name == "left" || name == "right") {
      const std::string bracket = argument().text;
      return {name == "left" ? GlyphKind::left : GlyphKind::right, bracket == "." ? "" : bracket};
    }
    if (name == "frac") {
      Glyphs above = argument();
      return with_parts(GlyphKind::fraction, "", std::move(above), argument());
    }
    if (name == "sqrt") return with_parts(GlyphKind::root, "", argument());
    if (name == "dot") return with_parts(GlyphKind::accent, "˙", argument());
    if (name == "ddot") return with_parts(GlyphKind::accent, "¨", argument());
    if (name == "mathbf" || name == "boldsymbol" || name == "bm") {
      return {GlyphKind::bold, letters_of(argument())};
    }
    if (name == "text") return {GlyphKind::prose, raw_argument()};
    if (name == "mathrm") return {GlyphKind::word, raw_argument()};
    if (name == "operatorname") return {GlyphKind::function, raw_argument()};
    return single(std::move(name));
  }

  /// Parts are moved: copies on every level would cost the square of the depth.
  template <class... Parts>
  static Glyphs with_parts(GlyphKind kind, std::string text, Parts... parts) {
    Glyphs glyphs{kind, std::move(text), {}};
    (glyphs.parts.push_back(std::move(parts)), ...);
    return glyphs;
  }

  static Glyphs single(std::string name) {
    const std::string_view greek = greek_letter(name);
    if (!greek.empty()) return {GlyphKind::letter, std::string(greek)};
    if (is_function_command(name)) return {GlyphKind::function, std::move(name)};
    for (const CommandRow& row : commands()) {
      if (row.command == name) return {row.kind, std::string(row.letter)};
    }
    return {GlyphKind::command, std::move(name)};
  }

  /// The text of a group, as it stands.
  std::string raw_argument() {
    if (at_ == text_.size() || text_[at_] != '{') return argument().text;
    const std::size_t end = std::min(text_.find('}', at_), text_.size());
    const std::string text(text_.substr(at_ + 1, end - at_ - 1));
    at_ = std::min(end + 1, text_.size());
    return text;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

Glyphs read_latex(std::string_view latex) { return LatexReader(latex).row('\0'); }

}  // namespace elgen
