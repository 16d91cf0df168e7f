// .ci/commits on a small repository: which messages are refused, and the texts of the errors.
#include <catch2/catch.hpp>
#include <utility>
#include <vector>

#include "support/shell.hpp"

namespace elgen::test {
namespace {

const std::string commits = ELGEN_SOURCE_DIR "/.ci/commits";
const std::string rooms =
    " is no room of src/layers.txt, no folder of the project or of tests/, and none of all, build, "
    "ci, bootstrap, README, CHANGELOG\n";

/// A repository with src/check, tests/cli, models, three rooms in src/layers.txt, and one commit on
/// `main`, tagged `base`. The user's configuration of git is home/.gitconfig.
class Project : public Workspace {
 public:
  Project() {
    prepare("mkdir -p home src/check tests/cli models");
    write("home/.gitconfig",
          "[user]\nname = a\nemail = a@b\n[init]\ndefaultBranch = main\n"
          "[advice]\ndetachedHead = false\n");
    write("src/layers.txt", "# the order: of folders\nbase : text\ncheck/names :\ncheck :\n");
    write("src/check/long.cpp", lines(150));
    write("tests/cli/a.txt", "");
    write("models/a.toml", "");
    write(".gitignore", "home\n");
    git("init -q && git add . && git commit -q -m 'all: begin' && git tag base");
  }

  static std::string lines(std::size_t number) {
    std::string text;
    for (std::size_t i = 0; i < number; ++i) text += "line " + std::to_string(i) + "\n";
    return text;
  }

  [[nodiscard]] Outcome outcome(const std::string& command) const {
    return run("export HOME='" + (path() / "home").string() +
               "' GIT_CONFIG_NOSYSTEM=1\nunset GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE "
               "GIT_CONFIG_GLOBAL\n" +
               command);
  }
  void git(const std::string& words) const {
    const Outcome done = outcome("git " + words);
    INFO(words + "\n" + done.output + done.errors);
    REQUIRE(done.status == 0);
  }

  /// Commits all changes; git leaves the message unchanged.
  void commit(const std::string& message) const {
    write("home/message", message);
    git("add . && git commit -q --allow-empty --cleanup=verbatim -F home/message");
  }

  /// The errors and warnings, without hashes, about empty commits with `messages`.
  [[nodiscard]] std::string findings_on(const std::vector<std::string>& messages) const {
    git("checkout -q --detach base");
    for (const std::string& message : messages) commit(message);
    return without_hashes(outcome(commits + " base").output);
  }

