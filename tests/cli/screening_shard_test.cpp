// Shards: joined they are what one process gives; what does not fit together is told.
#include <catch2/catch.hpp>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

const std::string verify_many = "elgen verify one.scene.toml --limit seconds=600 --samples 2001";

/// rotor.toml, one.scene.toml and both shards of it, a.json and b.json: made once.
const Workspace& original() {
  static const Workspace workspace;
  static const bool is_made = [] {
    const std::filesystem::path& path = workspace.path();
    write_text(path / "rotor.toml",
               "format = 1\n[model]\nname = \"rotor\"\n[[coordinate]]\nname = \"q\"\n"
               "unit = \"rad\"\n[parameters]\nJ = { value = 2, unit = \"kg*m^2\" }\n"
               "k = { value = 3, unit = \"J\" }\n"
               "[energy]\nT = \"1/2*J*dot(q)^2\"\nV = \"k*(1 - cos(q))\"\n");
    write_text(path / "one.scene.toml",
               "format = 1\nmodel = \"rotor.toml\"\nname = \"one\"\n[outputs]\ngravity = true\n");
    prepare(verify_many + " --shard 1/2 -o a.json", path);
    prepare(verify_many + " --shard 2/2 -o b.json", path);
    return true;
  }();
  REQUIRE(is_made);
  return workspace;
}

/// A copy of it to change.
class ScreeningShards {
 public:
  ScreeningShards() { prepare("cp " + original().path().string() + "/* .", path()); }

  [[nodiscard]] const std::filesystem::path& path() const { return workspace_.path(); }
  [[nodiscard]] Outcome run(const std::string& command) const { return shell(command, path()); }

 private:
  Workspace workspace_;
};

}  // namespace

TEST_CASE_METHOD(ScreeningShards, "shards joined are byte by byte what one process gives") {
  const Outcome one = run(verify_many + " -o one.txt");
  INFO(one.output + one.errors);
  REQUIRE(one.status == 0);
  prepare("rm rotor.toml one.scene.toml", path());  // the shards have all
  const Outcome merged =
      run("elgen verify --limit seconds=600 --merge b.json a.json -o merged.txt");
  INFO(merged.errors);
  CHECK(merged.status == 0);
  CHECK(merged.output == one.output);
  CHECK(read_text(path() / "merged.txt") == read_text(path() / "one.txt"));
}

TEST_CASE_METHOD(ScreeningShards, "missing and double shards, and other machines, are told") {
  CHECK(mentions(run("elgen verify --merge a.json").errors, "error[E711]: shard 2/2 is missing\n"));
  prepare("cp a.json c.json", path());
  CHECK(mentions(run("elgen verify --merge a.json b.json c.json").errors,
                 "error[E711]: shard 1/2 is there twice: `a.json`, `c.json`\n"));
  prepare(
      "for f in a b; do sed -i 's/\"processor\":\"[^\"]*\"/\"processor\":\"Z80\"/' $f.json; done",
      path());
  const Outcome other = run("elgen verify --merge a.json b.json");
  CHECK(other.status == 2);
  CHECK(
      mentions(other.errors, "error[E711]: the processor of `a.json` is not that here: `Z80`, `"));
}

TEST_CASE_METHOD(ScreeningShards, "a shard is not written over another file") {
  const Outcome refused = run(verify_many + " --shard 1/2 -o b.json");
  CHECK(refused.status == 4);
  CHECK(mentions(refused.errors, "error[E703]: `b.json` exists"));
}

}  // namespace elgen::test
