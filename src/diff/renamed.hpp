// renamed: applies renames to names and to parsed trees.
#pragma once

#include "elgen/diff.hpp"

namespace elgen {

/// The name in the newer version. An element is renamed with its array: "l[2]"; an inertial
/// parameter with its owner: "hand.m".
[[nodiscard]] std::string renamed(const std::string& name, const Renames& renames);

/// Renames in expressions, in keys that declare or refer, and in tables whose keys are names. Texts
/// and spans do not change.
[[nodiscard]] FileSyntax renamed(FileSyntax file, const Renames& renames);

/// The prefix of a file's tables in the key table: "scene." for scenes, "" for models.
[[nodiscard]] std::string_view table_prefix(const FileSyntax& file);

/// True if users choose the keys of this table of the key table.
[[nodiscard]] bool has_names_for_keys(std::string_view table);

}  // namespace elgen
