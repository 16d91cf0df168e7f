// Values whose type needs no table: expressions, names, lists, texts, booleans, integers. An error
// is reported to FileReadState, and the value is returned empty; no later stage runs after an
// error.
#include "parse/value_reader.hpp"

#include <cln/integer_ring.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/ascii.hpp"
#include "base/reason.hpp"
#include "base/utf8.hpp"
#include "elgen/wording.hpp"
#include "formula/glyphs.hpp"
#include "parse/decimal.hpp"
#include "parse/expression_parser.hpp"

namespace elgen {

namespace {

/// The bytes of a mistake in a text, and the error message.
struct LatexMistake {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string message = {};
};

constexpr std::array commands{std::to_array<std::string_view>(
    {// letters; greek_letter() knows more
     "aleph", "digamma", "ell", "hbar", "imath", "jmath", "nabla", "partial", "varkappa", "varpi",
     "varsigma", "wp",
     // accents
     "acute", "bar", "breve", "check", "ddot", "dot", "grave", "hat", "mathring", "overline",
     "overrightarrow", "tilde", "underline", "vec", "widehat", "widetilde",
     // fonts
     "bm", "boldsymbol", "mathbb", "mathbf", "mathcal", "mathfrak", "mathit", "mathrm", "mathscr",
     "mathsf", "mathtt", "operatorname", "text", "textbf", "textit", "textrm",
     // signs
     "ast", "bullet", "cdot", "circ", "dagger", "ddagger", "diamond", "infty", "max", "min", "odot",
     "oplus", "otimes", "parallel", "perp", "pm", "prime", "star", "times", "top",
     // blanks
     "enspace", "quad", "thinspace"})};

/// Characters that may follow a backslash: spaces, and markup characters.
constexpr std::string_view escapes = ",:;! _{}&%#";
constexpr std::string_view marks = "_^{}'.,:;+-*/=()[]|! \t";

bool is_symbol_character(std::string_view text, std::size_t at, const CodePoint& point) {
  return point.bytes > 1 || is_letter(text[at]) || is_digit(text[at]) ||
         marks.find(text[at]) != std::string_view::npos;
}

std::size_t end_of_command(std::string_view text, std::size_t backslash) {
  std::size_t end = backslash + 1;
  while (end < text.size() && is_letter(text[end])) ++end;
  return std::min(std::max(end, backslash + 2), text.size());
}

bool is_allowed_command(std::string_view command) {
  return !greek_letter(command).empty() || std::ranges::find(commands, command) != commands.end() ||
         (command.size() == 1 && escapes.find(command) != std::string_view::npos);
}

std::optional<LatexMistake> make_latex_mistake(std::string_view text, std::size_t begin,
                                               std::size_t end, std::string_view what) {
  return LatexMistake{begin, end,
                      fmt::format("{} {}", quote_text(text.substr(begin, end - begin)), what)};
}

/// The first mistake in a LaTeX symbol: the symbol is empty, braces do not match, or a character or
/// command is not listed. The listed commands are letters, accents, fonts and signs; none opens a
/// file, defines a command, or ends the surrounding markup.
std::optional<LatexMistake> find_latex_mistake(std::string_view text) {
  if (text.find_first_not_of(" \t\n\r") == std::string_view::npos) {
    return LatexMistake{0, text.size(), "the symbol is empty"};
  }
  std::vector<std::size_t> open;
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint point = code_point_at(text, at);
    std::size_t end = at + std::max<std::size_t>(1, point.bytes);
    if (text[at] == '\\') {
      end = end_of_command(text, at);
      if (!is_allowed_command(text.substr(at + 1, end - at - 1))) {
        return make_latex_mistake(text, at, end, "is no command that a symbol may contain");
      }
    } else if (!is_symbol_character(text, at, point)) {
      return make_latex_mistake(text, at, end, "is not allowed in a symbol");
    } else if (text.substr(at, 2) == "^^") {
      return make_latex_mistake(text, at, at + 2, "is not allowed in a symbol");
    } else if (text[at] == '{') {
      open.push_back(at);
    } else if (text[at] == '}') {
      if (open.empty()) return make_latex_mistake(text, at, end, "closes nothing");
      open.pop_back();
    }
    at = end;
  }
  if (open.empty()) return std::nullopt;
  return make_latex_mistake(text, open.back(), open.back() + 1, "is not closed");
}

std::string describe_value(const TomlValue& value) {
  switch (value.kind) {
    case TomlKind::string:
      return "string " + quote_text(value.text.text);
    case TomlKind::number:
      return "number " + quote_text(value.text.text);
    case TomlKind::boolean:
      return value.boolean ? "`true`" : "`false`";
    case TomlKind::array:
      return "list";
    case TomlKind::table:
      return "table";
    case TomlKind::other:
      break;
  }
  return quote_text(value.text.text);
}

/// Reports E113 at the first invisible character. Tabs and line ends count as visible.
void report_hidden_character(const DecodedText& text, FileReadState& reading) {
  for (std::size_t i = 0; i < text.text.size();) {
    const CodePoint point = code_point_at(text.text, i);
    const bool is_blank = std::string_view("\t\n\r").find(text.text[i]) != std::string_view::npos;
    if (is_hidden(point.value) && !is_blank) {
      reading.report(Code::E113, text.span(i, i + point.bytes),
                     fmt::format("{} is invisible in a text", code_point_name(point.value)));
      return;
    }
    i += point.bytes;
  }
}

/// Reports E113 for a text that begins with `::`, because a CI runner executes log lines with this
/// prefix as commands.
void report_ci_command(const DecodedText& text, FileReadState& reading) {
  constexpr std::string_view command_prefix = "::";
  const std::size_t begin = text.text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos || !text.text.substr(begin).starts_with(command_prefix)) return;
  reading.report(Code::E113, text.span(begin, begin + command_prefix.size()),
                 "GitHub reads a text that begins with `::` as a command");
}

