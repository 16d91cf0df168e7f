// Keys of one table: unknown, missing and unsupported keys, words outside a choice, and
// repetitions.
#include <algorithm>
#include <catch2/catch.hpp>

#include "parse/entry_reader.hpp"
#include "parse_testing.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string model(std::string_view rest) {
  return "format = 1\nmodel.name = \"m\"\n[[coordinate]]\nname = \"x\"\n" + std::string(rest);
}

std::string scene(std::string_view rest) {
  return "format = 1\nmodel = \"m.toml\"\nname = \"s\"\n" + std::string(rest);
}

std::string repetition(std::string_view value) {
  const std::string all = model_answer(model("for = " + std::string(value)));
  const std::size_t begin = all.find("for = ");
  return begin == std::string::npos ? all : all.substr(begin + 6, all.size() - begin - 7);
}

std::string condition(std::string_view value) {
  const std::string all =
      model_answer(model("[[equilibrium]]\nname = \"e\"\nat = {}\nwhen = " + std::string(value)));
  const std::size_t begin = all.find("when = ");
  return begin == std::string::npos ? all : all.substr(begin + 7, all.size() - begin - 8);
}

/// The codes reported for one key of an entry, without E105 for other missing keys.
std::vector<Code> codes_of(const KeyRow& row, const std::string& value) {
  const std::string key = row.key == "*" ? "any_name" : std::string(row.key);
  const SourcePointer source = make_source("test", key + " = " + value);
  const auto root = read_toml(*source);
  REQUIRE(root);
  const Limits limits;
  FileReadState reading{limits};
  const TableContext table{std::string(row.entry), "the entry", {source.get(), 0, 0}};
  const auto keys = read_keys(root->entries, table, reading);
  std::vector<Code> codes;
  for (const Diagnostic& d : reading.diagnostics) {
    if (d.code != Code::E105) codes.push_back(d.code);
  }
  CHECK(keys.size() == (row.supported ? 1 : 0));
  return codes;
}

/// Values of several kinds; accepted_by() lists the samples that a key type accepts.
struct Samples {
  std::string number = "1.5";
  std::string integer = "3";
  std::string name = "\"abc\"";
  std::string expression = "\"2*abc\"";
  std::string repetition = "\"i in 1..n\"";
  std::string boolean = "true";
  std::string list = "[1, \"x\"]";
  std::string matrix = "[[1], [\"x\"]]";
  std::string table = "{}";
};

/// The samples that this type accepts.
std::vector<std::string> accepted_by(KeyType type) {
  const Samples s;
  switch (type) {
    case KeyType::expression:
      return {s.number, s.integer, s.name, s.expression};
    case KeyType::expression_list:
      return {s.list};
    case KeyType::expression_or_list:
      return {s.number, s.integer, s.name, s.expression, s.list};
    case KeyType::expression_or_table:
      return {s.number, s.integer, s.name, s.expression, s.table};
    case KeyType::closed_form:
      return {s.number, s.integer, s.name, s.expression, s.list, s.matrix, s.table};
    case KeyType::name:
      return {s.name};
    case KeyType::text:
    case KeyType::latex_symbol:
    case KeyType::unit:
      return {s.name, s.expression, s.repetition};
    case KeyType::repetition:
      return {s.repetition};
    case KeyType::integer:
      return {s.integer};
    case KeyType::boolean:
      return {s.boolean};
    case KeyType::range:
      return {s.list};
    case KeyType::table:
      return {s.table};
    case KeyType::value_or_table:
      return {s.number, s.integer, s.name, s.expression, s.list, s.table};
    case KeyType::output_request:
      return {s.boolean, s.table};
    case KeyType::boolean_or_expression:
      return {s.boolean, s.number, s.integer, s.name, s.expression};
    case KeyType::text_or_table:
      return {s.name, s.expression, s.repetition, s.table};
    case KeyType::names_or_table:
      return {s.name, s.expression, s.repetition, s.table};
    case KeyType::choice:
    case KeyType::choice_list:
      return {};  // no sample is a word of a choice
    case KeyType::turns:
      return {};  // no sample is a list of pairs
    case KeyType::condition:
    case KeyType::equations:
      return {};  // no sample is a comparison or an equation
  }
  return {};
}

