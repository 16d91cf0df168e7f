// Rows of operations are compared with a count.
#include "readback/operation_table.hpp"

#include <catch2/catch.hpp>

#include "changes.hpp"

namespace elgen {
namespace {

using Lines = std::vector<std::string_view>;

constexpr std::string_view heading = "function  add mul div sqrt sincos other definitions form";

Program mass_alone() {
  Program program = test::cpp().program;
  program.functions.resize(1);
  return program;
}

}  // namespace

TEST_CASE("a row says what a function executes") {
  const Program program = mass_alone();
  CHECK(wrong_operations(program, {heading, "mass_matrix 1 3 0 0 1 0 3 closed"}).problem.empty());
  CHECK(wrong_operations(program, {"text", heading, "mass_matrix  1  3 0 0 1 0 3  closed", "```"})
            .problem.empty());
  CHECK(wrong_operations(program, {heading, "mass_matrix 1 4 0 0 1 0 3 closed"}).problem ==
        "the row should be `mass_matrix 1 3 0 0 1 0 3 closed`");
  CHECK(wrong_operations(program, {heading}).problem == "no row of `mass_matrix`");
  CHECK(wrong_operations(program, {"text"}).problem == "no table of operations");
  CHECK(wrong_operations(program, Lines{}).problem == "no table of operations");
}

TEST_CASE("below them entries are listed that are computed otherwise than shown") {
  Program program = mass_alone();
  program.functions[0].rewritten = {0, 3};
  constexpr std::string_view row = "mass_matrix 1 3 0 0 1 0 3 closed";
  constexpr std::string_view otherwise =
      "entries that are computed otherwise than shown, to keep digits";
  CHECK(wrong_operations(program, {heading, row, otherwise, "mass_matrix 0 3"}).problem.empty());
  CHECK(wrong_operations(program, {heading, row, otherwise, "mass_matrix 0"}).problem ==
        "the row should be `mass_matrix 0 3`");
  CHECK(wrong_operations(program, {heading, row}).problem == "no row of `entries`");
}

}  // namespace elgen
