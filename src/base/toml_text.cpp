// toml_text: quoting, and columns padded to their widest cell.
#include "base/toml_text.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "base/ascii.hpp"
#include "base/utf8.hpp"

namespace elgen {

namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

}  // namespace

std::vector<std::string> align_columns(const TextRows& rows) {
  return table_lines(rows, {{false, 0, 0}});
}

std::string toml_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : visible_text(text)) {
    if (is_control(c)) {
      quoted += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    } else {
      if (c == '"' || c == '\\') quoted += '\\';
      quoted += c;
    }
  }
  return quoted + "\"";
}

std::string toml_number(std::string_view digits) {
  constexpr std::size_t widest_integer = 18;
  const bool is_integer = digits.find_first_of(".e") == std::string_view::npos;
  return is_integer && digits.size() > widest_integer ? toml_string(digits) : std::string(digits);
}

std::string toml_key(std::string_view key) {
  const bool is_bare = !key.empty() && std::ranges::all_of(key, is_word_character);
  return is_bare ? std::string(key) : toml_string(key);
}

std::string toml_list(const std::vector<std::string>& values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}

std::string toml_inline_table(const std::vector<std::string>& entries) {
  return fmt::format("{{ {} }}", fmt::join(entries, ", "));
}

std::string toml_comment(std::string_view text) {
  std::string line = visible_text(text);
  std::replace_if(line.begin(), line.end(), is_control, '?');
  return line.empty() ? "#\n" : "# " + line + "\n";
}

std::string TomlTable::text() const {
  return fmt::format("{}\n{}\n", header_, fmt::join(align_columns(rows_), "\n"));
}

}  // namespace elgen
