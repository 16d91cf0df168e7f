// Shard files: what is no such file, or does not fit together, is told; most of it in tests/errors.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

/// Shards of tradeoff, of which the last one is empty: it takes no compiler to write one.
class Files {
 public:
  Files() {
    prepare("elgen tradeoff --shard 99/99 -o last.json " ELGEN_SOURCE_DIR
            "/models/simple_pendulum.toml",
            path());
  }

  [[nodiscard]] const std::filesystem::path& path() const { return workspace_.path(); }

  /// The last one as another one.
  void write(const std::string& file, std::uint64_t number, std::uint64_t count,
             const std::string& processor = "Z80") const {
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(read_text(path() / "last.json"));
    json["shard"] = {number, count};
    json["machine"]["processor"] = processor;
    write_text(path() / file, json.dump());
  }

  [[nodiscard]] Outcome merge(const std::string& files) const {
    return shell("elgen tradeoff --merge " + files, path());
  }

 private:
  Workspace workspace_;
};

}  // namespace

TEST_CASE_METHOD(Files, "missing and double shards are told, of many missing ones some") {
  write("a.json", 1, 3);
  write("b.json", 1, 3);
  const Outcome outcome = merge("a.json b.json");
  CHECK(outcome.status == 2);
  CHECK(outcome.errors ==
        "elgen: error[E711]: shard 1/3 is there twice: `a.json`, `b.json`\n"
        "elgen: error[E711]: shard 2/3 is missing\n"
        "elgen: error[E711]: shard 3/3 is missing\n");
  write("c.json", 1, 18446744073709551615U);
  CHECK(mentions(merge("c.json").errors, "shard 21/18446744073709551615 is missing\n"));
}

TEST_CASE_METHOD(Files, "other limits than here are told, but not those of time and memory") {
  write("a.json", 1, 1);
  CHECK(merge("a.json --limit seconds=7 --limit memory_mib=4000").status == 0);
  const Outcome outcome = merge("a.json --limit coordinates=7");
  CHECK(outcome.status == 2);
  CHECK(mentions(outcome.errors, "error[E711]: the limits of `a.json` is not that here: `"));
}

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
