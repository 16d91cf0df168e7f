// renamed: a parsed tree with other names for the same things.
#pragma once

#include "elgen/diff.hpp"

namespace elgen {

/// In expressions, in keys that declare or refer, and in the keys of tables whose keys are names.
/// Texts stay as they are written, spans point where they did.
[[nodiscard]] FileSyntax renamed(FileSyntax file, const Renames& renames);

}  // namespace elgen
