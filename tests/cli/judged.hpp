// Files judged by a JSON Schema: by Debian's python3-jsonschema, where it is installed.
#pragma once

#include <catch2/catch.hpp>
#include <iostream>
#include <string>

#include "support/shell.hpp"

namespace elgen::test {

/// Judges files of TOML by a schema: `judge SCHEMA FILE...`. Prints what is wrong and exits with 1.
inline constexpr const char* judge = R"(import json, sys, tomllib
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

/// The first Python that can judge; empty where there is none.
inline std::string judging_python() {
  const Workspace workspace;
  for (const std::string python : {"python3", "/usr/bin/python3"}) {
    const std::string question = python + " -c 'import jsonschema, tomllib'";
    if (shell(question, workspace.path()).status == 0) return python;
  }
  std::cout << "skipped: python3-jsonschema is not installed\n";
  return {};
}

/// What `elgen schema NAME` prints.
inline std::string schema_of(const std::string& name) {
  const Workspace workspace;
  return shell("elgen schema " + name, workspace.path()).output;
}

/// A workspace with the judge and a schema.
class Judged : public Workspace {
 public:
  explicit Judged(const std::string& schema) : python_(judging_python()) {
    write_text(path() / "judge.py", judge);
    write_text(path() / "schema.json", schema);
  }

  void accepts(const std::string& files) const {
    if (python_.empty()) return;
    const Outcome outcome = judged(files);
    INFO(outcome.output << outcome.errors);
    CHECK(outcome.status == 0);
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
    return shell(python_ + " judge.py schema.json " + files, path());
  }

  std::string python_;
};

}  // namespace elgen::test