std::vector<std::string> all_samples() {
  const Samples s;
  return {s.number,  s.integer, s.name,   s.expression, s.repetition,
          s.boolean, s.list,    s.matrix, s.table};
}

}  // namespace

TEST_CASE("every key accepts the values of its type and rejects all others", "[parse]") {
  for (const KeyRow& row : key_table()) {
    const std::vector<std::string> accepted = accepted_by(row.type);
    for (const std::string& value : all_samples()) {
      INFO(row.entry << "." << row.key << " = " << value);
      const std::vector<Code> codes = codes_of(row, value);
      const bool fits = std::find(accepted.begin(), accepted.end(), value) != accepted.end();
      if (row.supported) {
        CHECK(codes.empty() == fits);
      } else {
        CHECK(codes == std::vector<Code>{Code::E108});
      }
    }
  }
}

TEST_CASE("every word of a choice is accepted", "[parse]") {
  for (const ChoiceRow& choice : choice_table()) {
    const auto row = std::find_if(key_table().begin(), key_table().end(), [&](const KeyRow& r) {
      return r.entry == choice.entry && r.key == choice.key;
    });
    REQUIRE(row != key_table().end());
    INFO(choice.entry << "." << choice.key << " = " << choice.word);
    const std::string word = "\"" + std::string(choice.word) + "\"";
    const bool list = row->type == KeyType::choice_list;
    CHECK(codes_of(*row, list ? "[" + word + "]" : word).empty());
  }
}

TEST_CASE("an unknown key is reported with the nearest known key", "[parse]") {
  const std::string text = model("ragne = [0, 1]\nnonsense = 1\n");
  CHECK(model_answer(text) == "E103 5:1\nE103 6:1");
  const Diagnostic error = first_error(text);
  CHECK(error.message == "unknown key `ragne` in `[[coordinate]]`");
  CHECK(error.hint == "did you mean `range`?");
  CHECK(model_answer(model("[parameters]\nm = {valeu = 1}\n")) == "E105 6:1\nE103 6:6");
}

TEST_CASE("a missing key is reported at the header of its table", "[parse]") {
  CHECK(model_answer(model("[[input]]\nunit = \"N\"\n")) == "E105 5:1");
  CHECK(first_error(model("[[input]]\n")).message == "no `name` in `[[input]]`");
  CHECK(model_answer(model("[[point]]\nname = \"P\"\n[[point]]\nat = [1, 2]\n")) ==
        "E105 5:1\nE105 7:1");
  CHECK(scene_answer(scene("[approximate]\norder = 1\n")) == "E105 4:1");
  CHECK(scene_answer(scene("[approximate]\n")) == "E105 4:1\nE105 4:1");
}

TEST_CASE("an unsupported key is reported, and keys that it would replace are not missed",
          "[parse]") {
  CHECK(scene_answer(scene("[numeric]\nform = \"closed\"\ncheck = {}\n")) == "E108 6:1");
  CHECK(scene_answer(scene("[outputs]\nbias = {form = \"shut\"}\n")) == "E104 5:17");
}

TEST_CASE("a choice accepts only the words of its table", "[parse]") {
  CHECK(mentions(model_answer(model("kind = \"scalar\"")), "kind = \"scalar\""));
  const std::string text = model("[parameters]\nm = {value = 1, assume = \"positiv\"}\n");
  CHECK(model_answer(text) == "E104 6:27");
  CHECK(first_error(text).message == "`positiv` where `positive` or `nonnegative` is expected");
  CHECK(scene_answer(scene("[numeric]\nscalar = [\"float\", \"half\"]\n")) == "E104 5:21");
  CHECK(mentions(scene_answer(scene("[numeric]\nscalar = \"float\"\n")), "scalar = [\"float\"]"));
  CHECK(scene_answer(scene("[numeric]\nscalar = \"half\"\n")) == "E104 5:11");
  CHECK(scene_answer(scene("[numeric]\nscalar = []\n")) == "E104 5:10");
}

