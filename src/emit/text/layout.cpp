// layout: breaks lines. Columns are counted in bytes; only user text may have characters beyond
// ASCII.
#include "emit/text/layout.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "base/utf8.hpp"

namespace elgen {
namespace {

bool is_operator(char c) { return c == '+' || c == '-' || c == '*' || c == '/'; }

/// Comments of members are aligned in one column, except after declarations longer than this.
constexpr std::size_t widest_alignment = 72;

/// A space at which an expression may break. `depth`: 3 per enclosing bracket, plus 1 in a sum or 2
/// in a product.
struct LineBreak {
  std::size_t at = 0;
  int depth = 0;
};

std::optional<int> depth_of_break(std::string_view text, std::size_t space, int brackets) {
  const char before = space > 0 ? text[space - 1] : ' ';
  if (before == ',' || before == ';') return 3 * brackets;
  const bool is_binary =
      space + 2 < text.size() && is_operator(text[space + 1]) && text[space + 2] == ' ';
  if (!is_binary) return std::nullopt;
  const bool is_product = text[space + 1] == '*' || text[space + 1] == '/';
  return 3 * brackets + (is_product ? 2 : 1);
}

/// The last of the shallowest breaks in the last two thirds of the first `width` columns. If these
/// thirds have no break, the last break in the first third, or else the first break beyond `width`.
std::optional<LineBreak> best_break(std::string_view text, std::size_t width) {
  std::optional<LineBreak> best;
  int brackets = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(' || text[i] == '[' || text[i] == '{') ++brackets;
    if (text[i] == ')' || text[i] == ']' || text[i] == '}') --brackets;
    if (text[i] != ' ') continue;
    const std::optional<int> depth = depth_of_break(text, i, brackets);
    if (!depth) continue;
    if (i > width) return best ? best : LineBreak{i, *depth};
    if (!best || *depth <= best->depth || best->at < width / 3) best = LineBreak{i, *depth};
  }
  return best;
}

/// `text` in which no word ends in a backslash or in `??/`, the trigraph of a backslash in C99.
/// Lines end before spaces, and a backslash would continue the comment on the next line.
std::string remove_continuations(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool ends_word = i + 1 == text.size() || text[i + 1] == ' ';
    result += text[i];
    if (text[i] == '\\' && ends_word) result += '.';
    if (text.substr(i, 3) == "?\?/") result += ' ';
  }
  return result;
}

/// Breaks lines at the position that `space_in` returns for the remaining text and the width of the
/// line; npos: no more breaks.
template <class SpaceIn>
std::vector<std::string> wrap_lines(std::string_view text, const Wrapping& wrapping,
                                    const SpaceIn& space_in) {
  std::vector<std::string> lines;
  std::size_t width = wrapping.first_width - wrapping.line_end.size();
  std::string indent;
  while (text.size() > width) {
    const std::size_t at = space_in(text, width);
    if (at == std::string_view::npos) break;
    lines.push_back(fmt::format("{}{}{}", indent, text.substr(0, at), wrapping.line_end));
    text.remove_prefix(at + 1);
    indent = wrapping.indent;
    width = line_width - indent.size() - wrapping.line_end.size();
  }
  lines.push_back(indent + std::string(text));
  return lines;
}

}  // namespace

std::vector<std::string> wrap_expression(std::string_view text, const Wrapping& wrapping) {
  return wrap_lines(text, wrapping, [](std::string_view rest, std::size_t width) {
    const std::optional<LineBreak> found = best_break(rest, width);
    return found ? found->at : std::string_view::npos;
  });
}

std::string assignment(const std::string& target, const std::string& value) {
  std::string start = fmt::format("  {} = ", target);
  const bool is_long = start.size() > line_width / 2 && start.size() + value.size() >= line_width;
  if (is_long) start = fmt::format("  {} =\n      ", target);
  const Wrapping wrapping{line_width - (is_long ? 6 : start.size()) - 1, "      "};
  return start + fmt::format("{}", fmt::join(wrap_expression(value, wrapping), "\n")) + ";\n";
}

std::vector<std::string> wrap_words(std::string_view text, const Wrapping& wrapping) {
  return wrap_lines(text, wrapping, [](std::string_view rest, std::size_t width) {
    const std::size_t last = rest.rfind(' ', width);
    return last == std::string_view::npos ? rest.find(' ', width) : last;
  });
}

std::string comment_text(std::string_view text) {
  std::string line;
  for (const char c : visible_text(text)) {
    const bool is_blank = static_cast<unsigned char>(c) <= ' ';
    if (!is_blank) line += c;
    if (is_blank && !line.empty() && line.back() != ' ') line += ' ';
  }
  while (!line.empty() && line.back() == ' ') line.pop_back();
  return remove_continuations(line);
}

std::string string_literal(std::string_view text, char quote, char escape) {
  std::string literal(1, quote);
  for (const char c : comment_text(text)) {
    if (c == quote || c == escape) literal += escape;
    literal += c;
  }
  return literal + quote;
}

std::vector<std::string> member_doc_lines(const std::vector<Member>& members,
                                          const CommentMarks& marks) {
  std::size_t width = 0;
  for (const Member& member : members) {
    if (member.declaration.size() <= widest_alignment) {
      width = std::max(width, member.declaration.size());
    }
  }
  std::vector<std::string> lines;
  for (const auto& [declaration, doc] : members) {
    const bool is_aligned = declaration.size() <= width;
    const std::string padding(is_aligned ? width - declaration.size() : 0, ' ');
    const std::string line = fmt::format("{}{}  {}{}", declaration, padding, marks.behind, doc);
    const bool fits = line.size() + 2 <= line_width;
    if (!fits) lines.push_back(std::string(marks.above) + doc);
    lines.push_back(fits ? line : declaration);
  }
  return lines;
}

/// Arguments are aligned below the first argument, or indented if `start` leaves too little room.
std::string signature(const std::string& start, const std::vector<std::string>& arguments,
                      const std::string& end) {
  constexpr std::size_t widest_start = 60;
  const auto fits = [&](const std::string& argument) {
    return start.size() + argument.size() + end.size() + 4 <= line_width;
  };
  const bool is_aligned =
      start.size() < widest_start && std::all_of(arguments.begin(), arguments.end(), fits);
  const std::string indent(is_aligned ? start.size() + 1 : 4, ' ');
  std::string text = start + "(" + (is_aligned ? "" : "\n" + indent);
  std::size_t column = indent.size();
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool is_last = i + 1 == arguments.size();
    const std::string piece = arguments[i] + (is_last ? ")" + end : ",");
    const std::size_t needed =
        1 + piece.size() + (is_last ? 2 : 0);  // the brace follows the last argument
    const bool breaks = i > 0 && column + needed > line_width;
    if (breaks) text += "\n" + indent;
    if (i > 0 && !breaks) text += ' ';
    column = (breaks ? indent.size() : column + (i > 0 ? 1 : 0)) + piece.size();
    text += piece;
  }
  return text;
}

}  // namespace elgen
