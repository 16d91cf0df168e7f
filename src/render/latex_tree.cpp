// latex_tree: a reader of commands, groups and scripts, and the widths of what it read.
#include "render/latex_tree.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "elgen/functions.hpp"
#include "render/symbols.hpp"

namespace elgen {
namespace {

/// Commands that stand for one character, or a space.
struct CommandRow {
  std::string_view name;
  LatexKind kind;
  std::string_view text;
};

constexpr std::array command_table{
    CommandRow{"cdot", LatexKind::sign, "⋅"},
    CommandRow{"partial", LatexKind::letter, "∂"},
    CommandRow{"top", LatexKind::letter, "⊤"},
    CommandRow{"sum", LatexKind::sign, "∑"},
    CommandRow{"thinspace", LatexKind::space, "0.17"},
    CommandRow{"quad", LatexKind::space, "1"},
    CommandRow{"prime", LatexKind::letter, "′"},
};

/// \sin, \arctan, \ln
bool is_function_command(std::string_view name) {
  return name == "ln" || name.substr(0, 3) == "arc" || find_function(name) != nullptr;
}

/// Parts are moved: copies on every level would cost the square of the depth.
template <class... Parts>
LatexTree with_parts(LatexKind kind, std::string_view text, Parts... parts) {
  LatexTree tree{kind, std::string(text), {}};
  (tree.parts.push_back(std::move(parts)), ...);
  return tree;
}

/// Nobody reads deeper formulas; what is inside them is left out.
constexpr int deepest = 200;

class LatexReader {
 public:
  explicit LatexReader(std::string_view text) : text_(text) {}

  LatexTree row(char end) {
    LatexTree result;
    bool is_apart = false;
    while (at_ < text_.size() && text_[at_] != end) {
      if (text_[at_] == ' ' || text_[at_] == '}') {
        is_apart = is_apart || text_[at_] == ' ';
        ++at_;
      } else if (text_[at_] == '_' || text_[at_] == '^') {
        add_script(result);
      } else {
        result.parts.push_back(piece());
        result.parts.back().is_apart = std::exchange(is_apart, false);
      }
    }
    at_ = std::min(at_ + 1, text_.size());
    return result;
  }

 private:
  void add_script(LatexTree& row) {
    const std::size_t place = text_[at_++] == '_' ? 1 : 2;
    LatexTree script = argument();
    if (row.parts.empty()) row.parts.emplace_back();
    LatexTree& base = row.parts.back();
    if (base.kind != LatexKind::scripts) {
      LatexTree bare = std::move(base);
      base = {LatexKind::scripts, "", {}};
      base.parts.resize(3);
      base.parts[0] = std::move(bare);
    }
    base.parts[place] = std::move(script);
  }

  LatexTree argument() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    if (at_ == text_.size()) return {};
    return piece();
  }

  LatexTree piece() {
    if (depth_ == deepest) {
      at_ = text_.size();
      return {};
    }
    ++depth_;
    LatexTree read = piece_of_depth();
    --depth_;
    return read;
  }

  LatexTree piece_of_depth() {
    const char c = text_[at_];
    if (c == '{') {
      ++at_;
      return row('}');
    }
    if (c == '\\') return command();
    if (is_digit(c)) return number();
    if (c == '\'') {
      ++at_;
      return {LatexKind::letter, "′"};
    }
    if (static_cast<unsigned char>(c) >= 0x80) return letter_of_another_script();
    ++at_;
    const LatexKind kind = is_letter(c)                            ? LatexKind::letter
                           : std::string_view("()[]|").find(c) < 5 ? LatexKind::bracket
                                                                   : LatexKind::sign;
    return {kind, std::string(1, c)};
  }

  LatexTree letter_of_another_script() {
    const std::size_t begin = at_;
    at_ += bytes_here();
    return {LatexKind::letter, std::string(text_.substr(begin, at_ - begin))};
  }

  /// Of the character that stands next.
  [[nodiscard]] std::size_t bytes_here() const {
    return std::max<std::size_t>(1, code_point_at(text_, at_).bytes);
  }

  LatexTree number() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.')) ++at_;
    return {LatexKind::number, std::string(text_.substr(begin, at_ - begin))};
  }

  std::string_view command_name() {
    const std::size_t begin = ++at_;
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    if (at_ == begin && at_ < text_.size()) at_ += bytes_here();
    return text_.substr(begin, at_ - begin);
  }

  LatexTree command() {
    const std::string_view name = command_name();
    if (name == "left" || name == "right") {
      const std::string bracket = argument().text;
      return {LatexKind::tall, bracket == "." ? "" : bracket};
    }
    if (name == "frac") {
      LatexTree above = argument();
      return with_parts(LatexKind::fraction, "", std::move(above), argument());
    }
    if (name == "sqrt") return with_parts(LatexKind::root, "", argument());
    if (name == "dot") return with_parts(LatexKind::accent, "˙", argument());
    if (name == "ddot") return with_parts(LatexKind::accent, "¨", argument());
    if (name == "mathrm" || name == "operatorname" || name == "text") {
      return {name == "operatorname" ? LatexKind::function : LatexKind::word, raw_argument()};
    }
    return single(name);
  }

  static LatexTree single(std::string_view name) {
    const std::string_view greek = greek_letter(name);
    if (!greek.empty()) return {LatexKind::letter, std::string(greek)};
    if (is_function_command(name)) return {LatexKind::function, std::string(name)};
    for (const CommandRow& row : command_table) {
      if (row.name == name) return {row.kind, std::string(row.text)};
    }
    return {LatexKind::word, std::string(name)};
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

double width_of_parts(const LatexTree& tree) {
  double sum = 0;
  for (const LatexTree& part : tree.parts) sum += width(part);
  return sum;
}

}  // namespace

LatexTree read_latex(std::string_view latex) { return LatexReader(latex).row('\0'); }

double width(const LatexTree& tree) {
  constexpr double smaller = 0.75;  // scripts, beside their base
  switch (tree.kind) {
    case LatexKind::letter:
      return 1.1;
    case LatexKind::number:
      return 0.95 * static_cast<double>(tree.text.size());
    case LatexKind::word:
    case LatexKind::function:
      return 0.9 * static_cast<double>(tree.text.size()) + 0.6;
    case LatexKind::sign:
      return tree.text == "," ? 0.9 : 2.4;
    case LatexKind::bracket:
      return 0.8;
    case LatexKind::tall:
      return 1.4;
    case LatexKind::space:
      return 0.4;
    case LatexKind::fraction:
      return 0.6 + std::max(width(tree.parts[0]), width(tree.parts[1]));
    case LatexKind::root:
      return 1.8 + width(tree.parts[0]);
    case LatexKind::scripts:
      return width(tree.parts[0]) + smaller * std::max(width(tree.parts[1]), width(tree.parts[2]));
    case LatexKind::row:
    case LatexKind::accent:
      return width_of_parts(tree);
  }
  return 0;
}

}  // namespace elgen
