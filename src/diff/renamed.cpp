// renamed: the key table determines which texts are names.
#include "diff/renamed.hpp"

#include <algorithm>
#include <string_view>

namespace elgen {
namespace {

void rename(std::string& name, const Renames& renames) { name = apply_renames(name, renames); }

void rename(ExpressionSyntax& expression, const Renames& renames) {
  if (expression.kind == SyntaxKind::name) rename(expression.text, renames);
  for (ExpressionSyntax& operand : expression.operands) rename(operand, renames);
}

void rename(ValueSyntax& value, const std::string& table, const Renames& renames);

/// True if the table has a row with this key.
bool has_key_row(std::string_view table, std::string_view key) {
  return std::ranges::any_of(
      key_table(), [&](const KeyRow& row) { return row.entry == table && row.key == key; });
}

void rename(std::vector<KeySyntax>& keys, const std::string& table, const Renames& renames) {
  const bool has_names = has_names_for_keys(table);
  for (KeySyntax& key : keys) {
    const bool is_name = has_names && !has_key_row(table, key.key);
    if (is_name) rename(key.key, renames);
    rename(key.value, table + "." + (is_name ? "*" : key.key), renames);
  }
}

/// Renames all names in `value`. `table`: the path of `value` in the key table, needed for tables.
void rename(ValueSyntax& value, const std::string& table, const Renames& renames) {
  // If the value is a single name, the text is renamed, too, because the text identifies entries.
  const bool is_name = value.kind == ValueKind::expression &&
                       value.expression.kind == SyntaxKind::name &&
                       value.expression.operands.empty();
  if (is_name) rename(value.text, renames);
  rename(value.expression, renames);
  for (ValueSyntax& item : value.items) rename(item, table, renames);
  rename(value.entries, table, renames);
}

}  // namespace

std::string apply_renames(const std::string& name, const Renames& renames) {
  const std::size_t inner = name.find('(') + 1;
  if (inner > 0 && name.back() == ')') {  // dot(x), as in ranges and states
    const std::string argument = name.substr(inner, name.size() - 1 - inner);
    return name.substr(0, inner) + apply_renames(argument, renames) + ")";
  }
  const std::string_view armature = "armature.";
  if (name.starts_with(armature)) {  // an inertial parameter of an armature
    return std::string(armature) + apply_renames(name.substr(armature.size()), renames);
  }
  const std::size_t dot = std::min(name.find('.'), name.size());
  if (dot < name.size()) return apply_renames(name.substr(0, dot), renames) + name.substr(dot);
  const std::size_t stem = std::min(name.find('['), name.size());
  const auto found = renames.find(name.substr(0, stem));
  return found == renames.end() ? name : found->second + name.substr(stem);
}

bool has_names_for_keys(std::string_view table) { return has_key_row(table, "*"); }

std::string_view table_prefix(const FileSyntax& file) {
  const bool names_model = !file.entries.empty() && file.entries.front().name.empty() &&
                           file.entries.front().find("model") != nullptr;
  return names_model ? "scene." : "";
}

FileSyntax apply_renames(FileSyntax file, const Renames& renames) {
  const std::string prefix(table_prefix(file));
  for (EntrySyntax& entry : file.entries)
    rename(entry.keys, std::string(entry_of_keys(prefix + entry.name)), renames);
  return file;
}

}  // namespace elgen
