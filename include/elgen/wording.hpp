// Wording: how messages show text of the user, count things and suggest names.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/source_text.hpp"

namespace elgen {

/// User text in back-ticks, on one line: blanks and line ends become one space, characters that are
/// not seen their names, and what is longer than 60 characters is cut.
[[nodiscard]] std::string in_backticks(std::string_view text);

/// The source text of a span in back-ticks.
[[nodiscard]] std::string in_backticks(const Span& span);

/// Blanks and line ends become one space; those at both ends go.
[[nodiscard]] std::string one_line(std::string_view text);

/// A path as messages print it: characters that are not seen, and line ends, are written \x0a.
[[nodiscard]] std::string shown_path(std::string_view path);

/// "1 component", "3 components"
[[nodiscard]] std::string counted(std::size_t count, std::string_view noun);

/// "did you mean `m`?", or nothing where no candidate is near.
[[nodiscard]] std::string suggestion(std::string_view word,
                                     const std::vector<std::string>& candidates);

}  // namespace elgen
