// names_model, declares_model: one look at the top-level keys.
#include "parse/names_model.hpp"

#include "parse/toml_document.hpp"

namespace elgen {

namespace {

/// What stands at the top-level key `model`.
std::optional<TomlKind> kind_of_model(const SourceText& source) {
  const Result<TomlValue> root = read_toml(source);
  if (!root) return std::nullopt;
  const TomlEntry* const model = find_entry(root->entries, "model");
  return model == nullptr ? std::nullopt : std::optional(model->value.kind);
}

}  // namespace

bool names_model(const SourceText& source) { return kind_of_model(source) == TomlKind::string; }

bool declares_model(const SourceText& source) { return kind_of_model(source) == TomlKind::table; }

}  // namespace elgen
