// changed_keys: compares two parsed files. Expressions are compared as syntax trees, so blanks and
// redundant brackets make no difference.
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "diff/renamed.hpp"
#include "elgen/diff.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

std::string text_of(const ValueSyntax& value);

std::string text_of(const std::vector<KeySyntax>& keys) {
  std::string text;
  for (const KeySyntax& key : keys) {
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", key.key, text_of(key.value));
  }
  return fmt::format("{{ {} }}", text);
}

/// True for values other than lists and tables; also for equations and repetitions, whose text the
/// parser turned into a list or table.
bool has_single_text(const ValueSyntax& value) {
  const bool has_parts = value.kind == ValueKind::list || value.kind == ValueKind::table;
  return !has_parts || !value.text.empty();
}

/// The value as it is written, on one line.
std::string text_of(const ValueSyntax& value) {
  if (value.kind == ValueKind::boolean) return value.boolean ? "true" : "false";
  if (has_single_text(value)) return value.text;
  if (value.kind == ValueKind::table) return text_of(value.entries);
  std::string text;
  for (const ValueSyntax& item : value.items) {
    text += (text.empty() ? "" : ", ") + text_of(item);
  }
  return "[" + text + "]";
}

bool is_same(const ValueSyntax& x, const ValueSyntax& y);

bool is_same(const KeySyntax& x, const KeySyntax& y) {
  return x.key == y.key && is_same(x.value, y.value);
}

bool is_same(const ExpressionSyntax& x, const ExpressionSyntax& y) {
  return x.kind == y.kind && x.text == y.text && x.value == y.value &&
         std::ranges::equal(x.operands, y.operands,
                            [](const auto& p, const auto& q) { return is_same(p, q); });
}

bool is_same(const ValueSyntax& x, const ValueSyntax& y) {
  if (x.kind != y.kind) return false;
  const auto all_same = [](const auto& a, const auto& b) {
    return std::ranges::equal(a, b, [](const auto& p, const auto& q) { return is_same(p, q); });
  };
  switch (x.kind) {
    case ValueKind::expression:
      return is_same(x.expression, y.expression);
    case ValueKind::text:
      return x.text == y.text;
    case ValueKind::boolean:
      return x.boolean == y.boolean;
    case ValueKind::list:
      return all_same(x.items, y.items);
    case ValueKind::table:
      return all_same(x.entries, y.entries);
  }
  return false;
}

bool may_repeat(const EntrySyntax& entry) {
  const auto row = std::ranges::find(entry_table(), entry.name, &EntryRow::entry);
  return row != entry_table().end() && row->repeated;
}

/// An entry of a file. If entries of its kind may be repeated, `key` and `number` identify it.
struct IdentifiedEntry {
  const EntrySyntax* entry = nullptr;
  const KeySyntax* key = nullptr;  ///< "name", "on", "at" or "frame"; null: none of these
  std::size_t number = 1;          ///< 1 for the first entry with this key, 2 for the second
};

bool has_same_key(const IdentifiedEntry& x, const IdentifiedEntry& y) {
  if (x.entry->name != y.entry->name || (x.key == nullptr) != (y.key == nullptr)) return false;
  return x.key == nullptr || is_same(*x.key, *y.key);
}

const KeySyntax* identifying_key(const EntrySyntax& entry) {
  for (const char* const key : {"name", "on", "at", "frame"}) {
    const KeySyntax* const found = entry.find(key);
    if (found != nullptr && found->value.kind != ValueKind::table) return found;
  }
  return nullptr;
}

/// "[[point]] bob", "[[force]] on x #2", "[gravity]"; "" for keys outside of all tables.
std::string text_of(const IdentifiedEntry& one) {
  const auto& table = one.entry->name;
  if (!may_repeat(*one.entry)) return table.empty() ? "" : fmt::format("[{}]", table);
  std::string text = fmt::format("[[{}]]", table);
  if (one.key != nullptr) {
    if (one.key->key != "name") text += " " + one.key->key;
    text += " " + text_of(one.key->value);
  }
  if (one.key == nullptr || one.number > 1) text += fmt::format(" #{}", one.number);
  return text;
}

