// changed_keys: two parsed trees side by side. Expressions are compared as trees, so that blanks
// and brackets that change nothing are no change.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

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

/// As it is written, in one line.
std::string text_of(const ValueSyntax& value) {
  if (value.kind == ValueKind::boolean) return value.boolean ? "true" : "false";
  if (value.kind == ValueKind::table) return text_of(value.entries);
  if (value.kind != ValueKind::list) return value.text;
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

bool is_same(const ValueSyntax& x, const ValueSyntax& y) {
  if (x.kind != y.kind) return false;
  const auto all_same = [](const auto& a, const auto& b) {
    return std::ranges::equal(a, b, [](const auto& p, const auto& q) { return is_same(p, q); });
  };
  switch (x.kind) {
    case ValueKind::expression:
      return dump(x.expression) == dump(y.expression);
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

bool is_repeated(const EntrySyntax& entry) {
  const auto row = std::ranges::find(entry_table(), entry.name, &EntryRow::entry);
  return row != entry_table().end() && row->repeated;
}

/// What tells a repeated entry from its likes: "bob", "on x"; "" where it has to be its number.
std::string identity(const EntrySyntax& entry) {
  if (const KeySyntax* const name = entry.find("name")) return name->value.text;
  for (const char* const key : {"on", "at", "frame"}) {
    if (const KeySyntax* const place = entry.find(key)) {
      return fmt::format("{} {}", key, text_of(place->value));
    }
  }
  return {};
}

using Path = std::vector<KeyStep>;

Path below(Path path, KeyStep step) {
  path.push_back(std::move(step));
  return path;
}

/// An entry with what it is called in messages.
struct NamedEntry {
  const EntrySyntax* entry = nullptr;
  std::string name = {};  ///< "[gravity]", "[[point]] bob", "[[force]] on x #2"
};

std::vector<NamedEntry> named(const FileSyntax& file) {
  std::vector<NamedEntry> all;
  std::map<std::string, int> known;
  for (const EntrySyntax& entry : file.entries) {
    std::string name = entry.name;
    if (is_repeated(entry)) {
      const std::string who = identity(entry);
      name = fmt::format("[[{}]]{}{}", name, who.empty() ? "" : " ", who);
      const int number = ++known[name];
      if (number > 1 || who.empty()) name += fmt::format(" #{}", number);
    } else if (!name.empty()) {
      name = fmt::format("[{}]", name);
    }
    all.push_back({&entry, std::move(name)});
  }
  return all;
}

class KeyComparison {
 public:
  std::vector<KeyChange> operator()(const FileSyntax& before, const FileSyntax& after) {
    const std::vector<NamedEntry> olds = named(before);
    const std::vector<NamedEntry> news = named(after);
    for (const NamedEntry& now : news) {
      place_ = {.table = now.entry->name, .entry = now.name};
      const auto old = std::ranges::find(olds, now.name, &NamedEntry::name);
      if (old != olds.end()) {
        compare(old->entry->keys, now.entry->keys, {});
      } else {
        add({}, "", text_of(now.entry->keys), {}, now.entry->span);
      }
    }
    for (const NamedEntry& old : olds) {
      if (std::ranges::count(news, old.name, &NamedEntry::name) > 0) continue;
      place_ = {.table = old.entry->name, .entry = old.name};
      add({}, text_of(old.entry->keys), "", old.entry->span, {});
    }
    compare_orders(olds, news);
    return std::move(changes_);
  }

 private:
  void add(Path path, std::string before, std::string after, Span old_at, Span new_at) {
    KeyChange& change = changes_.emplace_back(place_);
    change.path = std::move(path);
    change.before = std::move(before);
    change.after = std::move(after);
    change.old_at = old_at;
    change.new_at = new_at;
  }

  void compare(const std::vector<KeySyntax>& olds, const std::vector<KeySyntax>& news,
               const Path& path) {
    for (const KeySyntax& now : news) {
      const auto old = std::ranges::find(olds, now.key, &KeySyntax::key);
      if (old != olds.end()) {
        compare(old->value, now.value, below(path, {now.key}));
      } else {
        add(below(path, {now.key}), "", text_of(now.value), {}, now.key_span);
      }
    }
    for (const KeySyntax& old : olds) {
      if (std::ranges::count(news, old.key, &KeySyntax::key) > 0) continue;
      add(below(path, {old.key}), text_of(old.value), "", old.key_span, {});
    }
  }

  void compare(const ValueSyntax& old, const ValueSyntax& now, const Path& path) {
    if (is_same(old, now)) return;
    const bool are_tables = old.kind == ValueKind::table && now.kind == ValueKind::table;
    if (are_tables) return compare(old.entries, now.entries, path);
    const bool are_lists = old.kind == ValueKind::list && now.kind == ValueKind::list;
    if (are_lists && old.items.size() == now.items.size()) {
      for (std::size_t i = 0; i < now.items.size(); ++i) {
        compare(old.items[i], now.items[i], below(path, {"", i + 1}));
      }
      return;
    }
    if (old.kind != now.kind && compare_short(old, now, path)) return;
    add(path, text_of(old), text_of(now), old.span, now.span);
  }

  /// `m = 1` is short for `m = { value = 1 }`.
  bool compare_short(const ValueSyntax& old, const ValueSyntax& now, const Path& path) {
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

  /// q, u and the members of Parameters are in the order of the file.
  void compare_orders(const std::vector<NamedEntry>& olds, const std::vector<NamedEntry>& news) {
    for (const char* const kind : {"coordinate", "input"}) {
      place_ = {.table = kind, .entry = fmt::format("[[{}]]", kind), .is_order = true};
      compare_order(names_of(olds, kind), names_of(news, kind));
    }
    place_ = {.table = "parameters", .entry = "[parameters]", .is_order = true};
    compare_order(keys_of(olds), keys_of(news));
  }

  using Names = std::vector<std::pair<std::string, Span>>;

  static Names names_of(const std::vector<NamedEntry>& entries, std::string_view kind) {
    Names names;
    for (const NamedEntry& named : entries) {
      if (named.entry->name == kind) {
        names.emplace_back(identity(*named.entry), named.entry->span);
      }
    }
    return names;
  }

  static Names keys_of(const std::vector<NamedEntry>& entries) {
    Names names;
    for (const NamedEntry& named : entries) {
      if (named.entry->name != "parameters") continue;
      for (const KeySyntax& key : named.entry->keys) names.emplace_back(key.key, key.key_span);
    }
    return names;
  }

  /// Of those that are in both.
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
      std::vector<std::string> all;
      for (const auto& name : names) all.push_back(name.first);
      return fmt::format("{}", fmt::join(all, ", "));
    };
    add({}, listed(olds), listed(news), moved.in1->second, moved.in2->second);
  }

  KeyChange place_ = {};  ///< of the changes that are found
  std::vector<KeyChange> changes_ = {};
};

}  // namespace

std::string text_of(const std::vector<KeyStep>& path) {
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
                         : KeyComparison()(renamed(before, renames), after);
}

}  // namespace elgen
