// renamed: a parsed tree with other names for the same things.
#pragma once

#include "elgen/diff.hpp"

namespace elgen {

/// The name in the newer version; an element has the name of its array: "l[2]", an inertial
/// parameter that of its owner: "hand.m".
[[nodiscard]] std::string renamed(const std::string& name, const Renames& renames);

/// In expressions, in keys that declare or refer, and in the keys of tables whose keys are names.
/// Texts stay as they are written, spans point where they did.
[[nodiscard]] FileSyntax renamed(FileSyntax file, const Renames& renames);

/// The prefix of a file's tables in the key table: a scene has rows of its own.
[[nodiscard]] std::string_view table_prefix(const FileSyntax& file);

/// Whether the user chooses the keys of a table, which is called as in the key table.
[[nodiscard]] bool has_names_for_keys(std::string_view table);

}  // namespace elgen