  /// `text` with HASH in place of the hash in "error: 1234abcd" and "warning: 1234abcd".
  [[nodiscard]] std::string without_hashes(const std::string& text) const {
    write("home/text", text);
    return run("sed -E 's/^(error|warning): [0-9a-f]{8} /\\1: HASH /' home/text").output;
  }
};

}  // namespace

TEST_CASE("a subject names up to two rooms and the change") {
  // The last subject has 72 characters, but more than 72 bytes.
  CHECK(Project().findings_on(
            {"check: refuse names", "names, base: refuse names", "check/names: let go of names",
             "tests: refuse names", "tests/cli: refuse names", "cli: refuse names", "models: add b",
             "README: say how", "readme: say how", "ci: refuse commits", "all: re-read rooms",
             "check: refuse üüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüü"}) ==
        "commits: 12, not upstream: 12, errors: 0\n");
}

TEST_CASE("any other subject is an error") {
  const std::string form = "the subject is not `room: verb …` or `room, room: verb …`\n";
  const std::vector<std::pair<std::string, std::string>> rows{
      {"wip", form},
      {"refuse names", form},
      {"check:refuse names", form},
      {"check : refuse names", form},
      {"check, base, names: refuse more", form},
      {"home: refuse names", "`home`" + rooms},
      {"check, kitchen: refuse names", "`kitchen`" + rooms},
      {"check: the names are refused", "`the` is no verb in lower case\n"},
      {"check: Refuse names", "`Refuse` is no verb in lower case\n"},
      {"check: names, types", "`names,` is no verb in lower case\n"},
      {"check: refuse what is longer than a line that users read in some git logs",
       "the subject has 73 characters, at most 72 are allowed\n"}};
  std::vector<std::string> subjects;
  std::string expected;
  for (const auto& [subject, what] : rows) {
    subjects.push_back(subject);
    expected += "error: HASH \"" + subject + "\": " + what;
  }
  CHECK(Project().findings_on(subjects) ==
        expected + "commits: 11, not upstream: 11, errors: 11\n");
}

TEST_CASE("a vague word in a subject is a warning") {
  const std::string name = "warning: HASH \"check: refuse each once, in its own room\": ";
  CHECK(Project().findings_on(
            {"check: refuse each once, in its own room", "check: refuse owned ones"}) ==
        name + "`own` is vague in a subject\n" + name +
            "`once` is vague in a subject\ncommits: 2, not upstream: 2, errors: 0\n");
}

TEST_CASE("more than 100 changed lines of source need a body with the reason") {
  const Project project;
  const std::string subject = "check: write more";
  const auto errors = [&](const std::string& file, std::size_t lines, const std::string& body) {
    project.git("checkout -q --detach base");
    project.write(file, Project::lines(lines));
    project.commit(subject + body);
    return project.without_hashes(project.outcome(commits + " base").output);
  };
  const std::string right = "commits: 1, not upstream: 1, errors: 0\n";
  const std::string wrong =
      "error: HASH \"check: write more\": 101 changed lines of source, above "
      "100 a body has to give the reason\n"
      "commits: 1, not upstream: 1, errors: 1\n";
  project.prepare("mkdir -p generated");
  for (const std::string file : {"src/check/a.cpp", "src/a.hpp", "src/a.def", "tests/a.py"}) {
    INFO(file);
    CHECK(errors(file, 101, "\n") == wrong);
  }
  CHECK(errors("src/a.hpp", 100, "\n") == right);
  CHECK(errors("src/a.hpp", 101, "\n\nSigned-off-by: a <a@b>\n") == wrong);
  CHECK(errors("src/a.hpp", 101, "\n\nNames were free.\n") == right);
  CHECK(errors("generated/a.hpp", 101, "\n") == right);
  CHECK(errors("models/a.toml", 101, "\n") == right);
}

TEST_CASE("a moved file counts only its edited lines") {
  const Project project;
  project.git("mv src/check/long.cpp tests/long.cpp");
  project.commit("check: move to tests");
  CHECK(project.outcome(commits + " base").status == 0);
  project.git("rm -q tests/long.cpp");
  project.commit("check: let go of it");
  CHECK(mentions(project.outcome(commits + " base").output, "150 changed lines of source"));
}

TEST_CASE("commits that are upstream only get warnings, and merges are not checked") {
  const Project project;
  project.git("clone -q . home/clone");
  const std::string in_clone = "cd home/clone\n";
  project.commit("wip");
  CHECK(project.outcome(in_clone + "git pull -q").status == 0);
  const Outcome published = project.outcome(in_clone + commits + " base");
  CHECK(published.status == 0);
  CHECK(starts_with(published.output, "warning: "));
  CHECK(mentions(published.output, "\ncommits: 1, not upstream: 0, errors: 0\n"));
  const Outcome fresh =
      project.outcome(in_clone + "git commit -q --allow-empty -m more\n" + commits + " base");
  CHECK(fresh.status == 1);
  CHECK(count(fresh.output, "warning: ") == 1);
  CHECK(count(fresh.output, "error: ") == 1);
  CHECK(mentions(fresh.output, "\ncommits: 2, not upstream: 1, errors: 1\n"));
  const Outcome merged = project.outcome(
      in_clone +
      "git checkout -q -b side base\ngit commit -q --allow-empty -m 'all: go aside'\n"
      "git merge -q --no-edit origin/main\n" +
      commits + " origin/main");
  CHECK(merged.output == "commits: 1, not upstream: 1, errors: 0\n");
}

TEST_CASE("without a base the last ten commits get warnings") {
  const Project project;
  for (int i = 0; i < 12; ++i) project.commit("wip");
  const Outcome outcome = project.outcome(commits);
  CHECK(outcome.status == 0);
  CHECK(count(outcome.output, "warning: ") == 10);
}

TEST_CASE("the hook that bootstrap installs refuses the same commits") {
  const Project project;
  project.prepare("cp -r " ELGEN_SOURCE_DIR "/bootstrap " ELGEN_SOURCE_DIR "/.ci .");
  const Outcome installed = project.outcome("./bootstrap hooks && ./bootstrap hooks");
  CHECK(installed.output == "== wrote .git/hooks/commit-msg\n== wrote .git/hooks/commit-msg\n");
  const Outcome refused = project.outcome("git commit -q --allow-empty -m wip");
  CHECK(refused.status == 1);
  CHECK(refused.output + refused.errors ==
        "error: this commit: the subject is not `room: verb …` or `room, room: verb …`\n");
  CHECK(project.outcome("git commit -q --allow-empty -m 'check: refuse names'").status == 0);
  project.write("src/check/more.cpp", Project::lines(101));
  const Outcome bare = project.outcome("git add src && git commit -q -m 'check: write more'");
  CHECK(bare.status == 1);
  CHECK(mentions(bare.output + bare.errors, "101 changed lines of source"));
  CHECK(
      project.outcome("GIT_EDITOR=\"sed -i '1s/.*/check: write more/'\" git commit -q -v").status ==
      1);
  CHECK(project.outcome("git commit -q -m 'check: write more' -m 'Names were free.'").status == 0);
  project.write("src/check/more.cpp", Project::lines(102));
  CHECK(project.outcome("git add src && git commit -q --fixup HEAD").status == 0);

  project.write(".git/hooks/commit-msg", "#!/bin/sh\nexit 0\n");
  const Outcome kept = project.outcome("./bootstrap hooks");
  CHECK(kept.status == 1);
  CHECK(kept.output ==
        "== .git/hooks/commit-msg is there already; let it call .ci/commits --message \"$1\"\n");
}

}  // namespace elgen::test
