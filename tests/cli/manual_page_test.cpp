#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

using namespace elgen::test;

TEST_CASE("the manual has options with their words, and exit codes") {
  const Outcome manual = run("elgen man");
  CHECK(manual.status == 0);
  CHECK(manual.output.starts_with(".TH ELGEN 1 "));
  CHECK(manual.output.find("\n.TP\n\\fB\\-\\-color\\fR \\fIauto|always|never\\fR\n") !=
        std::string::npos);
  CHECK(manual.output.find("\n.TP\n130\ninterrupted") != std::string::npos);
}

TEST_CASE("no text of the manual is a request of troff") {
  std::istringstream lines(run("elgen man").output);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with('.') && !line.starts_with('\'')) continue;
    const std::string request = line.substr(0, 3);
    INFO(line);
    const bool is_known = request == ".TH" || request == ".SH" || request == ".SS" ||
                          request == ".TP" || request == ".B " || request == ".I " ||
                          request == ".RI" || request == ".nf" || request == ".fi";
    CHECK(is_known);
  }
}
