// file_schema: the key table for editors, as JSON Schema: TOML files are checked as JSON of the
// same keys.
#pragma once

#include <string>

#include "parse/entry_reader.hpp"

namespace elgen {

/// What the reader takes satisfies it. What it cannot say, such as the grammar of expressions,
/// which keys exclude each other and what names refer to, is left to elgen.
[[nodiscard]] std::string file_schema(FileKind kind);

}  // namespace elgen
