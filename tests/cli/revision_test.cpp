// What git has of a revision.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

namespace {

const std::string commit = "git add . && git -c user.name=a -c user.email=a@b commit -q -m x";

}  // namespace

TEST_CASE("sidecars of a revision are compared with those that are there") {
  const Workspace workspace;
  prepare("git init -q && mkdir m && cp " + models +
              "/cart_pole.toml m && elgen generate -q m/cart_pole.toml && " + commit +
              " && sed -i 's/\"-g\"/\"g\"/' m/cart_pole.toml && elgen generate -q m/cart_pole.toml",
          workspace.path());
  const Outcome outcome = shell("elgen diff --against HEAD generated", workspace.path());
  CHECK(outcome.status == 1);
  CHECK(mentions(outcome.output, "changed      V = m*l*g*cos(theta) -> -m*l*g*cos(theta)"));
}

TEST_CASE("a repository without models, and no repository") {
  const Workspace workspace;
  CHECK(mentions(shell("elgen diff --against HEAD", workspace.path()).errors,
                 "error[E713]: there is no repository here"));
  prepare("git init -q && touch a", workspace.path());
  CHECK(mentions(shell("elgen diff --against HEAD", workspace.path()).errors,
                 "error[E713]: `HEAD` is no revision"));
  prepare(commit + " && cp " + models + "/cart_pole.toml .", workspace.path());
  const Outcome outcome = shell("elgen diff --against HEAD", workspace.path());
  CHECK(outcome.status == 1);
  CHECK(starts_with(outcome.output, "added        cart_pole.toml\n"));
  CHECK(mentions(outcome.output, "extended     "));
}

}  // namespace elgen::test
