// file_schema: the key table for editors, as JSON Schema: TOML files are checked as JSON of the
// same keys.
#pragma once

#include <string>

#include "parse/entry_reader.hpp"

namespace elgen {

/// Every file that the reader takes satisfies it. Rules beyond a schema, such as the grammar of
/// expressions, which keys exclude each other and what names refer to, are left to elgen.
[[nodiscard]] std::string file_schema(FileKind kind);

}  // namespace elgen
