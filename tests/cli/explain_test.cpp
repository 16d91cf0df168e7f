// elgen explain: a text for every code, and the keys of every entry.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/reason.hpp"
#include "cli/cli_testing.hpp"
#include "elgen/diagnostic.hpp"
#include "elgen/functions.hpp"
#include "elgen/outputs.hpp"
#include "elgen/syntax.hpp"

namespace elgen::test {

TEST_CASE("explain knows every code") {
  for (const CodeRow& row : code_table()) {
    const Outcome outcome = run("elgen explain " + std::string(row.name));
    INFO(row.name);
    CHECK(outcome.status == 0);
    CHECK(mentions(outcome.output, std::string(row.title)));
  }
  const Outcome unknown = run("elgen explain E999");
  CHECK(unknown.status == 2);
  CHECK(unknown.output.empty());
}

TEST_CASE("explain lists the reasons of a code") {
  const std::string text = run("elgen explain E112").output;
  const auto json = nlohmann::json::parse(run("elgen explain E112 --format json").output);
  REQUIRE(json.at("reasons").size() == reasons_of(Code::E112).size());
  CHECK(mentions(
      text, "\n\nReasons:\n- A constraint must have exactly one of `equation` and `coincide`,"));
  CHECK(mentions(text, "\n- The lower bound of a range must be below its upper bound"));
  CHECK(json.at("reasons").at(0) == reasons_of(Code::E112).front());
  CHECK_FALSE(mentions(run("elgen explain E101").output, "Reasons"));
}

TEST_CASE("explain knows every entry and its keys") {
  for (const EntryRow& row : entry_table()) {
    if (!row.supported) continue;
    const Outcome outcome = run("elgen explain " + std::string(row.entry));
    INFO(row.entry);
    CHECK(outcome.status == 0);
    CHECK(mentions(outcome.output, std::string(row.doc)));
  }
  const std::string frame = run("elgen explain frame").output;
  for (const KeyRow& row : key_table()) {
    if (row.entry != "frame" && row.entry != "frame.dh") continue;
    CHECK(mentions(frame, "\n  " + std::string(row.key) + " "));
  }
  CHECK(mentions(frame, "\n  x_parent = translate + R x."));
  const std::string tool = run("elgen explain scene.frame").output;
  CHECK(tool.starts_with("[[frame]]: a tool, which is fixed to a frame of the model\n"));
  CHECK(tool.ends_with(frame));
}

TEST_CASE("explain accepts codes in any case, outputs and functions") {
  CHECK(run("elgen explain e201").output == run("elgen explain E201").output);
  CHECK(mentions(run("elgen explain mass_matrix").output, "mass_matrix: an output\n\n"));
  for (const OutputRow& row : output_table()) {
    if (row.is_user_output) continue;
    INFO(row.name);
    CHECK(mentions(run("elgen explain " + std::string(row.name)).output, std::string(row.doc)));
  }
  CHECK(run("elgen explain sin").output == "sin: a function of 1 argument\n");
  CHECK(mentions(run("elgen explain max").output,
                 "max: a function of 2 arguments, only allowed in forces"));
  CHECK(mentions(run("elgen explain E").output, "E: a name in [[expect]]\n\nIn `conserved`"));
  CHECK(mentions(run("elgen explain p").output, "`p(NAME)` is the momentum dL/d(dot(NAME))"));
  const auto json = nlohmann::json::parse(run("elgen explain atan2 --format json").output);
  CHECK(json.at("arguments") == 2);
  CHECK(mentions(run("elgen explain mass_matri").errors, "did you mean `mass_matrix`?"));
}

TEST_CASE("explain knows expanded functions, keys and commands") {
  CHECK(run("elgen explain dot").output ==
        "dot: a function of expressions\n\ndot(e): total time derivative\n");
  CHECK(run("elgen explain x").output ==
        "x: a function of expressions\n\nx(P): world coordinate x of the place P\n");
  CHECK(run("elgen explain simulate").output ==
        "simulate: a command\n\n`elgen simulate --help` lists its options.\n");
  const std::string unit = run("elgen explain unit").output;
  CHECK(mentions(unit, "[[coordinate]]: "));
  CHECK(mentions(unit, "\n  unit "));
  CHECK_FALSE(mentions(unit, "\n  name "));
  const auto json = nlohmann::json::parse(run("elgen explain dist2 --format json").output);
  CHECK(json.at("usage") == "dist2(P, Q)");
  CHECK(nlohmann::json::parse(run("elgen explain show --format json").output).at("name") == "show");
  for (const CallRow& row : call_table()) {
    INFO(row.name);
    CHECK(mentions(run("elgen explain " + std::string(row.name)).output, std::string(row.doc)));
  }
  CHECK(run("elgen explain simulat").errors ==
        "elgen: error[E913]: `simulat` is no code, entry, key, output, function or command\n"
        "      did you mean `simulate`?\n");
}

TEST_CASE("an entry is explained with its tables, types of values and choices") {
  CHECK(run("elgen explain scene.emit").output == R"text([emit]: the emitted code

  language       one of                   language of the emitted code ("c++17", "c99", "python", "matlab", "javascript"); default: "c++17"
  namespace      text                     C++ namespace, or prefix of names in C; default: MODEL_NAME
                 Interpreted languages exclude this key (E611).
  eigen          true or false            also emits functions on Eigen types; default: false
                 The key needs C++ (E611).
  batch          true or false            also emits functions on arrays; default: false
                 Each array holds the values of many states. The key needs C++ (E611), and float or
                 double (E625).
  storage        one of                   order of matrix entries in arrays ("row-major", "column-major"); default: "row-major"
                 Interpreted languages use their own matrices, so they exclude this key (E611).
  files          word, or list of         files that are written ("header", "equations", "page"); default: all
                 "header" is required (E112). "equations" is NAME.equations.json, "page" is NAME.md.
)text");
  const Outcome unknown = run("elgen explain coordinat");
  CHECK(unknown.status == 2);
  CHECK(mentions(unknown.errors, "did you mean `coordinate`?"));
}

TEST_CASE("codes and keys are available as JSON") {
  const auto code = nlohmann::json::parse(run("elgen explain E201 --format json").output);
  CHECK(code.at("severity") == "error");
  CHECK(code.at("exit_code") == 2);
  CHECK(code.at("title") == "unknown name");
  const auto keys = nlohmann::json::parse(run("elgen explain scene.emit --format json").output);
  REQUIRE(keys.size() == 6);
  CHECK(keys.at(0).at("key") == "language");
  CHECK(keys.at(0).at("default") == "\"c++17\"");
  CHECK(keys.at(1).at("details") == "Interpreted languages exclude this key (E611).");
  CHECK(keys.at(0).at("words") == nlohmann::json{"c++17", "c99", "python", "matlab", "javascript"});
}

}  // namespace elgen::test
