// The tables of a file against the entry table: unknown and unsupported ones, `[x]` for `[[x]]`,
// and those a file cannot do without.
#include "parse/entry_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "elgen/wording.hpp"

namespace elgen {

namespace {

/// The rows of one kind of file, with the name the file uses.
struct NamedRow {
  std::string name;
  const EntryRow* row;
};

std::vector<NamedRow> rows_of(FileKind kind) {
  constexpr std::string_view prefix = "scene.";
  std::vector<NamedRow> result;
  for (const EntryRow& row : entry_table()) {
    const bool of_scene = row.entry.substr(0, prefix.size()) == prefix;
    if (of_scene != (kind == FileKind::scene)) continue;
    result.push_back({std::string(row.entry.substr(of_scene ? prefix.size() : 0)), &row});
  }
  return result;
}

std::string header_text(std::string_view name, bool repeated) {
  return repeated ? fmt::format("`[[{}]]`", name) : fmt::format("`[{}]`", name);
}

bool is_array_of_tables(const TomlValue& value) {
  const auto is_table = [](const TomlValue& item) { return item.kind == TomlKind::table; };
  return value.kind == TomlKind::array && !value.items.empty() &&
         std::all_of(value.items.begin(), value.items.end(), is_table);
}

/// The header of a table, or of the first of an array of tables.
const Span& header_of(const TomlValue& value) {
  return is_array_of_tables(value) ? value.items.front().span : value.span;
}

class EntryReader {
 public:
  EntryReader(FileKind kind, FileReading& reading)
      : kind_(kind), rows_(rows_of(kind)), reading_(reading) {}

  std::vector<EntrySyntax> read(const TomlValue& root);

 private:
  [[nodiscard]] const NamedRow* find(std::string_view name) const;
  [[nodiscard]] bool is_unknown_table(const TomlEntry& entry) const;
  void read_known(const NamedRow& row, const TomlEntry& entry);
  void report_wrong_kind(const NamedRow& row, const TomlEntry& entry);
  void report_unknown(const TomlEntry& entry);
  void report_missing(const TomlValue& root);
  void add(const NamedRow& row, const TomlValue& table);

  FileKind kind_;
  std::vector<NamedRow> rows_;
  FileReading& reading_;
  std::vector<EntrySyntax> entries_ = {};
};

std::vector<EntrySyntax> EntryReader::read(const TomlValue& root) {
  std::vector<TomlEntry> keys;
  for (const TomlEntry& entry : root.entries) {
    if (const NamedRow* row = find(entry.key)) {
      read_known(*row, entry);
    } else if (is_unknown_table(entry)) {
      report_unknown(entry);
    } else {
      keys.push_back(entry);
    }
  }
  report_missing(root);
  std::sort(entries_.begin(), entries_.end(),
            [](const EntrySyntax& a, const EntrySyntax& b) { return a.span.begin < b.span.begin; });
  const Span start{root.span.source, 0, 0};
  const TableContext top{kind_ == FileKind::scene ? "scene" : "", "the file", start};
  entries_.insert(entries_.begin(), EntrySyntax{"", start, read_keys(keys, top, reading_)});
  return std::move(entries_);
}

const NamedRow* EntryReader::find(std::string_view name) const {
  const auto row =
      std::find_if(rows_.begin(), rows_.end(), [&](const NamedRow& r) { return r.name == name; });
  return row == rows_.end() ? nullptr : &*row;
}

/// Keys of the top level hold no tables.
bool EntryReader::is_unknown_table(const TomlEntry& entry) const {
  return entry.value.kind == TomlKind::table || is_array_of_tables(entry.value);
}

void EntryReader::read_known(const NamedRow& row, const TomlEntry& entry) {
  const TomlValue& value = entry.value;
  if (!row.row->supported) {
    reading_.report(Code::E108, header_of(value),
                    header_text(row.name, row.row->repeated) + " is not yet supported");
  } else if (row.row->repeated && is_array_of_tables(value)) {
    for (const TomlValue& table : value.items) add(row, table);
  } else if (!row.row->repeated && value.kind == TomlKind::table) {
    add(row, value);
  } else {
    report_wrong_kind(row, entry);
  }
}

void EntryReader::report_wrong_kind(const NamedRow& row, const TomlEntry& entry) {
  const bool is_table = entry.value.kind == TomlKind::table;
  if (!is_table && !is_array_of_tables(entry.value)) {
    report_wrong_type(entry.value, row.row->repeated ? "an array of tables" : "a table", reading_);
    return;
  }
  reading_.report(Code::E107, header_of(entry.value),
                  header_text(row.name, !is_table) + " is the wrong kind of table",
                  "write " + header_text(row.name, row.row->repeated));
}

void EntryReader::report_unknown(const TomlEntry& entry) {
  std::vector<std::string> candidates;
  for (const NamedRow& row : rows_) {
    if (row.row->supported) candidates.push_back(row.name);
  }
  const std::string near = nearest(entry.key, candidates);
  const NamedRow* row = find(near);
  reading_.report(
      Code::E106, header_of(entry.value), "unknown entry " + quoted(entry.key),
      row == nullptr ? "" : fmt::format("did you mean {}?", header_text(near, row->row->repeated)));
}

void EntryReader::report_missing(const TomlValue& root) {
  for (const NamedRow& row : rows_) {
    const bool given = std::any_of(root.entries.begin(), root.entries.end(),
                                   [&](const TomlEntry& entry) { return entry.key == row.name; });
    if (given || !row.row->required) continue;
    reading_.report(Code::E105, {root.span.source, 0, 0},
                    "no " + header_text(row.name, row.row->repeated) + " in the file");
  }
}

void EntryReader::add(const NamedRow& row, const TomlValue& table) {
  const TableContext context{std::string(row.row->entry), header_text(row.name, row.row->repeated),
                             table.span};
  entries_.push_back({row.name, table.span, read_keys(table.entries, context, reading_)});
}

}  // namespace

std::vector<EntrySyntax> read_entries(const TomlValue& root, FileKind kind, FileReading& reading) {
  return EntryReader(kind, reading).read(root);
}

}  // namespace elgen