using KeyPath = std::vector<PathComponent>;

KeyPath append_step(KeyPath path, PathComponent step) {
  path.push_back(std::move(step));
  return path;
}

using IdentifiedEntries = std::vector<IdentifiedEntry>;

IdentifiedEntries identify_entries(const FileSyntax& file) {
  IdentifiedEntries all;
  for (const EntrySyntax& entry : file.entries) {
    IdentifiedEntry one{&entry, may_repeat(entry) ? identifying_key(entry) : nullptr};
    for (const IdentifiedEntry& other : all) {
      if (has_same_key(other, one)) ++one.number;
    }
    all.push_back(one);
  }
  return all;
}

const IdentifiedEntry* find_identified_entry(const IdentifiedEntries& entries,
                                             const IdentifiedEntry& wanted) {
  const auto found = std::ranges::find_if(entries, [&wanted](const IdentifiedEntry& one) {
    return has_same_key(one, wanted) && one.number == wanted.number;
  });
  return found == entries.end() ? nullptr : &*found;
}

class KeyComparison {
 public:
  std::vector<KeyChange> operator()(const FileSyntax& before, const FileSyntax& after) {
    const IdentifiedEntries olds = identify_entries(before);
    const IdentifiedEntries news = identify_entries(after);
    prefix_ = table_prefix(after.entries.empty() ? before : after);
    for (const IdentifiedEntry& now : news) {
      set_current_entry(now);
      if (const IdentifiedEntry* const old = find_identified_entry(olds, now)) {
        compare(old->entry->keys, now.entry->keys, {});
      } else {
        add_change({}, "", text_of(now.entry->keys), {}, now.entry->span);
      }
    }
    for (const IdentifiedEntry& old : olds) {
      if (find_identified_entry(news, old) != nullptr) continue;
      set_current_entry(old);
      add_change({}, text_of(old.entry->keys), "", old.entry->span, {});
    }
    compare_orders(olds, news);
    return std::move(changes_);
  }

 private:
  void set_current_entry(const IdentifiedEntry& found) {
    const std::string table = std::string(prefix_) + found.entry->name;
    place_ = {.table = std::string(entry_of_keys(table)), .entry = text_of(found)};
  }

  void add_change(KeyPath path, std::string before, std::string after, Span old_at, Span new_at) {
    KeyChange& change = changes_.emplace_back(place_);
    change.path = std::move(path);
    change.before = std::move(before);
    change.after = std::move(after);
    change.old_span = old_at;
    change.new_span = new_at;
  }

  void compare(const std::vector<KeySyntax>& olds, const std::vector<KeySyntax>& news,
               const KeyPath& path) {
    for (const KeySyntax& now : news) {
      const auto old = std::ranges::find(olds, now.key, &KeySyntax::key);
      if (old != olds.end()) {
        compare(old->value, now.value, append_step(path, {now.key}));
      } else {
        add_change(append_step(path, {now.key}), "", text_of(now.value), {}, now.key_span);
      }
    }
    for (const KeySyntax& old : olds) {
      if (std::ranges::count(news, old.key, &KeySyntax::key) > 0) continue;
      add_change(append_step(path, {old.key}), text_of(old.value), "", old.key_span, {});
    }
  }

  void compare(const ValueSyntax& old, const ValueSyntax& now, const KeyPath& path) {
    if (is_same(old, now)) return;
    const bool have_parts = !has_single_text(old) && !has_single_text(now);
    const bool are_tables = have_parts && old.kind == ValueKind::table && now.kind == old.kind;
    if (are_tables) return compare(old.entries, now.entries, path);
    const bool are_lists = have_parts && old.kind == ValueKind::list && now.kind == old.kind;
    if (are_lists && old.items.size() == now.items.size()) {
      for (std::size_t i = 0; i < now.items.size(); ++i) {
        compare(old.items[i], now.items[i], append_step(path, {"", i + 1}));
      }
      return;
    }
    if (old.kind != now.kind && compare_short(old, now, path)) return;
    add_change(path, text_of(old), text_of(now), old.span, now.span);
  }

