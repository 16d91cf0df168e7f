// Files and expressions to syntax trees: checks size and encoding, parses TOML, then checks the
// format and the entries.
#include "elgen/syntax.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/utf8.hpp"
#include "elgen/wording.hpp"
#include "parse/entry_reader.hpp"
#include "parse/expression_parser.hpp"
#include "parse/toml_document.hpp"

namespace elgen {

namespace {

Span whole_span(const SourceText& source) {
  return {&source, 0, static_cast<std::uint32_t>(source.text.size())};
}

std::optional<Diagnostic> encoding_error(const Span& text) {
  const auto invalid = find_invalid_utf8(covered_text(text));
  if (!invalid) return std::nullopt;
  const std::uint32_t begin = text.begin + static_cast<std::uint32_t>(*invalid);
  const auto byte = static_cast<unsigned char>(text.source->text[begin]);
  return Diagnostic{Code::E110,
                    {text.source, begin, begin + 1},
                    fmt::format("byte 0x{:02X} is not UTF-8", byte),
                    "save the file as UTF-8"};
}

std::optional<Diagnostic> size_error(const SourceText& source, const Limits& limits) {
  if (source.text.size() <= limits.file_bytes) return std::nullopt;
  return Diagnostic{
      Code::E901,
      {&source, 0, 0},
      fmt::format("file has {} bytes, more than {}", source.text.size(), limits.file_bytes),
      "`--limit file_bytes=N` raises the limit"};
}

/// The error of a file whose `format` is not supported. No other error is reported then, because
/// other formats have other keys.
std::optional<Diagnostic> format_error(const TomlValue& root) {
  const TomlEntry* const entry = find_entry(root.entries, "format");
  if (entry == nullptr || entry->value.kind != TomlKind::number) {
    return std::nullopt;  // missing or of the wrong type: reported with the other keys
  }
  const std::string& text = entry->value.text.text;
  if (text == "1") return std::nullopt;
  return Diagnostic{Code::E102, entry->value.span, "format " + quote_text(text),
                    "this version reads `format = 1`"};
}

Result<FileSyntax> read_file(SourcePointer source, FileKind kind, const Limits& limits) {
  if (auto error = size_error(*source, limits)) return *std::move(error);
  if (auto error = encoding_error(whole_span(*source))) return *std::move(error);
  const Result<TomlValue> root = read_toml(*source);
  if (!root) return root.diagnostics;
  if (auto error = format_error(*root)) return *std::move(error);
  FileReadState reading{limits};
  std::vector<EntrySyntax> entries = read_entries(*root, kind, reading);
  sort_by_position(reading.diagnostics);
  if (has_errors(reading.diagnostics)) return std::move(reading.diagnostics);
  return FileSyntax{std::move(source), std::move(entries)};
}

const KeySyntax* find_key(const std::vector<KeySyntax>& keys, std::string_view key) {
  const auto found = std::ranges::find(keys, key, &KeySyntax::key);
  return found == keys.end() ? nullptr : &*found;
}

}  // namespace

const KeySyntax* EntrySyntax::find(std::string_view key) const { return find_key(keys, key); }

const KeySyntax* ValueSyntax::find(std::string_view key) const { return find_key(entries, key); }

const EntrySyntax* find_entry(const FileSyntax* file, std::string_view name) {
  if (file == nullptr) return nullptr;
  const auto found = std::ranges::find(file->entries, name, &EntrySyntax::name);
  return found == file->entries.end() ? nullptr : &*found;
}

const KeySyntax* find_key(const FileSyntax* file, std::string_view entry, std::string_view key) {
  const EntrySyntax* found = find_entry(file, entry);
  return found == nullptr ? nullptr : found->find(key);
}

const std::vector<KeySyntax>& entry_keys(const FileSyntax* file, std::string_view entry) {
  static const std::vector<KeySyntax> none;
  const EntrySyntax* found = find_entry(file, entry);
  return found == nullptr ? none : found->keys;
}

Result<FileSyntax> parse_model(SourcePointer source, const Limits& limits) {
  return read_file(std::move(source), FileKind::model, limits);
}

Result<FileSyntax> parse_scene(SourcePointer source, const Limits& limits) {
  return read_file(std::move(source), FileKind::scene, limits);
}

Result<ExpressionSyntax> parse_expression(const SourcePointer& source, const Limits& limits) {
  return parse_expression(whole_span(*source), limits);
}

Result<ExpressionSyntax> parse_expression(const Span& text, const Limits& limits) {
  if (auto error = encoding_error(text)) return *std::move(error);
  return read_expression(verbatim_text(text), limits);
}

}  // namespace elgen
