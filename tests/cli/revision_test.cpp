// Files of a git revision, in environments that change the behaviour of git.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

namespace {

const std::string commit = "git add -A . && git -c user.name=a -c user.email=a@b commit -q -m x";
const std::string turned = "sed -i 's/\"-g\"/\"g\"/' ";

/// A repository with the cart below `folder`; gravity was reversed after the commit.
class Repository : public Workspace {
 public:
  explicit Repository(const std::string& folder = "repository", const std::string& before = "true")
      : root_(path() / folder) {
    std::filesystem::create_directories(root_ / "m");
    test::prepare("git init -q && " + before + " && cp " + models + "/cart_pole.toml m && " +
                      commit + " && " + turned + "m/cart_pole.toml",
                  root_);
  }
  [[nodiscard]] Outcome run(const std::string& command) const { return shell(command, root_); }
  [[nodiscard]] const std::filesystem::path& root() const { return root_; }

 private:
  std::filesystem::path root_;
};

void expect_difference(const Outcome& outcome) {
  INFO(outcome.output << outcome.errors);
  CHECK(outcome.status == 1);
  CHECK(mentions(outcome.output, ".toml:56:17  [gravity] vector[2]: -g -> g\n"));
}

void expect_refused(const Outcome& outcome, const std::string& words) {
  INFO(outcome.output << outcome.errors);
  CHECK(outcome.status == 4);
  CHECK(outcome.output.empty());
  CHECK(mentions(outcome.errors, "error[E713]: "));
  CHECK(mentions(outcome.errors, words));
}

}  // namespace

TEST_CASE("a repository without models, and no repository") {
  const Workspace workspace;
  expect_refused(workspace.run("elgen diff --against HEAD"),
                 "the working directory is in no repository: fatal: not a git repository");
  workspace.prepare("git init -q && touch a");
  expect_refused(workspace.run("elgen diff --against HEAD"),
                 "`HEAD` is no revision: fatal: Needed a single revision");
  workspace.prepare(commit + " && cp " + models + "/cart_pole.toml .");
  const Outcome outcome = workspace.run("elgen diff --against HEAD");
  CHECK(outcome.status == 1);
  CHECK(starts_with(outcome.output, "added        cart_pole.toml\n"));
  CHECK(mentions(outcome.output, "extended     "));
}

TEST_CASE("paths in a revision follow the working tree, in whatever form they are given") {
  const Repository repository;
  const std::vector<std::string> commands{
      "elgen diff --against HEAD " + (repository.root() / "m/cart_pole.toml").string(),
      "elgen diff --against HEAD m/",
      "cd m && elgen diff --against HEAD ../m/cart_pole.toml",
      "cd m && elgen diff --against HEAD ..",
      "cd m && elgen diff --against HEAD",
      "ln -s m link && elgen diff --against HEAD link/cart_pole.toml"};
  for (const std::string& command : commands) {
    INFO(command);
    expect_difference(repository.run(command));
  }
  expect_refused(repository.run("elgen diff --against HEAD " + models + "/cart_pole.toml"),
                 "is outside of the repository");
  expect_refused(repository.run("elgen diff --against HEAD .."), "`..` is outside of the repos");
}

TEST_CASE("environment variables of git change no result") {
  const Repository repository;
  for (const std::string variables :
       {"GIT_TRACE=1", "GIT_TRACE_SETUP=1 GIT_TRACE_PACK_ACCESS=1", "GIT_LITERAL_PATHSPECS=1",
        "GIT_ICASE_PATHSPECS=1", "GIT_DIR=.git", "GIT_DIR=$PWD/.git GIT_WORK_TREE=$PWD",
        "TMPDIR=/nonexistent", "GIT_PAGER=false LC_ALL=C"}) {
    INFO(variables);
    expect_difference(repository.run(variables + " elgen diff --against HEAD"));
    expect_difference(repository.run(variables + " elgen diff --against HEAD m/cart_pole.toml"));
  }
  expect_refused(repository.run("cd m && GIT_DIR=../.git elgen diff --against HEAD"),
                 "for the root, because $GIT_DIR is set");
  expect_refused(repository.run("GIT_DIR=m elgen diff --against HEAD"), "not a git repository");
  expect_refused(repository.run("cd .git && elgen diff --against HEAD"), "work tree");
  expect_refused(repository.run("PATH=/nonexistent $ELGEN diff --against HEAD"),
                 "git could not be run");
}

TEST_CASE("a revision is one commit") {
  const Repository repository;
  for (const std::string name : {"^HEAD", "HEAD^{tree}", "HEAD..HEAD", "HEAD:m", "a b",
                                 "\"$(printf 'HEAD\\nHEAD')\"", "-q"}) {
    INFO(name);
    expect_refused(repository.run("elgen diff --against=" + name), "is no revision");
  }
  expect_refused(
      repository.run("git clone -q --bare . ../bare && cd ../bare && elgen diff --against HEAD"),
      "this operation must be run in a work tree");
  expect_difference(repository.run("elgen diff --against HEAD^0"));
}

TEST_CASE("attributes hide no files, and paths may contain line ends") {
  expect_difference(Repository("r", "echo '*.toml export-ignore -text' > .gitattributes")
                        .run("elgen diff --against HEAD"));
  expect_difference(Repository("a\nb").run("elgen diff --against HEAD m/cart_pole.toml"));
  expect_difference(Repository(" r").run("elgen diff --against HEAD m/cart_pole.toml"));
}

TEST_CASE("a missing object is an error") {
  const auto without = [](const std::string& object) {
    const Repository repository;
    prepare("o=$(git rev-parse " + object + ") && rm -f .git/objects/${o%${o#??}}/${o#??}",
            repository.root());
    return repository.run("elgen diff --against HEAD");
  };
  expect_refused(without("HEAD^{tree}"), "`HEAD` was not read: ");
  expect_refused(without("HEAD:m"), "`HEAD` was not read: ");
  CHECK(without("HEAD:m/cart_pole.toml").status == 4);
}

TEST_CASE("links of a revision lead to its files, and submodules have their own revisions") {
  const Repository repository(
      "r",
      "ln -s nothing.toml m/dangling.toml && ln -s round.toml m/round.toml && ln -s /etc/passwd "
      "m/out.toml && ln -s cart_pole.toml m/link.toml");
  expect_difference(repository.run("elgen diff --against HEAD"));
  expect_difference(repository.run("elgen diff --against HEAD m/link.toml"));
  prepare("git init -q sub && cd sub && cp ../m/cart_pole.toml . && " + commit + " && cd .. && " +
              commit,
          repository.root());
  expect_refused(repository.run("elgen diff --against HEAD sub/cart_pole.toml"),
                 "is in the submodule `sub`");
}

}  // namespace elgen::test
