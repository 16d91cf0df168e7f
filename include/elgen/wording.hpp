// Wording of messages: quotations of user text, counts with nouns, and suggestions of names.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/source_text.hpp"

namespace elgen {

/// Text of the user in back-ticks, on one line: each run of blanks and line ends becomes one space,
/// invisible characters become their names, and text longer than 60 characters is cut.
[[nodiscard]] std::string quote_text(std::string_view text);

/// The source text of a span in back-ticks.
[[nodiscard]] std::string in_backticks(const Span& span);

/// Replaces each run of blanks and line ends by one space, and removes the spaces at both ends.
[[nodiscard]] std::string collapse_blanks(std::string_view text);

/// `path` for messages: bytes of invisible characters and line ends are written as in \x0a.
[[nodiscard]] std::string printable_path(std::string_view path);

/// The text broken at blanks into lines of at most `width` bytes. All lines except the first start
/// with `indent`.
[[nodiscard]] std::string break_lines(std::string_view text, std::size_t width,
                                      std::string_view indent);

/// `count` and `noun`, with an s unless `count` is 1: "1 component", "3 components".
[[nodiscard]] std::string count_text(std::size_t count, std::string_view noun);

/// "did you mean `m`?" for the nearest candidate; `otherwise` if no candidate is close to `word`.
[[nodiscard]] std::string suggestion(std::string_view word,
                                     const std::vector<std::string>& candidates,
                                     const std::string& otherwise = {});

/// The column `word` of a table, as strings: column_words(entry_table(), &EntryRow::entry).
template <class Rows, class Word>
[[nodiscard]] std::vector<std::string> column_words(const Rows& rows, const Word& word) {
  std::vector<std::string> words;
  for (const auto& row : rows) words.emplace_back(std::invoke(word, row));
  return words;
}

}  // namespace elgen
