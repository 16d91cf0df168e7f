// The expression parser: decoded text to a tree; every node has its span in the file.
#pragma once

#include "elgen/syntax.hpp"
#include "parse/decoded_text.hpp"

namespace elgen {

/// Largest recursion depth, even if Limits allows more (about 1 KiB of stack per level).
inline constexpr std::uint64_t max_expression_depth = 1000;

/// Parses bytes [begin, end) of `text`. At most one error: E3xx, E902, E903, E904.
[[nodiscard]] Result<ExpressionSyntax> read_expression(const DecodedText& text, std::size_t begin,
                                                       std::size_t end, const Limits& limits);

[[nodiscard]] Result<ExpressionSyntax> read_expression(const DecodedText& text,
                                                       const Limits& limits);

}  // namespace elgen
