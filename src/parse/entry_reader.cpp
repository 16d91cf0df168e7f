// Checks the tables of a file against the entry table: unknown and unsupported tables, `[x]`
// instead of `[[x]]`, and missing required tables.
#include "parse/entry_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "elgen/wording.hpp"

namespace elgen {

namespace {

/// The prefix of a scene's entries in the entry table and the key table: "scene.outputs".
constexpr std::string_view scene_prefix = "scene.";

bool is_list_of(TomlKind kind, const TomlValue& value) {
  const auto has_kind = [kind](const TomlValue& item) { return item.kind == kind; };
  return value.kind == TomlKind::array && !value.items.empty() &&
         std::ranges::all_of(value.items, has_kind);
}

/// The table with `key = true` for each key of the list.
TomlValue table_of_keys(const TomlValue& list) {
  TomlValue table{.kind = TomlKind::table, .span = list.span, .entries = {}};
  for (const TomlValue& item : list.items) {
    const TomlValue yes{
        .kind = TomlKind::boolean, .span = item.span, .boolean = true, .entries = {}};
    table.entries.push_back({item.text.text, item.span, yes});
  }
  return table;
}

/// The header of a table, or of the first table of an array.
const Span& header_span(const TomlValue& value) {
  return is_list_of(TomlKind::table, value) ? value.items.front().span : value.span;
}

class EntryReader {
 public:
  EntryReader(FileKind kind, FileReadState& reading)
      : kind_(kind), rows_(entry_rows_of(kind)), reading_(reading) {}

  std::vector<EntrySyntax> read(const TomlValue& root) {
    std::vector<TomlEntry> keys;
    for (const TomlEntry& entry : root.entries) {
      if (const EntryRow* row = find(entry.key)) {
        read_known_entry(*row, entry);
      } else if (has_tables(entry.value)) {
        report_unknown_entry(entry);
      } else {
        keys.push_back(entry);
      }
    }
    report_missing_entries(root);
    std::ranges::sort(entries_, [](const EntrySyntax& a, const EntrySyntax& b) {
      return a.span.begin < b.span.begin;
    });
    const Span start{root.span.source, 0, 0};
    const TableContext top{kind_ == FileKind::scene ? "scene" : "", "the file", start};
    entries_.insert(entries_.begin(), EntrySyntax{"", start, read_keys(keys, top, reading_)});
    return std::move(entries_);
  }

 private:
  [[nodiscard]] const EntryRow* find(std::string_view name) const {
    const auto row = std::ranges::find(rows_, name, &EntryRow::entry);
    return row == rows_.end() ? nullptr : &*row;
  }

  /// True if `value` is a table or an array of tables. No top-level key has such a value, so an
  /// entry that has it but no row is an unknown table, not an unknown key.
  [[nodiscard]] static bool has_tables(const TomlValue& value) {
    return value.kind == TomlKind::table || is_list_of(TomlKind::table, value);
  }

  void read_known_entry(const EntryRow& row, const TomlEntry& entry) {
    const TomlValue& value = entry.value;
    if (!row.supported) {
      reading_.report(Code::E108, header_span(value),
                      quote_text(header_text(row)) + " is not yet supported");
    } else if (row.repeated && is_list_of(TomlKind::table, value)) {
      for (const TomlValue& table : value.items) append_entry(row, table);
    } else if (!row.repeated && value.kind == TomlKind::table) {
      append_entry(row, value);
    } else if (row.may_be_list && is_list_of(TomlKind::string, value)) {
      append_entry(row, table_of_keys(value));
    } else {
      report_wrong_kind(row, entry);
    }
  }

  void report_wrong_kind(const EntryRow& row, const TomlEntry& entry) {
    if (!has_tables(entry.value)) {
      report_wrong_type(entry.value, row.repeated ? "an array of tables" : "a table", reading_);
      return;
    }
    EntryRow typed = row;
    typed.repeated = !row.repeated;
    reading_.report(Code::E107, header_span(entry.value),
                    quote_text(header_text(typed)) + " is the wrong kind of table",
                    "write " + quote_text(header_text(row)));
  }