TEST_CASE("closed forms are expressions, lists, matrices or entries", "[parse]") {
  const std::string text = model_answer(
      model("[[expect]]\nkinetic_energy = \"T0\"\ngravity = [\"0\", 1]\nmass_matrix = [[\"m\"]]\n"
            "drift_entry = {for = \"i in 1..n\", value = \"0\"}\nconserved = [\"E\"]\n"));
  CHECK(mentions(text,
                 "kinetic_energy = T0\n  gravity = [0, 1]\n  mass_matrix = [[m]]\n"
                 "  drift_entry = {for = [{index = i, low = 1, high = n}], value = 0}\n"
                 "  conserved = [E]\n"));
  CHECK(model_answer(model("[[expect]]\nmass_matrix = [[[1]]]\n")) == "E104 6:17");
  CHECK(model_answer(model("[[expect]]\nconserved = \"E\"\n")) == "E104 6:13");
}

TEST_CASE("parameters are numbers, strings, tables or sub-tables, in file order", "[parse]") {
  const std::string text =
      model_answer(model("[parameters]\nz = 1\nb = \"1/2\"\na = {value = [1, 2], size = \"n\"}\n"
                         "[parameters.m]\nvalue = 3\nunit = \"kg\"\n"));
  CHECK(mentions(text,
                 "  z = 1\n  b = (1 / 2)\n  a = {value = [1, 2], size = n}\n"
                 "  m = {value = 3, unit = \"kg\"}\n"));
  CHECK(model_answer(model("[parameters]\nm = true\n")) == "E104 6:5");
}

TEST_CASE("fixed is `all`, a list of names or a table", "[parse]") {
  CHECK(mentions(scene_answer(scene("[parameters]\nfixed = \"all\"\n")), "fixed = \"all\""));
  CHECK(mentions(scene_answer(scene("[parameters]\nfixed = {g = 9.81, l = \"1/2\"}\n")),
                 "fixed = {g = 9.81, l = (1 / 2)}"));
  CHECK(mentions(scene_answer(scene("[parameters]\nfixed = [\"g\", \"l\"]\n")),
                 "fixed = [\"g\", \"l\"]"));
  CHECK(scene_answer(scene("[parameters]\nfixed = [1]\n")) == "E104 5:10");
}

TEST_CASE("a parameter of a scene is fixed by `fixed`, as the hint says", "[parse]") {
  const auto hint = [](const std::string& keys) {
    return first_scene_error(scene("[parameters]\n" + keys)).hint;
  };
  CHECK(hint("g = 0\n") == "write `fixed = { g = 0 }`");
  CHECK(hint("l = \"1/2\"\n") == "write `fixed = { l = \"1/2\" }`");
  CHECK(hint("fixd = {g = 0}\n") == "did you mean `fixed`?");
}

TEST_CASE("a value is read as the table that it stands for", "[parse]") {
  const auto same_scene = [](const std::string& short_form, const std::string& table) {
    CHECK(scene_answer(scene(short_form)) == scene_answer(scene(table)));
    CHECK(scene_answer(scene(short_form))[0] != 'E');
  };
  same_scene("[lock]\ntheta = 0.3\n", "[lock]\ntheta = {value = 0.3}\n");
  same_scene("[lock]\ntheta = \"sin(t)\"\n", "[lock]\ntheta = {value = \"sin(t)\"}\n");
  same_scene("[lock]\nattitude = [1, 0, 0, 0]\n", "[lock]\nattitude = {value = [1, 0, 0, 0]}\n");
  same_scene("[outputs]\nstep = \"rk4\"\n", "[outputs]\nstep = {method = \"rk4\"}\n");
  same_scene("[outputs]\ngravity = \"closed\"\n", "[outputs]\ngravity = {form = \"closed\"}\n");
  CHECK(scene_answer("format = 1\nmodel = \"m.toml\"\nname = \"s\"\noutputs = [\"gravity\"]\n") ==
        scene_answer("format = 1\nmodel = \"m.toml\"\nname = \"s\"\n[outputs]\ngravity = true\n"));
  CHECK(mentions(model_answer(model("start = 0.3")), "start = {value = 0.3}"));
  CHECK(mentions(model_answer(model("start = [1, 0, 0, 0]")), "start = {value = [1, 0, 0, 0]}"));
  CHECK(model_answer(model("start = true")) == "E104 5:9");
  CHECK(model_answer(model("start = \"45 deg\"")) == "E303 5:13");
  CHECK(scene_answer(scene("[outputs]\nstep = 3\n")) == "E104 5:8");
  CHECK(first_scene_error(scene("[outputs]\nstep = 3\n")).message ==
        "number `3` where a string is expected");
  CHECK(scene_answer(scene("[outputs]\nbias = \"shut\"\n")) == "E104 5:9");
  CHECK(scene_answer("format = 1\nmodel = \"m.toml\"\nname = \"s\"\noutputs = [1]\n") ==
        "E104 4:11");
}

