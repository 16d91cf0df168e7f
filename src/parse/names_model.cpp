// named_model, declares_model: one look at the top-level keys.
#include "parse/names_model.hpp"

#include "parse/toml_document.hpp"

namespace elgen {

namespace {

/// Where the top-level key `model` has a value of this kind.
std::optional<Span> model_of_kind(const SourceText& source, TomlKind kind) {
  const Result<TomlValue> root = read_toml(source);
  if (!root) return std::nullopt;
  const TomlEntry* const model = find_entry(root->entries, "model");
  const bool is_found = model != nullptr && model->value.kind == kind;
  return is_found ? std::optional(model->value.span) : std::nullopt;
}

}  // namespace

std::optional<Span> named_model(const SourceText& source) {
  return model_of_kind(source, TomlKind::string);
}

bool declares_model(const SourceText& source) {
  return model_of_kind(source, TomlKind::table).has_value();
}

}  // namespace elgen