  /// Compares a short value `m = 1` with a long value `m = { value = 1 }`. Returns false, without a
  /// comparison, for other kinds of values.
  bool compare_short(const ValueSyntax& old, const ValueSyntax& now, const KeyPath& path) {
    const auto written_out = [](const ValueSyntax& value) {
      return std::vector<KeySyntax>{{"value", value.span, value}};
    };
    if (old.kind == ValueKind::expression && now.kind == ValueKind::table) {
      compare(written_out(old), now.entries, path);
      return true;
    }
    if (old.kind == ValueKind::table && now.kind == ValueKind::expression) {
      compare(old.entries, written_out(now), path);
      return true;
    }
    return false;
  }

  /// Compares the orders of coordinates, inputs, constraints and parameters, on which callers rely.
  /// A scene declares only inputs.
  void compare_orders(const IdentifiedEntries& olds, const IdentifiedEntries& news) {
    for (const char* const kind : {"coordinate", "input", "constraint"}) {
      place_ = {.table = kind, .entry = fmt::format("[[{}]]", kind), .is_reordering = true};
      compare_order(names_of(olds, kind), names_of(news, kind));
    }
    place_ = {.table = "parameters", .entry = "[parameters]", .is_reordering = true};
    compare_order(parameter_names(olds), parameter_names(news));
  }

  using Names = std::vector<std::pair<std::string, Span>>;

  static Names names_of(const IdentifiedEntries& entries, std::string_view kind) {
    Names names;
    for (const auto& [entry, key, number] : entries) {
      if (entry->name == kind && key != nullptr) {
        names.emplace_back(text_of(key->value), entry->span);
      }
    }
    return names;
  }

  static Names parameter_names(const IdentifiedEntries& entries) {
    Names names;
    for (const IdentifiedEntry& one : entries) {
      if (one.entry->name != "parameters") continue;
      for (const KeySyntax& key : one.entry->keys) names.emplace_back(key.key, key.key_span);
    }
    return names;
  }

  /// Compares the order of the names that both versions have. Adds a change if the order differs.
  void compare_order(Names olds, Names news) {
    const auto drop_others = [](Names& names, const Names& others) {
      std::erase_if(names, [&others](const auto& name) {
        return std::ranges::count(others, name.first, &Names::value_type::first) == 0;
      });
    };
    drop_others(olds, news);
    drop_others(news, olds);
    const auto moved =
        std::ranges::mismatch(olds, news, {}, &Names::value_type::first, &Names::value_type::first);
    if (moved.in2 == news.end()) return;
    const auto listed = [](const Names& names) {
      return fmt::format("{}", fmt::join(column_words(names, &Names::value_type::first), ", "));
    };
    add_change({}, listed(olds), listed(news), moved.in1->second, moved.in2->second);
  }

  std::string_view prefix_ = {};
  KeyChange place_ = {};  ///< table and entry of the next changes
  std::vector<KeyChange> changes_ = {};
};

}  // namespace

std::string text_of(const std::vector<PathComponent>& path) {
  std::string text;
  for (const auto& [key, item] : path) {
    text +=
        item > 0 ? fmt::format("[{}]", item) : fmt::format("{}{}", text.empty() ? "" : ".", key);
  }
  return text;
}

std::vector<KeyChange> changed_keys(const FileSyntax& before, const FileSyntax& after,
                                    const Renames& renames) {
  return renames.empty() ? KeyComparison()(before, after)
                         : KeyComparison()(apply_renames(before, renames), after);
}

}  // namespace elgen
