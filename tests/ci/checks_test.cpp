// .ci/checks.sh: the summary of checks and tests that .ci/run prints. Short commands replace the
// checks.
#include <catch2/catch.hpp>
#include <regex>

#include "support/shell.hpp"

namespace elgen::test {
namespace {

/// Sources .ci/checks.sh and runs `lines` of bash.
Outcome run_sourced(const std::string& lines) {
  const Workspace workspace;
  workspace.write("script", ". " ELGEN_SOURCE_DIR "/.ci/checks.sh\n" + lines);
  return workspace.run("bash -uo pipefail script");
}

/// A function that prints the log of three tests as ctest would, with exit code 8.
const std::string tests = R"(three_tests() {
  tee "$tests_log" <<'END'
1/3 Test #12: cli.some name, with 3.5 dots. in it ....   Passed    0.05 sec
2/3 Test  #2: python .................................***Failed   12.55 sec
3/3 Test  #3: errors .................................   Passed    9.05 sec

67% tests passed, 1 tests failed out of 3

The following tests FAILED:
	  2 - python (Failed)
END
  return 8
}
)";

}  // namespace

TEST_CASE("checks and tests are counted, and failures are listed before the counts") {
  const Outcome outcome = run_sourced(
      tests + "check right true\ncheck wrong false\ncount_tests three_tests\nconclude\n");
  INFO(outcome.output + outcome.errors);
  CHECK(outcome.status == 1);
  CHECK(mentions(outcome.output, "\nfailed: wrong\nfailed: python (Failed)\n3 passed, 2 failed\n"));
  const Outcome right = run_sourced("check right true\nconclude\n");
  CHECK(right.status == 0);
  CHECK(mentions(right.output, "\n1 passed, 0 failed\n"));
}

TEST_CASE("a test command that runs no tests fails") {
  const Outcome outcome = run_sourced("count_tests true\nconclude\n");
  CHECK(outcome.status == 1);
  CHECK(mentions(outcome.output, "\nfailed: tests\n0 passed, 1 failed\n"));
}

TEST_CASE("a check prints its wall time, its processor time and the remaining time") {
  const Outcome outcome = run_sourced(
      "check busy sh -c 'ulimit -t 2; while :; do :; done'\ncheck idle sleep "
      "1\nallowed_seconds=60\n"
      "check quick true\nconclude\n");
  INFO(outcome.output);
  // Bash counts whole seconds, so a check may count one second more than it takes.
  const auto matches = [&outcome](const std::string& text) {
    return std::regex_search(outcome.output, std::regex(text));
  };
  CHECK(matches("\n== idle: passed in [12] s, [01] s of processors; "));
  CHECK(mentions(outcome.output, " s of 5400 are left\n"));
  CHECK(matches("\n== quick: passed in [01] s, [01] s of processors; 5"));
  const std::string busy = outcome.output.substr(outcome.output.find("\n== busy: FAILED in "));
  CHECK_FALSE(mentions(busy.substr(0, busy.find(';')), " 0 s of processors"));
}

TEST_CASE("the ten longest checks and tests are listed before the failures") {
  const Outcome outcome = run_sourced(
      tests + "for i in {1..12}; do check \"check $i\" true; done\ncheck long sleep 3\n" +
      "count_tests three_tests\nconclude\n");
  INFO(outcome.output);
  const std::size_t start = outcome.output.find("\nlongest checks ");
  REQUIRE(start != std::string::npos);
  const std::string longest = outcome.output.substr(start);
  const std::regex ten(
      "^\nlongest checks \\(s, s of processors\\) and tests \\(s\\):\n"
      " +[34] +[01]  long\n( +[01] +[01]  .*\n){9} +12  ");
  CHECK(std::regex_search(longest, ten));
  CHECK(mentions(longest,
                 "\n      12           python\n       9           errors\n"
                 "       0           cli.some name, with 3.5 dots. in it\n\nfailed: python"));
}

}  // namespace elgen::test
