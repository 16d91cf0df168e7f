// A report as text, as JSON, as a pull-request comment and as GitHub annotations. Changes common to
// several systems are printed once.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "diff/change_words.hpp"
#include "diff/versions.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

DiffReport report_of_two(const SystemChange& system) {
  SystemChange other = system;
  other.name = "other";
  return {.systems = {system, other}};
}

std::string report(const std::string& before, const std::string& after, bool lists_all = false) {
  return to_text({.systems = {compared(before, after)}}, lists_all);
}

}  // namespace

TEST_CASE("keys that are new, removed or moved") {
  KeyChange change{.table = "gravity", .entry = "[gravity]", .path = {{"vector"}, {"", 2}}};
  change.after = "-g";
  CHECK(text_of(change) == "[gravity] vector[2] is new: -g");
  change.before = "g";
  CHECK(text_of(change) == "[gravity] vector[2]: g -> -g");
  change.after.clear();
  CHECK(text_of(change) == "[gravity] vector[2] is removed: g");
  CHECK(place_text(change).empty());
}

TEST_CASE("long values of keys are truncated") {
  const KeyChange change{.entry = "[energy]", .after = std::string(100, 'x')};
  CHECK(text_of(change) == "[energy] is new: " + std::string(57, 'x') + "...");
}

