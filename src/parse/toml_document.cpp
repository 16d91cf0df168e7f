// TOML text to TomlValue: toml++ parses, every value is re-read at the place toml++ found it.
// toml++ keeps tables sorted by key; here entries come back into file order.
#include "parse/toml_document.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <utility>

#include "parse/toml_error.hpp"
#include "parse/toml_guard.hpp"
#include "parse/toml_positions.hpp"

namespace elgen {

namespace {

class DocumentBuilder {
 public:
  explicit DocumentBuilder(const SourceText& source) : source_(source), positions_(source) {}

  [[nodiscard]] TomlValue value(const toml::node& node) const;
  [[nodiscard]] std::uint32_t offset(const toml::source_position& position) const {
    return positions_.offset(position.line, position.column);
  }

 private:
  [[nodiscard]] Span span(const toml::source_region& region) const {
    return {&source_, offset(region.begin), offset(region.end)};
  }
  [[nodiscard]] std::vector<TomlEntry> entries(const toml::table& table) const;

  const SourceText& source_;
  TomlPositions positions_;
};

TomlValue DocumentBuilder::value(const toml::node& node) const {
  TomlValue result;
  result.span = span(node.source());
  if (node.is_string()) {
    result.kind = TomlKind::string;
    result.text = decode_string(result.span);
  } else if (const auto* boolean = node.as_boolean()) {
    result.kind = TomlKind::boolean;
    result.boolean = boolean->get();
  } else if (const auto* array = node.as_array()) {
    result.kind = TomlKind::array;
    for (const toml::node& item : *array) result.items.push_back(value(item));
  } else if (const auto* table = node.as_table()) {
    result.entries = entries(*table);
  } else {
    result.text = copied_text(result.span);
    const bool decimal = node.is_number() && is_decimal_token(result.text.text);
    result.kind = decimal ? TomlKind::number : TomlKind::other;
  }
  return result;
}

std::vector<TomlEntry> DocumentBuilder::entries(const toml::table& table) const {
  std::vector<TomlEntry> result;
  for (const auto& [key, node] : table) {
    result.push_back({std::string(key.str()), span(key.source()), value(node)});
  }
  std::sort(result.begin(), result.end(), [](const TomlEntry& a, const TomlEntry& b) {
    return a.key_span.begin < b.key_span.begin;
  });
  return result;
}

}  // namespace

const TomlEntry* find_entry(const std::vector<TomlEntry>& entries, std::string_view key) {
  const auto found = std::ranges::find(entries, key, &TomlEntry::key);
  return found == entries.end() ? nullptr : &*found;
}

Result<TomlValue> read_toml(const SourceText& source) {
  if (const auto endless = find_endless_key(source.text)) {
    const auto begin = static_cast<std::uint32_t>(*endless);
    return Diagnostic{Code::E101,
                      {&source, begin, begin + 1},
                      "key of more than " + std::to_string(most_key_parts) + " parts"};
  }
  const DocumentBuilder builder(source);
  try {
    return builder.value(toml::parse(source.text));
  } catch (const toml::parse_error& error) {
    return toml_error(source, builder.offset(error.source().begin), error.description());
  }
}

}  // namespace elgen
