// latex_tree: a reader of commands, groups and scripts, the widths of what it read, and lines.
#include <algorithm>
#include <array>
#include <utility>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "elgen/functions.hpp"
#include "render/latex.hpp"
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
    CommandRow{"cdot", LatexKind::sign, "⋅"},  CommandRow{"partial", LatexKind::letter, "∂"},
    CommandRow{"top", LatexKind::letter, "⊤"}, CommandRow{"sum", LatexKind::sign, "∑"},
    CommandRow{"int", LatexKind::sign, "∫"},   CommandRow{"thinspace", LatexKind::space, "0.17"},
    CommandRow{"quad", LatexKind::space, "1"}, CommandRow{"prime", LatexKind::letter, "′"},
    CommandRow{"pm", LatexKind::letter, "±"},  CommandRow{"mp", LatexKind::sign, "∓"},
    CommandRow{"le", LatexKind::sign, "<="},   CommandRow{"times", LatexKind::sign, "×"},
    CommandRow{"ell", LatexKind::letter, "ℓ"},
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

/// The letters of all parts, one after the other.
std::string letters_of(const LatexTree& tree) {
  std::string text = tree.text;
  for (const LatexTree& part : tree.parts) text += letters_of(part);
  return text;
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
      base = {LatexKind::scripts, "", {}, bare.is_apart};
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

  /// The length of the next character.
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
    if (name == "mathbf" || name == "boldsymbol" || name == "bm") {
      return {LatexKind::bold, letters_of(argument())};
    }
    if (name == "text") return {LatexKind::text, raw_argument()};
    if (name == "mathrm" || name == "operatorname") {
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

/// The text between two places where the formula may be broken.
struct Segment {
  std::string text = {};
  int brackets = 0;  ///< open in front of it
  int tall = 0;      ///< those of them that are `\left`
  double width = 0;
};

std::vector<Segment> segments(const std::string& latex, double (*measured)(const LatexTree&)) {
  std::vector<Segment> all(1);
  int braces = 0;
  int brackets = 0;
  int tall = 0;
  for (std::size_t i = 0; i < latex.size(); ++i) {
    const std::string_view rest = std::string_view(latex).substr(i);
    const bool is_break = braces == 0 && separates_terms(rest);
    if (is_break) all.push_back({"", brackets, tall});
    tall += rest.starts_with("\\left") ? 1 : rest.starts_with("\\right") ? -1 : 0;
    braces += (latex[i] == '{') - (latex[i] == '}');
    brackets += (latex[i] == '(') - (latex[i] == ')');
    if (!is_break) all.back().text += latex[i];
  }
  const auto width_of = [measured](const std::string& text) { return measured(read_latex(text)); };
  const double before = width_of("x");
  all.front().width = width_of(all.front().text);
  for (std::size_t i = 1; i < all.size(); ++i) {
    all[i].width = width_of("x " + all[i].text) - before;  // its sign stands between terms
  }
  return all;
}

/// The segment the next line begins with, where the line begins with `first`.
std::size_t next_break(const std::vector<Segment>& all, std::size_t first, double widest) {
  double filled = all[first].width;
  std::size_t best = first + 1;
  for (std::size_t i = first + 1; i < all.size(); ++i) {
    const bool is_outer = all[i].brackets <= all[best].brackets;
    if (is_outer || filled < widest / 3) best = i;
    filled += all[i].width;
    if (filled > widest) return best;
  }
  return all.size();
}

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
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
    case LatexKind::bold:
    case LatexKind::text:
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

/// Broken before + and - outside of braces.
///
///     a + \left( \frac{b}{c} + d \right) e   ->   a + \left( \frac{b}{c} \right.
///                                                 \left. {} + d \right) e
std::vector<std::string> latex_lines(const std::string& latex, double widest,
                                     double (*measured)(const LatexTree&)) {
  const std::vector<Segment> all = segments(latex, measured);
  std::vector<std::string> lines;
  for (std::size_t first = 0; first < all.size();) {
    const std::size_t end = next_break(all, first, widest);
    const int open = all[first].tall;
    std::string line = repeated("\\left. ", open) + (open > 0 ? "{} " : "");
    for (std::size_t i = first; i < end; ++i) {
      line += i > first ? " " + all[i].text : all[i].text;
    }
    if (end < all.size()) line += repeated(" \\right.", all[end].tall);
    lines.push_back(line);
    first = end;
  }
  return lines;
}

}  // namespace elgen
