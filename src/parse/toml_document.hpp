// TomlValue: a TOML file as a tree of its own, in file order, every piece with its exact place.
//
// toml++ checks the syntax and finds the tokens; numbers and strings are re-read from the file, so
// that numbers are exact and every character of a string knows where it stands. Only
// toml_document.cpp knows toml++.
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
  Span span = {};         ///< the token with its quotes; of a table its header
  DecodedText text = {};  ///< of a string; of a number as it stands
  bool boolean = false;
  std::vector<TomlValue> items = {};
  std::vector<TomlEntry> entries;  ///< in file order
};

struct TomlEntry {
  std::string key = {};
  Span key_span = {};  ///< with its quotes
  TomlValue value = {};
};

/// Null where no entry has this key.
[[nodiscard]] const TomlEntry* find_entry(const std::vector<TomlEntry>& entries,
                                          std::string_view key);

/// The root table. E101 malformed TOML (one error), E109 a number wider than TOML allows.
[[nodiscard]] Result<TomlValue> read_toml(const SourceText& source);

}  // namespace elgen
