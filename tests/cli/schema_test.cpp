// elgen schema: the schemas accept the inputs that elgen reads. Debian's python3-jsonschema
// validates the inputs, if installed.
#include <catch2/catch.hpp>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/cli_testing.hpp"
#include "elgen/syntax.hpp"

namespace elgen::test {
namespace {

/// `validator_script SCHEMA FILE...` validates TOML files. Prints the errors and exits with 1 if
/// there are any.
constexpr const char* validator_script = R"(import json, sys, tomllib
import jsonschema
schema = json.load(open(sys.argv[1]))
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)
wrong = 0
for path in sys.argv[2:]:
    for error in validator.iter_errors(tomllib.loads(open(path, encoding="utf-8").read())):
        wrong = 1
        print(f"{path}: {error.json_path}: {error.message[:200]}")
sys.exit(wrong)
)";

/// The first Python with jsonschema and tomllib; empty if none.
std::string python_with_jsonschema() {
  const Workspace workspace;
  for (const std::string python : {"python3", "/usr/bin/python3"}) {
    const std::string question = python + " -c 'import jsonschema, tomllib'";
    if (workspace.run(question).status == 0) return python;
  }
  std::cout << "skipped: python3-jsonschema is not installed\n";
  return {};
}

/// The output of `elgen schema NAME`.
std::string schema_of(const std::string& name) {
  const Workspace workspace;
  return workspace.run("elgen schema " + name).output;
}

/// A workspace with the validator and a schema.
class SchemaValidation : public Workspace {
 public:
  explicit SchemaValidation(const std::string& schema) : python_(python_with_jsonschema()) {
    write("judge.py", validator_script);
    write("schema.json", schema);
  }

  void accepts(const std::string& files) const {
    if (python_.empty()) return;
    CHECK(failure_of(judged(files)) == "");
  }

  void refuses(const std::string& file, const std::string& place) const {
    if (python_.empty()) return;
    const Outcome outcome = judged(file);
    INFO(outcome.errors);
    CHECK(outcome.status == 1);
    CHECK(mentions(outcome.output, file + ": " + place + ": "));
  }

 private:
  [[nodiscard]] Outcome judged(const std::string& files) const {
    return run(python_ + " judge.py schema.json " + files);
  }

  std::string python_;
};

}  // namespace

TEST_CASE("all models and scenes satisfy their schemas") {
  SchemaValidation(schema_of("model"))
      .accepts(models + "/*.toml " ELGEN_SOURCE_DIR "/tests/urdf/golden/*.toml");
  SchemaValidation(schema_of("scene")).accepts(models + "/scenes/*.toml");
}

TEST_CASE("the schema of models refuses an unknown key, a missing key and a wrong word") {
  const SchemaValidation workspace(schema_of("model"));
  const std::string cart = model_file("cart_pole");
  const auto edited = [&](const std::string& part, const std::string& other) {
    workspace.write("m.toml", replaced(cart, part, other));
  };
  edited("format = 1", "fromat = 1");
  workspace.refuses("m.toml", "$");
  edited("name        = \"cart_pole\"", "");
  workspace.refuses("m.toml", "$.model");
  edited("[gravity]", "[[gravity]]");
  workspace.refuses("m.toml", "$.gravity");
  edited("[[coordinate]]", "[[coordinate]]\nkind = \"angle\"");
  workspace.refuses("m.toml", "$.coordinate[0].kind");
}

TEST_CASE("the schema has every key with its choices and documentation") {
  const auto model = nlohmann::json::parse(schema_of("model"));
  const auto& frame = model.at("properties").at("frame").at("items").at("properties");
  for (const KeyRow& row : key_table()) {
    if (row.entry != "frame") continue;
    INFO(row.key);
    const std::string text = frame.at(std::string(row.key)).at("description");
    CHECK(text.starts_with(row.doc));
    CHECK(text.ends_with(row.details));
  }
  CHECK(frame.at("dh").at("properties").at("convention").at("enum") ==
        nlohmann::json{"standard", "modified"});
  const auto scene = nlohmann::json::parse(schema_of("scene"));
  CHECK(scene.at("properties")
            .at("outputs")
            .at("anyOf")
            .at(0)
            .at("properties")
            .contains("mass_matrix"));
  CHECK_FALSE(scene.at("properties").at("numeric").at("properties").contains("check"));
  CHECK(scene.at("properties").at("frame").at("items").at("properties") == frame);
}

TEST_CASE("an unknown schema is refused") {
  const Outcome outcome = run("elgen schema modle");
  CHECK(outcome.status == 2);
  CHECK(outcome.output.empty());
}

}  // namespace elgen::test
