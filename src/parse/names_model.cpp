// names_model: one look at the top-level keys.
#include "parse/names_model.hpp"

#include <algorithm>

#include "parse/toml_document.hpp"

namespace elgen {

bool names_model(const SourceText& source) {
  const Result<TomlValue> root = read_toml(source);
  if (!root) return false;
  return std::any_of(root->entries.begin(), root->entries.end(), [](const TomlEntry& entry) {
    return entry.key == "model" && entry.value.kind == TomlKind::string;
  });
}

}  // namespace elgen
