// Entries: the tables of a file, and their keys, checked against the key table.
#pragma once

#include "parse/value_reader.hpp"

namespace elgen {

/// The rows of the entry table for one kind of file. Entries of scenes have no prefix "scene.".
[[nodiscard]] std::vector<EntryRow> entry_rows_of(FileKind kind);

/// The name of the row's entry in the key table: "scene.outputs"; "frame" in models and scenes.
[[nodiscard]] std::string qualified_entry_name(FileKind kind, const EntryRow& row);

/// Top-level keys and entries in file order. Reports E103–E109 and the errors of the values to
/// `reading`.
[[nodiscard]] std::vector<EntrySyntax> read_entries(const TomlValue& root, FileKind kind,
                                                    FileReadState& reading);

/// A table whose keys are the rows of `entry`. Messages call the table `label`: "`[[coordinate]]`".
/// A missing key is reported at `header`.
struct TableContext {
  std::string entry;
  std::string label;
  Span header;
};

/// The hint on a word of other programs, as a key of `entry` or, for "", as an entry; else "".
[[nodiscard]] std::string foreign_word_hint(std::string_view entry, std::string_view word);

[[nodiscard]] std::vector<KeySyntax> read_keys(const std::vector<TomlEntry>& entries,
                                               const TableContext& table, FileReadState& reading);

}  // namespace elgen
