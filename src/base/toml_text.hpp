// TOML as a person would align it.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text_table.hpp"

namespace elgen {

/// Rows of cells, each column as wide as its widest cell; the last cell of a row is as wide as it
/// is.
[[nodiscard]] std::vector<std::string> aligned(const TextRows& rows);

/// In quotes, with what TOML escapes; hidden characters as their names.
[[nodiscard]] std::string toml_string(std::string_view text);

/// The digits of a number; in quotes where TOML would not hold so wide an integer.
[[nodiscard]] std::string toml_number(std::string_view digits);

/// As it is where TOML takes it bare, else in quotes.
[[nodiscard]] std::string toml_key(std::string_view key);

/// "[1, 2]"
[[nodiscard]] std::string toml_list(const std::vector<std::string>& values);

/// Entries "a = 1" become "{ a = 1, b = 2 }".
[[nodiscard]] std::string toml_inline_table(const std::vector<std::string>& entries);

/// One line, whatever the text contains.
[[nodiscard]] std::string toml_comment(std::string_view text);

/// `[[header]]` and its keys, their equals signs in one column.
class TomlTable {
 public:
  explicit TomlTable(std::string header) : header_(std::move(header)) {}

  void add(std::string key, const std::string& value) {
    rows_.push_back({std::move(key), " = " + value});
  }
  [[nodiscard]] std::string text() const;

 private:
  std::string header_;
  std::vector<std::vector<std::string>> rows_ = {};
};

}  // namespace elgen
