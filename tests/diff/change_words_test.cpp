// Single changes in words.
#include "diff/change_words.hpp"

#include <catch2/catch.hpp>

#include "diff/versions.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("keys that are new, gone or moved") {
  KeyChange change{.table = "gravity", .entry = "[gravity]", .path = {{"vector"}, {"", 2}}};
  change.after = "-g";
  CHECK(text_of(change) == "[gravity] vector[2] is new: -g");
  change.before = "g";
  CHECK(text_of(change) == "[gravity] vector[2]: g -> -g");
  change.after.clear();
  CHECK(text_of(change) == "[gravity] vector[2] is gone: g");
  CHECK(place_text(change).empty());
}

TEST_CASE("long values of keys are cut") {
  const KeyChange change{.entry = "[energy]", .after = std::string(100, 'x')};
  CHECK(text_of(change) == "[energy] is new: " + std::string(57, 'x') + "...");
}

TEST_CASE("entries without closed forms are told by their witness") {
  EntryChange entry{.place = "bias[2]", .unit = "N*m", .verdict = EntryVerdict::different};
  CHECK(text_of(entry) == "bias[2] differs");
  CHECK(witness_text(entry).empty());
  entry.witness = Witness{"theta = 0.3", 1, 2};
  entry.share = 0.5;
  CHECK(witness_text(entry) == "at theta = 0.3: 1 -> 2 N*m, 0.5 of the largest");
}

TEST_CASE("entries are counted by their verdicts") {
  OutputChange output{.entry_count = 4};
  output.entries.push_back({.verdict = EntryVerdict::equal, .is_proved = true});
  VerdictCounts counts;
  counts.add(output);
  CHECK(counts.text() == "0 of 4 entries differ, 1 rewritten (proved)");
  output.entries = {{.verdict = EntryVerdict::equal}, {.verdict = EntryVerdict::different}};
  counts.add(output);
  CHECK(counts.text() == "1 of 8 entries differs, 2 rewritten (1 proved)");
}

TEST_CASE("an entry that is gone and one that is there instead count once") {
  OutputChange output{.entry_count = 4};
  for (const EntryVerdict verdict :
       {EntryVerdict::added, EntryVerdict::added, EntryVerdict::removed}) {
    output.entries.push_back({.verdict = verdict});
  }
  VerdictCounts counts;
  counts.add(output);
  CHECK(counts.text() == "0 of 4 entries differ, 0 rewritten, 1 replaced, 1 added");
  CHECK(counts.changed() == 2);
}

TEST_CASE("a coordinate with another name counts no entry twice") {
  const std::string other = edited(
      edited(edited(spring(), "name = \"x\"", "name = \"s\""), "dot(x)", "dot(s)"), "x^2", "s^2");
  const VerdictCounts counts = counts_of(compared(spring(), other));
  CHECK(counts.replaced > 0);
  CHECK(counts.added + counts.removed == 0);
  CHECK(counts.changed() <= counts.all);
}

TEST_CASE("operations that stay are not told") {
  OperationsChange change{"bias", {.add = 1, .mul = 3}, {.add = 1, .mul = 4, .div = 1}};
  CHECK(text_of(change) == "bias: mul 3 -> 4, div 0 -> 1");
}
