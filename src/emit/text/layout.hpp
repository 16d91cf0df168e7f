// layout: long expressions, lists and comments -> lines of at most `line_width` columns.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace elgen {

inline constexpr std::size_t line_width = 100;

/// How a text is broken into lines: the first line may have `first` columns, the other lines begin
/// with `indent`, and all except the last end in `end`.
struct Wrapping {
  std::size_t first = line_width;
  std::string indent = {};
  std::string_view end = {};
};

/// Breaks an expression before operators and after commas, at the outermost bracket that fits:
///
///     a*b + sin(c + d)*e   ->   a*b +       (no: operators start a line)
///                          ->   a*b
///                               + sin(c + d)*e
[[nodiscard]] std::vector<std::string> wrap_expression(std::string_view text,
                                                       const Wrapping& wrapping);

/// "  target = value;\n", wrapped in the same way.
[[nodiscard]] std::string assignment(const std::string& target, const std::string& value);

[[nodiscard]] std::vector<std::string> wrap_words(std::string_view text, const Wrapping& wrapping);

/// User text on one line for a `//` comment, with invisible characters shown as text. If a line is
/// broken at a space, no piece of it continues the comment on the next line of code.
[[nodiscard]] std::string comment_text(std::string_view text);

/// User text as a literal of C++ with its quotes, or of a language with other quotes.
[[nodiscard]] std::string string_literal(std::string_view text, char quote = '"',
                                         char escape = '\\');

/// A member of a struct: "Scalar m = 1;" and its documentation.
struct Member {
  std::string declaration;
  std::string doc;
};

/// The marks of documentation after a declaration, and on a line above it.
struct CommentMarks {
  std::string_view behind = "///< ";
  std::string_view above = "/// ";
};

/// Declarations with documentation in an aligned column, or above the declaration if the line would
/// be too long.
[[nodiscard]] std::vector<std::string> documented_members(const std::vector<Member>& members,
                                                          const CommentMarks& marks = {});

/// A declaration with line breaks, from its start and its arguments. `start` ends before the
/// bracket; `end` (" noexcept") follows the closing bracket.
///
///     [[nodiscard]] Forces<Scalar> bias(const Parameters<Scalar>& p, const Coordinates<Scalar>& q,
///                                       const Velocities<Scalar>& v) noexcept
[[nodiscard]] std::string signature(const std::string& start,
                                    const std::vector<std::string>& arguments,
                                    const std::string& end);

}  // namespace elgen
