// Shard files: what is no such file is told; most of what does not fit together in tests/errors.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/shell.hpp"

namespace elgen::test {

TEST_CASE("a file with a part missing is no shard") {
  const Workspace workspace;
  const auto whole = nlohmann::ordered_json::parse(R"({
    "format": "elgen shard 1", "job": "verify", "version": "0.1.0", "limits": "",
    "model": {"path": "m.toml", "text": "x"}, "scene": null, "shard": [1, 2],
    "machine": {"compiler": "g", "command": "c", "processor": "A", "c_library": "l"},
    "samples": 3000, "seed": 1, "screened": []})");
  const auto merge = [&workspace](const std::string& text) {
    write_text(workspace.path() / "a.json", text);
    const Outcome outcome = shell("elgen verify --merge a.json", workspace.path());
    CHECK(outcome.status == 2);
    return outcome.errors;
  };
  CHECK(mentions(merge(whole.dump()), "error[E711]: shard 2/2 is missing\n"));
  for (const auto& [key, value] : whole.items()) {
    nlohmann::ordered_json part = whole;
    part.erase(key);
    INFO(key);
    CHECK(mentions(merge(part.dump()), "error[E712]: `a.json` is not a shard\n"));
  }
  CHECK(mentions(merge(whole.dump() + "]"), "error[E712]: `a.json` is not a shard\n"));
}

}  // namespace elgen::test
