// layout: long expressions, lists and comments -> lines of at most `line_width` columns.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace elgen {

inline constexpr std::size_t line_width = 100;

/// How a text is broken: the first line may be `first` columns long, the others begin with
/// `indent`; all but the last end in `end`.
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

/// "  target = value;\n", broken alike.
[[nodiscard]] std::string assignment(const std::string& target, const std::string& value);

/// Breaks prose at spaces.
[[nodiscard]] std::vector<std::string> wrap_words(std::string_view text, const Wrapping& wrapping);

/// User text as part of a `//` comment: one line of what is seen. Broken at any space, no piece of
/// it continues on the next line of code.
[[nodiscard]] std::string comment_text(std::string_view text);

/// User text as a literal of C++, quotes included, or of a language with other ones.
[[nodiscard]] std::string string_literal(std::string_view text, char quote = '"',
                                         char escape = '\\');

/// A struct's member: "Scalar m = 1;" and what it is.
struct Member {
  std::string declaration;
  std::string doc;
};

/// Before documentation behind a declaration, and on a line above it.
struct CommentMarks {
  std::string_view behind = "///< ";
  std::string_view above = "/// ";
};

/// Declarations with their documentation behind them in one column, or above where a line is too
/// short.
[[nodiscard]] std::vector<std::string> documented_members(const std::vector<Member>& members,
                                                          const CommentMarks& marks = {});

/// The start of a declaration and its arguments -> the declaration, with line breaks; `start` ends
/// before the bracket, `end` (" noexcept") follows the closing one.
///
///     [[nodiscard]] Forces<Scalar> bias(const Parameters<Scalar>& p, const Coordinates<Scalar>& q,
///                                       const Velocities<Scalar>& v) noexcept
[[nodiscard]] std::string signature(const std::string& start,
                                    const std::vector<std::string>& arguments,
                                    const std::string& end);

}  // namespace elgen