  void report_unknown_entry(const TomlEntry& entry) {
    std::vector<std::string> candidates;
    for (const EntryRow& row : rows_) {
      if (row.supported) candidates.emplace_back(row.entry);
    }
    const EntryRow* row = find(nearest_word(entry.key, candidates));
    std::string hint = foreign_word_hint("", entry.key);
    if (hint.empty() && row != nullptr)
      hint = fmt::format("did you mean {}?", quote_text(header_text(*row)));
    reading_.report(Code::E106, header_span(entry.value), "unknown entry " + quote_text(entry.key),
                    std::move(hint));
  }

  void report_missing_entries(const TomlValue& root) {
    for (const EntryRow& row : rows_) {
      if (!row.required || find_entry(root.entries, row.entry) != nullptr) continue;
      reading_.report(Code::E105, {root.span.source, 0, 0},
                      "no " + quote_text(header_text(row)) + " in the file");
    }
  }

  void append_entry(const EntryRow& row, const TomlValue& table) {
    const TableContext context{qualified_entry_name(kind_, row), quote_text(header_text(row)),
                               table.span};
    entries_.push_back(
        {std::string(row.entry), table.span, read_keys(table.entries, context, reading_)});
  }

  FileKind kind_;
  std::vector<EntryRow> rows_;
  FileReadState& reading_;
  std::vector<EntrySyntax> entries_ = {};
};

}  // namespace

std::string_view entry_of_keys(std::string_view entry) {
  const bool is_entry = std::ranges::count(entry_table(), entry, &EntryRow::entry) > 0;
  const bool has_keys = std::ranges::count(key_table(), entry, &KeyRow::entry) > 0;
  return is_entry && !has_keys && entry.starts_with(scene_prefix)
             ? entry.substr(scene_prefix.size())
             : entry;
}

bool is_drawing_key(std::string_view entry, std::string_view key) {
  return std::ranges::any_of(key_table(), [&](const KeyRow& row) {
    return row.is_for_drawings && row.entry == entry && row.key == key;
  });
}

std::string foreign_word_hint(std::string_view entry, std::string_view word) {
  struct Row {
    std::string_view entry;
    std::string_view word;
    std::string_view hint;
  };
  static constexpr auto rows = std::to_array<Row>({
#define ELGEN_FOREIGN_WORD(...) {__VA_ARGS__},
#include "parse/foreign_words.def"
#undef ELGEN_FOREIGN_WORD
  });
  const auto* const found = std::ranges::find_if(
      rows, [&](const Row& row) { return row.entry == entry && row.word == word; });
  return found == rows.end() ? std::string() : std::string(found->hint);
}

std::vector<EntryRow> entry_rows_of(FileKind kind) {
  std::vector<EntryRow> result;
  for (EntryRow row : entry_table()) {
    const bool of_scene = row.entry.starts_with(scene_prefix);
    if (of_scene != (kind == FileKind::scene)) continue;
    if (of_scene) row.entry.remove_prefix(scene_prefix.size());
    result.push_back(row);
  }
  return result;
}

std::string qualified_entry_name(FileKind kind, const EntryRow& row) {
  return std::string(
      entry_of_keys(fmt::format("{}{}", kind == FileKind::scene ? scene_prefix : "", row.entry)));
}

std::vector<EntrySyntax> read_entries(const TomlValue& root, FileKind kind,
                                      FileReadState& reading) {
  return EntryReader(kind, reading).read(root);
}

namespace {

/// The span of the value of the top-level key `model` if the value is of kind `kind`.
std::optional<Span> find_model_key(const SourceText& source, TomlKind kind) {
  const Result<TomlValue> root = read_toml(source);
  if (!root) return std::nullopt;
  const TomlEntry* const model = find_entry(root->entries, "model");
  const bool is_found = model != nullptr && model->value.kind == kind;
  return is_found ? std::optional(model->value.span) : std::nullopt;
}

}  // namespace

std::optional<Span> find_model_key(const SourceText& source) {
  return find_model_key(source, TomlKind::string);
}

bool declares_model(const SourceText& source) {
  return find_model_key(source, TomlKind::table).has_value();
}

}  // namespace elgen
