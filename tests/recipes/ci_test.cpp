// Every command of the recipes for CI, in a repository, up to what needs a server: packages are not
// installed, and elgen is not built but linked.
#include <catch2/catch.hpp>
#include <iostream>

#include "recipes/repository.hpp"

namespace elgen::test {

namespace {

/// A project on a machine of a service: nothing but git and what the recipe installs.
class Machine : public Repository {
 public:
  explicit Machine(const std::string& recipe) {
    run("mkdir -p home/bin home/source home/scripts");
    write("home/bin/apt-get", "#!/bin/sh\necho \"$@\" >> ~/packages\n");
    write("home/source/bootstrap",
          "#!/bin/sh\ncd \"$(dirname \"$0\")\" && mkdir -p build/release && "
          "ln -sf \"$ELGEN\" build/release/elgen\n");
    run("chmod +x home/bin/apt-get home/source/bootstrap && cd home/source && git init -q && "
        "git add . && git commit -q -m elgen");
    run("git update-ref refs/remotes/origin/main main && python3 '" + source() +
        "/tests/recipes/scripts' '" + source() + "/" + recipe + "' home/scripts");
  }

  /// Each step is a shell of its own, which gets what those before it wrote into files.
  [[nodiscard]] Outcome step(const std::string& name, const std::string& variables = "") const {
    return outcome(
        "export ELGEN_REPOSITORY=\"$HOME/source\" GITHUB_BASE_REF=main GITHUB_ENV=\"$HOME/env\" "
        "GITHUB_PATH=\"$HOME/path\" GITHUB_STEP_SUMMARY=\"$HOME/summary\"\n"
        "touch \"$GITHUB_ENV\" \"$GITHUB_PATH\"\nset -a\n. \"$GITHUB_ENV\"\nset +a\n" +
        variables + "\nPATH=\"$(tr '\\n' : < \"$GITHUB_PATH\")$HOME/bin:/usr/bin:/bin\"\n" +
        "sh 'home/scripts/" + name + "'");
  }

  static bool is_readable() {
    if (shell("python3 -c 'import yaml'", "/").status == 0) return true;
    std::cout << "skipped: python3-yaml is not installed\n";
    return false;
  }

 private:
  static std::string source() { return ELGEN_SOURCE_DIR; }
};

constexpr const char* flip = "s/\"-g\"/\"g\"/";
constexpr const char* rename = "s/^name *= \"u\"/name = \"F\"/";

}  // namespace

TEST_CASE("the workflow of GitHub summarises, annotates and checks a pull request") {
  if (!Machine::is_readable()) return;
  const Machine machine("recipes/github/elgen.yml");
  machine.branch("topic", flip);
  CHECK(machine.step("Install git").status == 0);
  CHECK(mentions(machine.read("home/packages"), "ca-certificates git"));
  CHECK(machine.step("Build elgen").status == 0);
  CHECK(machine.step("Find what is compared").status == 0);
  CHECK(machine.step("Summarise the equations").status == 0);
  CHECK(mentions(machine.read("home/summary"), "gravity"));
  const Outcome annotated = machine.step("Annotate the models");
  CHECK(annotated.status == 0);
  CHECK(mentions(annotated.output, "file=models/cart_pole.toml,line=55"));
  CHECK(machine.step("Check what is generated").status == 0);

  machine.run("sed -i 's/9.81, /9.8, /' models/cart_pole.toml");
  CHECK(machine.step("Check what is generated").status != 0);
  machine.run("git checkout -q .");
  machine.branch("breaking", rename);
  CHECK(machine.step("Summarise the equations").status == 0);
  const Outcome broken = machine.step("Annotate the models");
  CHECK(broken.status == 1);
  CHECK(mentions(broken.output, "title=elgen diff%3A breaks::cart_pole: inputs are other ones"));
}

TEST_CASE("the job of GitLab compares and checks a merge request") {
  if (!Machine::is_readable()) return;
  const Machine machine("recipes/gitlab/elgen.yml");
  const std::string base = "export CI_MERGE_REQUEST_DIFF_BASE_SHA=\"$(git rev-parse main)\"";
  machine.branch("topic", flip);
  CHECK(machine.step("elgen", base).status == 0);
  CHECK(mentions(machine.read("equations.md"), "gravity"));
  machine.branch("breaking", rename);
  CHECK(machine.step("elgen", base).status == 1);
  machine.run("sed -i 's/cos(theta)\"/cos(thet)\"/' models/cart_pole.toml");
  CHECK(machine.step("elgen", base).status != 0);
}

TEST_CASE("the hooks of pre-commit generate and check what is in the index") {
  if (!Machine::is_readable()) return;
  const Machine machine(".pre-commit-hooks.yaml");
  const auto hook = [&machine](const std::string& id) {
    return machine.step(id, "ln -sf \"$ELGEN\" ~/bin/elgen").status;
  };
  CHECK(hook("elgen-check") == 0);
  machine.run("sed -i '" + std::string(flip) + "' models/cart_pole.toml");
  CHECK(hook("elgen-check") != 0);
  CHECK(hook("elgen-generate") == 0);
  CHECK(hook("elgen-check") == 0);
  CHECK(machine.outcome("git diff --name-only generated").output.size() > 0);
  machine.run("git rm -q --cached -r models");
  CHECK(hook("elgen-check") == 0);
}

}  // namespace elgen::test
