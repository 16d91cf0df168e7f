// toml_text: TOML with aligned columns.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text_table.hpp"

namespace elgen {

/// Rows of cells, each column as wide as its widest cell. The last cell of a row is not padded.
[[nodiscard]] std::vector<std::string> align_columns(const TextRows& rows);

/// A quoted TOML string with its escapes; hidden characters are replaced by their names.
[[nodiscard]] std::string toml_string(std::string_view text);

/// The digits of a number, quoted if the number is an integer too wide for TOML.
[[nodiscard]] std::string toml_number(std::string_view digits);

/// `key` without quotes if TOML allows a bare key, else quoted.
[[nodiscard]] std::string toml_key(std::string_view key);

/// "[1, 2]"
[[nodiscard]] std::string toml_list(const std::vector<std::string>& values);

/// "{ a = 1, b = 2 }" from the entries "a = 1" and "b = 2".
[[nodiscard]] std::string toml_inline_table(const std::vector<std::string>& entries);

/// The text as a TOML comment on one line.
[[nodiscard]] std::string toml_comment(std::string_view text);

/// `[[header]]` and its keys, with aligned equals signs.
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
