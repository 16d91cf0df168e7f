#include "errors/case_file.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

namespace elgen::test {

TEST_CASE("a case is read section by section and written back unchanged") {
  const std::string text =
      "--- model.toml\nformat = 1\n--- scenes/a.toml\nformat = 1\n--- command\nelgen x\n"
      "--- exit 2\n--- stdout\nout\n--- stderr\nerror\n  | ^\n";
  const CaseFile parsed = parse_case(text);
  REQUIRE(parsed.inputs.size() == 2);
  CHECK(parsed.inputs[1].title == "scenes/a.toml");
  CHECK(parsed.inputs[1].body == "format = 1\n");
  CHECK(parsed.command == "elgen x\n");
  CHECK(parsed.expected.status == 2);
  CHECK(parsed.expected.output == "out\n");
  CHECK(parsed.expected.errors == "error\n  | ^\n");
  CHECK(to_text(parsed) == text);
}

TEST_CASE("a case without title, command or exit code is refused") {
  CHECK_THROWS_AS(parse_case("format = 1\n"), std::invalid_argument);
  CHECK_THROWS_AS(parse_case("--- exit 2\n"), std::invalid_argument);
  CHECK_THROWS_AS(parse_case("--- command\nelgen\n"), std::invalid_argument);
}

TEST_CASE("a case runs in a folder of its own, streams and status kept apart") {
  CaseFile sample;
  sample.inputs = {{"in/put.txt", "text\n"}};
  sample.command = "cat in/put.txt; echo error >&2; ls; exit 7";
  const Outcome outcome = run_case(sample);
  CHECK(outcome.status == 7);
  CHECK(outcome.output == "text\nin\n");
  CHECK(outcome.errors == "error\n");
}

}  // namespace elgen::test
