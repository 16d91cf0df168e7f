// Entries: the tables of a file, their keys checked against the key table.
#pragma once

#include "parse/value_reader.hpp"

namespace elgen {

/// The rows of one kind of file, by the names the file uses.
[[nodiscard]] std::vector<EntryRow> entry_rows_of(FileKind kind);

/// The name of the entry of such a row in the key table: "scene.outputs".
[[nodiscard]] std::string table_entry(FileKind kind, const EntryRow& row);

/// Top-level keys and entries in file order. E103–E109 and what the values report, into `reading`.
[[nodiscard]] std::vector<EntrySyntax> read_entries(const TomlValue& root, FileKind kind,
                                                    FileReading& reading);

/// A table whose keys are the rows of `entry`. `label` is what messages call it:
/// "`[[coordinate]]`"; `header` is where a missing key is reported.
struct TableContext {
  std::string entry;
  std::string label;
  Span header;
};

[[nodiscard]] std::vector<KeySyntax> read_keys(const std::vector<TomlEntry>& entries,
                                               const TableContext& table, FileReading& reading);

}  // namespace elgen