TEST_CASE("a repetition consists of an index and its bounds", "[parse]") {
  CHECK(repetition("\"i in 1..n\"") == "[{index = i, low = 1, high = n}]");
  CHECK(repetition("\"i in 0 .. 2*n - 1\"") == "[{index = i, low = 0, high = ((2 * n) + (-1))}]");
  CHECK(repetition("[\"i in 1..n\", \"j in i..n\"]") ==
        "[{index = i, low = 1, high = n}, {index = j, low = i, high = n}]");
}

TEST_CASE("malformed repetitions are rejected at their span", "[parse]") {
  CHECK(repetition("\"i in 1:n\"") == "E210 5:8");
  CHECK(repetition("\"i = 1..n\"") == "E210 5:8");
  CHECK(repetition("\"1..n\"") == "E210 5:8");
  CHECK(repetition("\"\"") == "E210 5:8");
  CHECK(repetition("3") == "E104 5:7");
  CHECK(repetition("\"i in ..n\"") == "E310 5:12");
  CHECK(repetition("\"i in 1..\"") == "E310 5:16");
  CHECK(repetition("\"i in 1..2n\"") == "E303 5:17");
  CHECK(repetition("\"i\\u0020in 1..2n\"") == "E303 5:22");
}

TEST_CASE("each part of a repetition has its span", "[parse]") {
  const SourcePointer source = make_source("test", model("for = \"i in 1..n\""));
  const auto parsed = parse_model(source, {});
  REQUIRE(parsed);
  const KeySyntax* key = parsed->entries.back().find("for");
  REQUIRE(key != nullptr);
  const auto& parts = key->value.items.at(0).entries;
  REQUIRE(parts.size() == 3);
  CHECK(covered_text(parts[0].value.span) == "i");
  CHECK(covered_text(parts[1].value.expression.span) == "1");
  CHECK(covered_text(parts[2].value.expression.span) == "n");
}

TEST_CASE("a condition consists of two expressions and a comparison", "[parse]") {
  CHECK(condition("\"R*Omega^2 > g\"") == "{left = (R * (Omega^2)), sign = \">\", right = g}");
  CHECK(condition("\"a<=b + 1\"") == "{left = a, sign = \"<=\", right = (b + 1)}");
  CHECK(condition("\"a >= 0\"") == "{left = a, sign = \">=\", right = 0}");
}

TEST_CASE("malformed conditions are rejected at their span", "[parse]") {
  CHECK(condition("\"a\"") == "E320 8:9");
  CHECK(condition("\"a = b\"") == "E320 8:9");
  CHECK(condition("\"\"") == "E320 8:9");
  CHECK(condition("\"a < b < c\"") == "E317 8:15");
  CHECK(condition("\"a => b\"") == "E317 8:11");
  CHECK(condition("\"> b\"") == "E310 8:9");
  CHECK(condition("\"a >\"") == "E310 8:12");
  CHECK(condition("\"2a > b\"") == "E303 8:10");
  CHECK(condition("3") == "E104 8:8");
}

TEST_CASE("the point of an expansion is a name or a table", "[parse]") {
  CHECK(mentions(scene_answer(scene("[approximate]\norder = 1\nabout = \"rest\"\n")),
                 "about = \"rest\""));
  CHECK(scene_answer(scene("[approximate]\norder = 1\nabout = [1]\n")) == "E104 6:9");
}
