// Expressions inside the text of command-line options: the VALUE of `--fix NAME=VALUE`.
#pragma once

#include <optional>

#include "check/names/report.hpp"
#include "elgen/limits.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// Parses the bytes of `home` as one expression; its spans and errors point into the source of
/// `home`.
[[nodiscard]] std::optional<ExpressionSyntax> parse_part(const Span& home, const Limits& limits,
                                                         Report& report);

}  // namespace elgen
