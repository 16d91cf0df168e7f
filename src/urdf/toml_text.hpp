// TOML as a person would align it.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace elgen::urdf {

/// In quotes, with what TOML escapes.
[[nodiscard]] std::string toml_string(std::string_view text);

/// The digits of a number; in quotes where TOML would not hold so wide an integer.
[[nodiscard]] std::string toml_number(std::string_view digits);

[[nodiscard]] std::string toml_list(const std::vector<std::string>& values);

/// One line, whatever a name of the file contains.
[[nodiscard]] std::string comment(std::string_view text);

/// `[[header]]` and its keys, their equals signs in one column.
class Table {
 public:
  explicit Table(std::string header) : header_(std::move(header)) {}

  void add(std::string key, const std::string& value) {
    rows_.push_back({std::move(key), " = " + value});
  }
  [[nodiscard]] std::string text() const;

 private:
  std::string header_;
  std::vector<std::vector<std::string>> rows_ = {};
};

}  // namespace elgen::urdf