TEST_CASE("entries without closed forms are described by their witness") {
  EntryChange entry{.place = "bias[2]", .unit = "N*m", .verdict = EntryVerdict::different};
  CHECK(text_of(entry) == "bias[2] differs");
  CHECK(witness_text(entry).empty());
  entry.witness = Witness{"theta = 0.3", 1, 2};
  entry.relative_change = 0.5;
  CHECK(witness_text(entry) == "at theta = 0.3: 1 -> 2 N*m, 0.5 of the largest entry");
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

TEST_CASE("a removed and an added entry count as one replaced entry") {
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

TEST_CASE("entries of a renamed coordinate are not counted twice") {
  const std::string other =
      replaced(replaced(replaced(spring(), "name = \"x\"", "name = \"s\""), "dot(x)", "dot(s)"),
               "x^2", "s^2");
  const VerdictCounts counts = counts_of(compared(spring(), other));
  CHECK(counts.replaced > 0);
  CHECK(counts.added + counts.removed == 0);
  CHECK(counts.changed() <= counts.all);
}

TEST_CASE("unchanged operations are not listed") {
  OperationsChange change{"bias", {.add = 1, .mul = 3}, {.add = 1, .mul = 4, .div = 1}};
  CHECK(text_of(change) == "bias: mul 3 -> 4, div 0 -> 1");
}

TEST_CASE("the report of one changed sign has a dozen lines, the cause first") {
  CHECK(report(cart, replaced(cart, "\"-g\"", "\"g\"")) ==
        "changed      model.toml:56:17  [gravity] vector[2]: -g -> g\n"
        "             V = m*l*g*cos(theta) -> -m*l*g*cos(theta);  T, D, Q, B identical\n"
        "             [[expect]] was not updated: 5 entries no longer hold (bias[2], "
        "conserved[2], gravity[2], inverse_dynamics[2], ...)\n"
        "warns        E512: gravity pulls along +y\n"
        "follows      14 of 74 entries differ, 0 rewritten\n"
        "example      gravity[2] = -m*l*g*sin(theta) -> m*l*g*sin(theta), difference "
        "2*m*l*g*sin(theta)\n"
        "             at theta = 1.68: -0.488 -> 0.488 N*m, 2 of the largest entry\n"
        "interface    unchanged\n"
        "different    the equations differ\n");
}

TEST_CASE("silent breaks come first") {
  const std::string text =
      report(spring(), replaced(replaced(spring(), "k = 3\n", ""), "m = {", "k = 3\nm = {"));
  CHECK(starts_with(text,
                    "interface    breaks: the members of Parameters changed their order: m, k -> "
                    "k, m; callers still compile but with another meaning\n"));
  CHECK(mentions(text, "\nbreaks       calling code breaks\n"));
}

TEST_CASE("without changes of equations the report is one line") {
  CHECK(report(cart, cart) == "equal        the equations are the same\n");
  CHECK(report(cart, cart + "#\n") == "equal        the equations are the same\n");
}

TEST_CASE("every entry is listed on request") {
  const std::string text = report(spring("k*(1 - cos(x))"), spring("2*k*sin(x/2)^2 + m*x"), true);
  CHECK(mentions(text, "potential_energy = "));
  CHECK(mentions(text, "gravity = k*sin(x) -> m + k*sin(x), difference m\n"));
  const std::string equal = report(spring("k*(1 - cos(x))"), spring("2*k*sin(x/2)^2"), true);
  CHECK(mentions(equal, "potential_energy: equal, written differently (proved)\n"));
}

TEST_CASE("added and removed files are listed and affect the impact") {
  const DiffReport report{.added = {"a.toml"}};
  CHECK(impact_of(report) == Impact::extended);
  CHECK(starts_with(to_text(report, false), "added        a.toml\n"));
  CHECK(impact_of({.removed = {"a.toml"}}) == Impact::breaks);
}

TEST_CASE("a cause that two systems share is one line") {
  const SystemChange system = compared(spring(), spring("k*x^2"));
  const std::string text = to_text(report_of_two(system), false);
  CHECK(count(text, "[energy] V: 1/2*k*x^2 -> k*x^2") == 1);
  CHECK(mentions(text, "follows      spring, other: 11 of 25 entries differ"));
  CHECK(mentions(text, "verdict      spring, other: different: the equations differ\n"));
}

TEST_CASE("in a report of two systems every line names its system, and each has its verdict") {
  const std::string second = replaced(spring(), "\"spring\"", "\"second\"");
  const DiffReport report{.systems = {compared(spring(), spring("k*x^2")),
                                      compared(second, replaced(second, "k = 3", "k = 4"))}};
  for (const std::string& text : {to_text(report, true), to_markdown(report)}) {
    CHECK(mentions(text, "changed      spring: model.toml:"));
    CHECK(mentions(text, "             second: model.toml:"));
    CHECK(mentions(text, "example      spring: "));
    CHECK(mentions(text, "interface    second: values: the value of `k` is 4 (was 3)\n"));
    CHECK(mentions(text, "verdict      spring: different: the equations differ\n"));
    CHECK(mentions(text, "             second: values: values, ranges"));
  }
  const std::string text = to_annotations(report);
  CHECK(mentions(text, "::warning file="));
  CHECK(mentions(text, "k*x^2 (spring: different)\n"));
  CHECK(mentions(text, "::notice file="));
  CHECK(mentions(text, "title=elgen diff%3A values (values%2C ranges"));
  CHECK(mentions(text, "3 -> 4 (second: values)\n"));
}

TEST_CASE("systems of the same name are distinguished by their paths") {
  DiffReport report = report_of_two(compared(spring(), spring("k*x^2")));
  report.systems[1].name = report.systems[0].name;
  report.systems[0].path = "a/spring.toml";
  report.systems[1].path = "b/spring.toml";
  const std::string text = to_text(report, false);
  CHECK(mentions(text, "verdict      spring (a/spring.toml), spring (b/spring.toml): different"));
}

TEST_CASE("each cause has the worst impact that it can have itself") {
  const std::string moved =
      replaced(replaced(spring("k*x^2"), "k = 3\n", ""), "m = {", "k = 3\nm = {");
  const SystemChange system = compared(spring(), replaced(moved, "value = 2,", "value = 5,"));
  CHECK(system.impact == Impact::breaks);
  for (const KeyChange& key : system.keys) {
    const Impact of_equations = key.table == "energy" ? Impact::different : Impact::values;
    const Impact impact = key.is_reordering ? Impact::breaks : of_equations;
    INFO(text_of(key));
    CHECK(key.impact == impact);
  }
  const std::string text = to_annotations({.systems = {system}});
  CHECK(mentions(text, "title=elgen diff%3A different (the equations differ)::[energy] V"));
  CHECK(mentions(text, "title=elgen diff%3A breaks (calling code breaks)::[parameters] order"));
}

TEST_CASE("unreadable models are listed with the others, and alone they give no verdict") {
  DiffReport report{.unreadable = {{"a.toml", {Code::E201, {}, "unknown name `z`"}}}};
  CHECK(to_text(report, false) == "unreadable   a.toml: E201: unknown name `z`\n");
  CHECK(starts_with(to_markdown(report), "### elgen diff: unreadable\n\n```text\nunreadable "));
  CHECK(nlohmann::json::parse(to_json(report)).at("impact").is_null());
  report.systems = {compared(spring(), spring("k*x^2"))};
  const std::string text = to_text(report, false);
  CHECK(starts_with(text, "unreadable   a.toml: E201: unknown name `z`\nchanged      spring: "));
  CHECK(mentions(text, "\ndifferent    of the readable systems: the equations differ\n"));
  CHECK(starts_with(to_markdown(report), "### elgen diff: different (of the readable systems: "));
  const auto json = nlohmann::json::parse(to_json(report));
  CHECK(json.at("impact") == "different");
  CHECK(json.at("unreadable").at(0).at("path") == "a.toml");
  CHECK(json.at("unreadable").at(0).at("error").at("code") == "E201");
}

TEST_CASE("undecided entries are counted, listed, and count as equal") {
  const std::string text = report(spring("k*(x + sqrt(x^4))"), spring("k*(x + x^2)"));
  CHECK(mentions(text, " undecided at 64 points\n"));
  CHECK(mentions(text, "follows      0 of 25 entries differ, 0 rewritten"));
  CHECK(mentions(text,
                 "\nequal        the equations are the same, compared at 64 points only "
                 "(see --strict)\n"));
}

TEST_CASE("more than five keys are counted") {
  SystemChange system{.impact = Impact::values};
  for (const char* const name : {"a", "b", "c", "d", "e", "f", "g"}) {
    system.keys.push_back({.table = "model", .entry = "[model]", .path = {{name}}, .after = "1"});
  }
  const DiffReport report{.systems = {system}};
  CHECK(mentions(to_text(report, false), "2 keys more (--list)\n"));
  CHECK(mentions(to_text(report, true), "[model] g is new: 1\n"));
}

TEST_CASE("operations are listed if all are known") {
  SystemChange system{.impact = Impact::equal, .keys = {{.entry = "[energy]", .after = "1"}}};
  CHECK_FALSE(mentions(to_text({.systems = {system}}, false), "operations"));
  system.operations.emplace();
  CHECK(mentions(to_text({.systems = {system}}, false), "operations   unchanged\n"));
  system.operations->push_back({"bias", {.mul = 3}, {.mul = 4}});
  CHECK(mentions(to_text({.systems = {system}}, false), "operations   bias: mul 3 -> 4\n"));
}

TEST_CASE("entries are grouped by system") {
  const std::string text = to_text(report_of_two(compared(spring(), spring("k*x^2"))), true);
  const std::string first = "             gravity = k*x -> 2*k*x, difference k*x\n";
  CHECK(mentions(text, "\nspring\n" + first));
  CHECK(mentions(text, "\nother\n" + first));
}

TEST_CASE("in Markdown equations are code blocks, and all entries are folded") {
  const std::string text = to_markdown({.systems = {compared(spring(), spring("k*x^2"))}});
  CHECK(starts_with(text, "### elgen diff: different (the equations differ)\n\n```text\nchanged "));
  CHECK(mentions(text, "\n```\n\n<details><summary>Entries of spring</summary>\n\n```text\n"));
  CHECK(text.ends_with("\n```\n\n</details>\n"));
}

TEST_CASE("back-ticks in a text do not end its code block") {
  SystemChange system{.impact = Impact::values};
  system.keys.push_back({.entry = "[model]", .path = {{"doc"}}, .after = "```"});
  CHECK(mentions(to_markdown({.systems = {system}}), "\n````text\n"));
}

TEST_CASE("without differences Markdown has only a heading") {
  CHECK(to_markdown({}) == "### elgen diff: equal (the equations are the same)\n");
}

TEST_CASE("changes in JSON have stable ids and positions") {
  const auto json = nlohmann::json::parse(
      to_json({.systems = {compared(cart, replaced(cart, "\"-g\"", "\"g\""))}}));
  CHECK(json.at("format") == "elgen diff 1");
  CHECK(json.at("impact") == "different");
  const auto& system = json.at("systems").at(0);
  const auto& key = system.at("keys").at(0);
  CHECK(key.at("id") == "[gravity]/vector[2]");
  CHECK(key.at("new_place").at("line") == 56);
  const auto& output = system.at("outputs").at(0);
  CHECK(output.at("name") == "gravity");
  const auto& change = output.at("changes").at(0);
  CHECK(change.at("id") == "gravity[2]");
  CHECK(change.at("verdict") == "different");
  CHECK(change.at("difference") == "2*m*l*g*sin(theta)");
  CHECK(change.at("witness").at("at") == "theta = 1.68");
}

TEST_CASE("in JSON an equal entry says if it is proved, and missing values are null") {
  const auto json = nlohmann::json::parse(
      to_json({.systems = {compared(spring("k*(1 - cos(x))"), spring("2*k*sin(x/2)^2"))},
               .added = {"a.toml"}}));
  const auto& change = json.at("systems").at(0).at("outputs").at(0).at("changes").at(0);
  CHECK(change.at("verdict") == "equal");
  CHECK(change.at("proved") == true);
  CHECK(json.at("added").at(0) == "a.toml");
}

TEST_CASE("an annotation is at the position of its cause") {
  CHECK(to_annotations({.systems = {compared(cart, replaced(cart, "\"-g\"", "\"g\""))}}) ==
        "::warning file=model.toml,line=56,col=17,title=elgen diff%3A different (the equations "
        "differ)::[gravity] vector[2]: -g -> g\n");
  CHECK(starts_with(
      to_annotations({.systems = {compared(spring("k*(1 - cos(x))"), spring("2*k*sin(x/2)^2"))}}),
      "::notice file="));
}

TEST_CASE("a broken, removed or unreadable system is one annotation with the reason") {
  const std::string reversed = replaced(replaced(spring(), "k = 3\n", ""), "m = {", "k = 3\nm = {");
  const DiffReport report{.systems = {compared(spring(), reversed)},
                          .removed = {"old.toml"},
                          .unreadable = {{"new.toml", {Code::E201, {}, "unknown name `z`"}}}};
  const std::string text = to_annotations(report);
  CHECK(count(text, "::error ") == 3);
  CHECK(starts_with(text, "::error file=model.toml,"));
  CHECK(mentions(
      text,
      ",title=elgen diff%3A breaks::spring: the members of Parameters changed their order: "
      "m, k -> k, m; callers still compile but with another meaning\n"));
  CHECK(mentions(text, "::error title=elgen diff%3A breaks::old.toml is removed\n"));
  CHECK(
      mentions(text, "::error title=elgen diff%3A unreadable::new.toml: E201: unknown name `z`\n"));
}

TEST_CASE("ten causes are annotated, the last annotation counts the others") {
  SystemChange system{.impact = Impact::different};
  for (int i = 0; i < 12; ++i) {
    system.keys.push_back({.entry = "[model]", .path = {{std::to_string(i)}}, .after = "1"});
  }
  const std::string text = to_annotations({.systems = {system, system}});
  CHECK(count(text, "\n") == 10);
  CHECK(mentions(text, "::3 keys more changed\n"));
}
