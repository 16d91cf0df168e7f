// layout: long expressions, lists and comments -> lines of at most `line_width` columns.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace elgen {

inline constexpr std::size_t line_width = 100;

/// How a text is broken into lines. The first line may have `first_width` columns. All other lines
/// begin with `indent`; all lines except the last end with `line_end`.
struct Wrapping {
  std::size_t first_width = line_width;
  std::string indent = {};
  std::string_view line_end = {};
};

/// Breaks an expression inside as few brackets as possible: before an operator, which begins the
/// next line, or after a comma.
///
///     a*b + sin(c + d)*e   ->   a*b
///                               + sin(c + d)*e
[[nodiscard]] std::vector<std::string> wrap_expression(std::string_view text,
                                                       const Wrapping& wrapping);

/// "  target = value;\n", wrapped by the rule of wrap_expression().
[[nodiscard]] std::string assignment(const std::string& target, const std::string& value);

[[nodiscard]] std::vector<std::string> wrap_words(std::string_view text, const Wrapping& wrapping);

/// User text on one line for a `//` comment, with invisible characters shown as text. If the text
/// is later broken at a space, no line ends in a backslash, which would continue the comment on the
/// next line of code.
[[nodiscard]] std::string comment_text(std::string_view text);

/// User text as a string literal with its quotes; by default a literal of C++.
[[nodiscard]] std::string string_literal(std::string_view text, char quote = '"',
                                         char escape = '\\');

/// A member of a struct: "Scalar m = 1;" and its documentation.
struct Member {
  std::string declaration;
  std::string doc;
};

/// The marks that begin documentation: `behind` after a declaration, `above` on a line above it.
struct CommentMarks {
  std::string_view behind = "///< ";
  std::string_view above = "/// ";
};

/// Declarations with documentation in an aligned column, or above the declaration if the line would
/// be too long.
[[nodiscard]] std::vector<std::string> member_doc_lines(const std::vector<Member>& members,
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
