// renamed: applies renames to names and to parsed files.
#pragma once

#include "elgen/diff.hpp"

namespace elgen {

/// The name in the newer version. An element gets the new name of its array: "l[2]"; an inertial
/// parameter gets the new name of its owner: "hand.m".
[[nodiscard]] std::string apply_renames(const std::string& name, const Renames& renames);

/// Renames all names: in expressions, in keys that declare or refer to names, and in tables whose
/// keys are names. Texts and spans of other values do not change.
[[nodiscard]] FileSyntax apply_renames(FileSyntax file, const Renames& renames);

/// The prefix of a file's tables in the key table: "scene." for scenes, "" for models.
[[nodiscard]] std::string_view table_prefix(const FileSyntax& file);

/// True if users choose the keys of this table.
[[nodiscard]] bool has_names_for_keys(std::string_view table);

}  // namespace elgen
