// Laws of the key table: no row twice, every row belongs to an entry, choices belong to choice
// keys.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "elgen/syntax.hpp"

using namespace elgen;

namespace {

bool is_choice(const KeyRow& row) {
  return row.type == KeyType::choice || row.type == KeyType::choice_list;
}

}  // namespace

TEST_CASE("no key has two rows", "[parse]") {
  std::set<std::pair<std::string_view, std::string_view>> seen;
  for (const KeyRow& row : key_table()) {
    INFO(row.entry << "." << row.key);
    CHECK(seen.emplace(row.entry, row.key).second);
    CHECK_FALSE(row.doc.empty());
    CHECK((row.supported || !row.required));
  }
}

TEST_CASE("every row hangs on an entry or on a key that is a table", "[parse]") {
  for (const KeyRow& row : key_table()) {
    INFO(row.entry << "." << row.key);
    const bool top = row.entry.empty() || row.entry == "scene";
    const bool entry = std::any_of(entry_table().begin(), entry_table().end(),
                                   [&](const EntryRow& e) { return e.entry == row.entry; });
    const bool key = std::any_of(key_table().begin(), key_table().end(), [&](const KeyRow& k) {
      return std::string(k.entry) + "." + std::string(k.key) == row.entry;
    });
    CHECK((top || entry || key));
  }
}

TEST_CASE("every supported entry has keys, every choice its words", "[parse]") {
  for (const EntryRow& entry : entry_table()) {
    const bool has_keys = std::any_of(key_table().begin(), key_table().end(),
                                      [&](const KeyRow& k) { return k.entry == entry.entry; });
    INFO(entry.entry);
    CHECK(has_keys == entry.supported);
  }
  for (const KeyRow& row : key_table()) {
    const bool has_words =
        std::any_of(choice_table().begin(), choice_table().end(),
                    [&](const ChoiceRow& c) { return c.entry == row.entry && c.key == row.key; });
    INFO(row.entry << "." << row.key);
    CHECK(has_words == is_choice(row));
  }
}
