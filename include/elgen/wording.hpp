// Wording: how messages show text of the user, count things and suggest names.
#pragma once

#include <cstddef>
#include <functional>
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

/// "did you mean `m`?"; `otherwise` where no candidate is near.
[[nodiscard]] std::string suggestion(std::string_view word,
                                     const std::vector<std::string>& candidates,
                                     const std::string& otherwise = {});

/// A word of every row, such as its name: words_in(step_methods, &StepMethodRow::name).
template <class Rows, class Word>
[[nodiscard]] std::vector<std::string> words_in(const Rows& rows, const Word& word) {
  std::vector<std::string> words;
  for (const auto& row : rows) words.emplace_back(std::invoke(word, row));
  return words;
}

}  // namespace elgen