/// Reads a number without quotes, with its sign, into `result`.
void read_number(const TomlValue& value, ValueSyntax& result, FileReadState& reading) {
  const std::string& text = value.text.text;
  const bool negative = text[0] == '-';
  const DecimalParts parts = decimal_parts(text);
  result.expression.span = result.expression.token = value.span;
  if (std::optional<ExceededLimit> hit = find_exceeded_limit(parts, reading.limits)) {
    reading.report(hit->code, value.span, std::move(hit->message), std::move(hit->hint));
    return;
  }
  const cln::cl_RA magnitude = decimal_value(parts);
  result.expression.value = negative ? cln::cl_RA(-magnitude) : magnitude;
}

/// True if the whole text is the name: `q[i]`, not `(q)` or ` q`.
bool is_whole_name(const ExpressionSyntax& tree, const DecodedText& text) {
  return tree.kind == SyntaxKind::name && tree.token.begin == text.content_span.begin &&
         tree.span.end == text.content_span.end;
}

/// True if the error of the parser is clearer than "not a name": the error is about a non-ASCII
/// letter, or the text has an index.
bool has_clearer_error(const Result<ExpressionSyntax>& read, const DecodedText& text) {
  if (read || read.diagnostics.empty()) return false;
  return read.diagnostics.front().code == Code::E307 || text.text.find('[') != std::string::npos;
}

}  // namespace

void FileReadState::report(Code code, const Span& span, std::string message, std::string hint) {
  diagnostics.push_back({code, span, std::move(message), std::move(hint)});
}

void store_expression(Result<ExpressionSyntax> read, ExpressionSyntax& expression,
                      FileReadState& reading) {
  if (read) expression = std::move(*read);
  for (Diagnostic& problem : read.diagnostics) {
    reading.diagnostics.push_back(std::move(problem));
  }
}

ValueSyntax make_value(const TomlValue& value, ValueKind kind) {
  ValueSyntax result;
  result.kind = kind;
  result.span = value.kind == TomlKind::string ? value.text.content_span : value.span;
  result.text = value.text.text;
  return result;
}

void report_wrong_type(const TomlValue& value, std::string_view expected, FileReadState& reading) {
  if (value.kind == TomlKind::other) {
    reading.report(Code::E109, value.span, describe_value(value) + " is not a decimal number",
                   "numbers are written `12`, `0.5` or `1e-3`");
    return;
  }
  reading.report(Reason::wrong_value_type, value.span,
                 fmt::format("{} where {} is expected", describe_value(value), expected));
}

ValueSyntax read_expression_value(const TomlValue& value, FileReadState& reading) {
  ValueSyntax result = make_value(value, ValueKind::expression);
  if (value.kind == TomlKind::number) {
    read_number(value, result, reading);
  } else if (value.kind == TomlKind::string) {
    store_expression(read_expression(value.text, reading.limits), result.expression, reading);
  } else {
    report_wrong_type(value, "an expression (a number or a string)", reading);
  }
  return result;
}

