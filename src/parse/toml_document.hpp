// TomlValue: a TOML file as our own tree, in file order; every key and value has its exact span.
//
// toml++ checks the syntax and finds the tokens. Numbers and strings are re-read from the file, so
// that numbers are exact and every character of a string has its position. Only toml_document.cpp
// includes toml++.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "parse/decoded_text.hpp"

namespace elgen {

enum class TomlKind : std::uint8_t {
  string,
  number,  ///< a decimal, exactly as written
  other,   ///< inf, nan, hexadecimal, octal and binary numbers, dates and times
  boolean,
  array,
  table,
};

struct TomlEntry;

struct TomlValue {
  TomlKind kind = TomlKind::table;
  Span span = {};         ///< the token with its quotes; for a table, its header
  DecodedText text = {};  ///< decoded value of a string; text of a number in the file
  bool boolean = false;
  std::vector<TomlValue> items = {};
  std::vector<TomlEntry> entries;  ///< in file order
};

struct TomlEntry {
  std::string key = {};
  Span key_span = {};  ///< with the quotes of the key
  TomlValue value = {};
};

/// The entry with the key `key`; null if no entry has this key.
[[nodiscard]] const TomlEntry* find_entry(const std::vector<TomlEntry>& entries,
                                          std::string_view key);

/// The root table. E101: malformed TOML (only one error); E109: a number outside TOML's range.
[[nodiscard]] Result<TomlValue> read_toml(const SourceText& source);

}  // namespace elgen
