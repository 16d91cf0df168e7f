// Runs every command of the recipes for CI and containers in a repository, except commands that
// need a server. On the machine of the test curl copies a file, apt-get records its arguments, and
// the installation of elgen's package creates a link.
#include <catch2/catch.hpp>

#include "recipes/repository.hpp"
#include "support/installed.hpp"

namespace elgen::test {

namespace {

/// A project on a CI machine with only git and the programs that the recipe installs.
class Machine : public Repository {
 public:
  explicit Machine(const std::string& recipe) {
    run("mkdir -p home/bin home/scripts && echo elgen > home/package.deb");
    write("home/bin/curl", "#!/bin/sh\nwhile [ $# -gt 2 ]; do shift; done\ncp \"$2\" \"$1\"\n");
    write("home/bin/apt-get",
          "#!/bin/sh\necho \"$@\" >> ~/packages\n"
          "case $* in *./elgen.deb) ln -sf \"$ELGEN\" ~/bin/elgen ;; esac\n");
    // rm is a no-op, because the Containerfile would remove this machine's package lists.
    write("home/bin/rm", "#!/bin/sh\n");
    run("chmod +x home/bin/*");
    run("git update-ref refs/remotes/origin/main main && python3 '" + source() +
        "/tests/recipes/scripts' '" + source() + "/" + recipe + "' home/scripts");
  }

  /// Runs step `name` in a new shell, after the commands `variables` and with the variables that
  /// earlier steps wrote to $GITHUB_ENV.
  [[nodiscard]] Outcome step(const std::string& name, const std::string& variables = "") const {
    return outcome(
        "export ELGEN_PACKAGE=\"$HOME/package.deb\" GITHUB_BASE_REF=main "
        "GITHUB_ENV=\"$HOME/env\" GITHUB_STEP_SUMMARY=\"$HOME/summary\"\n"
        "ELGEN_SHA256=$(sha256sum < \"$ELGEN_PACKAGE\" | cut -d ' ' -f 1)\nexport ELGEN_SHA256\n"
        "touch \"$GITHUB_ENV\"\nset -a\n. \"$GITHUB_ENV\"\nset +a\n" +
        variables + "\nPATH=\"$HOME/bin:/usr/bin:/bin\"\nsh 'home/scripts/" + name + "'");
  }

  /// True if apt-get was called with the package of elgen.
  [[nodiscard]] bool has_elgen() const {
    return mentions(outcome("cat home/packages").output, "./elgen.deb");
  }

  static bool is_readable() { return is_installed("python3-yaml", "python3 -c 'import yaml'"); }

 private:
  static std::string source() { return ELGEN_SOURCE_DIR; }
};

/// Shell assignment of a checksum that differs from the checksum of the package.
const std::string wrong_sum = "ELGEN_SHA256=" + std::string(64, '0');

constexpr const char* flip = "s/\"-g\"/\"g\"/";
constexpr const char* rename = "s/^name *= \"u\"/name = \"F\"/";

}  // namespace

TEST_CASE("the GitHub workflow summarises, annotates and checks a pull request") {
  if (!Machine::is_readable()) return;
  const Machine machine("recipes/github/elgen.yml");
  machine.branch("topic", flip);
  CHECK(machine.step("Install git and curl").status == 0);
  CHECK(mentions(machine.read("home/packages"), "ca-certificates curl git"));
  CHECK(machine.step("Install elgen", wrong_sum).status != 0);
  CHECK_FALSE(machine.has_elgen());
  CHECK(machine.step("Install elgen").status == 0);
  CHECK(machine.has_elgen());
  CHECK(machine.step("Find what is compared").status == 0);
  CHECK(machine.step("Summarise the equations").status == 0);
  CHECK(mentions(machine.read("home/summary"), "gravity"));
  const Outcome annotated = machine.step("Annotate the models");
  CHECK(annotated.status == 0);
  CHECK(mentions(annotated.output, "file=models/cart_pole.toml,line=56"));
  CHECK(machine.step("Check what is generated").status == 0);

  machine.run("sed -i 's/9.81, /9.8, /' models/cart_pole.toml");
  CHECK(machine.step("Check what is generated").status != 0);
  machine.run("git checkout -q .");
  machine.branch("breaking", rename);
  CHECK(machine.step("Summarise the equations").status == 0);
  const Outcome broken = machine.step("Annotate the models");
  CHECK(broken.status == 1);
  CHECK(mentions(broken.output,
                 "title=elgen diff%3A breaks::cart_pole: the inputs or their order changed"));
}

TEST_CASE("the GitLab job compares and checks a merge request") {
  if (!Machine::is_readable()) return;
  const Machine machine("recipes/gitlab/elgen.yml");
  const std::string base = "export CI_MERGE_REQUEST_DIFF_BASE_SHA=\"$(git rev-parse main)\"";
  machine.branch("topic", flip);
  CHECK(machine.step("elgen", base + "\n" + wrong_sum).status != 0);
  CHECK_FALSE(machine.has_elgen());
  CHECK(machine.step("elgen", base).status == 0);
  CHECK(machine.has_elgen());
  CHECK(mentions(machine.read("equations.md"), "gravity"));
  machine.branch("breaking", rename);
  CHECK(machine.step("elgen", base).status == 1);
  machine.run("sed -i 's/cos(theta)\"/cos(thet)\"/' models/cart_pole.toml");
  CHECK(machine.step("elgen", base).status != 0);
}

TEST_CASE("the galleries of GitHub and GitLab have a page and a picture of each model") {
  if (!Machine::is_readable()) return;
  const auto check_site = [](const Machine& machine) {
    CHECK(machine.outcome("ls public").output == "cart_pole.html\ncart_pole.svg\nindex.html\n");
    const std::string index = machine.read("public/index.html");
    CHECK(mentions(index,
                   "<a href=\"cart_pole.html\"><img src=\"cart_pole.svg\" alt=\"\" "
                   "loading=\"lazy\"><span>Cart and pole with a force on the cart</span>"
                   "<code>cart_pole</code></a>"));
    CHECK(mentions(index, "<style>\n:root {"));
    CHECK_FALSE(mentions(index, "broken"));
  };
  const std::string more = "echo 'format = 2' > models/broken.toml";
  const Machine github("recipes/github/pages.yml");
  github.run(more);
  CHECK(github.step("Install elgen").status == 0);
  CHECK(github.step("Make the gallery", "export TIME=1").status == 0);
  check_site(github);
  const Machine gitlab("recipes/gitlab/pages.yml");
  gitlab.run(more);
  CHECK(gitlab.step("pages", "export TIME=1").status == 0);
  check_site(gitlab);
  gitlab.run("rm -r public models/cart_pole.toml");
  CHECK(gitlab.step("pages", "export TIME=1").status == 1);
}

TEST_CASE("the image installs a package only if its checksum is right") {
  if (!Machine::is_readable()) return;
  const Machine machine("recipes/container/Containerfile");
  machine.run("cp home/package.deb elgen.deb");
  CHECK(machine.step("RUN", wrong_sum).status != 0);
  CHECK(machine.outcome("test -e home/packages").status != 0);
  CHECK(failure_of(machine.step("RUN")) == "");
  CHECK(machine.has_elgen());
}

TEST_CASE("the hooks of pre-commit generate and check the files in the index") {
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