ValueSyntax read_name(const TomlValue& value, FileReadState& reading) {
  ValueSyntax result = make_value(value, ValueKind::expression);
  if (value.kind != TomlKind::string) {
    report_wrong_type(value, "a name (a string)", reading);
    return result;
  }
  Result<ExpressionSyntax> read = read_expression(value.text, reading.limits);
  const bool is_valid_name = read && is_whole_name(*read, value.text);
  if (is_valid_name || has_clearer_error(read, value.text)) {
    store_expression(std::move(read), result.expression, reading);
  } else {
    reading.report(Code::E205, value.text.content_span,
                   quote_text(value.text.text) + " is not a name",
                   "names are letters, digits and underscores, starting with a letter");
  }
  return result;
}

ValueSyntax read_expression_list(const TomlValue& value, std::size_t count,
                                 FileReadState& reading) {
  ValueSyntax result = make_value(value, ValueKind::list);
  const bool wrong_size = count != 0 && value.items.size() != count;
  if (value.kind != TomlKind::array || wrong_size) {
    const std::string expected =
        count == 0 ? "a list of expressions" : fmt::format("a list of {} expressions", count);
    report_wrong_type(value, expected, reading);
    return result;
  }
  for (const TomlValue& item : value.items) {
    result.items.push_back(read_expression_value(item, reading));
  }
  return result;
}

ValueSyntax read_matrix_or_expression(const TomlValue& value, FileReadState& reading) {
  if (value.kind != TomlKind::array) return read_expression_value(value, reading);
  ValueSyntax result = make_value(value, ValueKind::list);
  for (const TomlValue& item : value.items) {
    result.items.push_back(item.kind == TomlKind::array ? read_expression_list(item, 0, reading)
                                                        : read_expression_value(item, reading));
  }
  return result;
}

namespace {

ValueSyntax read_turn(const TomlValue& value, FileReadState& reading) {
  ValueSyntax result = make_value(value, ValueKind::list);
  if (value.kind != TomlKind::array || value.items.size() != 2) {
    report_wrong_type(value, "[axis, angle]", reading);
    return result;
  }
  const TomlValue& axis = value.items[0];
  result.items.push_back(axis.kind == TomlKind::array ? read_expression_list(axis, 3, reading)
                                                      : read_text(axis, reading));
  result.items.push_back(read_expression_value(value.items[1], reading));
  return result;
}

}  // namespace

ValueSyntax read_turns(const TomlValue& value, FileReadState& reading) {
  ValueSyntax result = make_value(value, ValueKind::list);
  if (value.kind != TomlKind::array) {
    report_wrong_type(value, "a list of [axis, angle]", reading);
  }
  for (const TomlValue& item : value.items) result.items.push_back(read_turn(item, reading));
  return result;
}

ValueSyntax read_text(const TomlValue& value, FileReadState& reading) {
  if (value.kind != TomlKind::string) report_wrong_type(value, "a string", reading);
  report_hidden_character(value.text, reading);
  report_ci_command(value.text, reading);
  ValueSyntax result = make_value(value, ValueKind::text);
  result.text = collapse_blanks(result.text);
  return result;
}

ValueSyntax read_latex_symbol(const TomlValue& value, FileReadState& reading) {
  ValueSyntax result = read_text(value, reading);
  if (value.kind != TomlKind::string) return result;
  if (const std::optional<LatexMistake> mistake = find_latex_mistake(value.text.text)) {
    reading.report(Code::E114, value.text.span(mistake->begin, mistake->end), mistake->message,
                   "a symbol is letters, digits, `_`, `^`, `{ }` and commands such as `\\theta`, "
                   "`\\dot` and `\\mathrm`");
  }
  return result;
}

ValueSyntax read_boolean(const TomlValue& value, FileReadState& reading) {
  ValueSyntax result = make_value(value, ValueKind::boolean);
  result.boolean = value.boolean;
  if (value.kind != TomlKind::boolean) report_wrong_type(value, "`true` or `false`", reading);
  return result;
}

ValueSyntax read_integer(const TomlValue& value, FileReadState& reading) {
  ValueSyntax result = make_value(value, ValueKind::expression);
  if (value.kind == TomlKind::number) read_number(value, result, reading);
  const bool whole = cln:: instanceof (result.expression.value, cln::cl_I_ring);
  if (value.kind != TomlKind::number || !whole) report_wrong_type(value, "an integer", reading);
  return result;
}

}  // namespace elgen
