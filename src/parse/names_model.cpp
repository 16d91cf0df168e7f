// names_model: one look at the top-level keys.
#include "parse/names_model.hpp"

#include "parse/toml_document.hpp"

namespace elgen {

bool names_model(const SourceText& source) {
  const Result<TomlValue> root = read_toml(source);
  if (!root) return false;
  const TomlEntry* const model = find_entry(root->entries, "model");
  return model != nullptr && model->value.kind == TomlKind::string;
}

}  // namespace elgen
