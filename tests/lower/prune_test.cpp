// What no entry needs goes.
#include "lower/graph/prune.hpp"

#include <catch2/catch.hpp>

#include "lower/read_program.hpp"

using namespace elgen;

namespace {

Program program_of(const std::string& function) {
  return testing::read_program("parameters m l\nfunction gravity\n" + function);
}

}  // namespace

TEST_CASE("what an entry needs") {
  const Program program = program_of(
      "  0 = parameter m\n  1 = parameter l\n  2 = multiply 0 0\n  3 = add 2 1\n"
      "  result 1 1 = 3\n");
  CHECK(needed_for(program.functions[0], {2}) == std::vector<bool>{true, false, true, false});
  CHECK(needed_for(program.functions[0], {3}) == std::vector<bool>{true, true, true, true});
}

TEST_CASE("instructions that nothing needs are gone, the others renumbered") {
  Program program = program_of(
      "  0 = parameter m\n  1 = parameter l\n  2 = multiply 0 0  ; square\n  3 = add 2 1\n"
      "  result 1 1 = 3\n");
  program.functions[0].fields[0].entries = {2};
  program.functions[0] = pruned(program.functions[0]);
  CHECK(check_invariants(program).empty());
  CHECK(dump(program) ==
        dump(program_of("  0 = parameter m\n  1 = multiply 0 0  ; square\n  result 1 1 = 1\n")));
}

TEST_CASE("instructions become the entries of one field") {
  const Program program = program_of(
      "  0 = parameter m\n  1 = parameter l\n  2 = multiply 0 0\n  3 = add 2 1\n"
      "  result 1 1 = 3\n");
  CHECK(dump(Program{program.leaves, {}, {with_entries(program.functions[0], {2, 0})}}) ==
        dump(program_of("  0 = parameter m\n  1 = multiply 0 0\n  result 2 1 = 1 0\n")));
}

TEST_CASE("names stay with their instructions, moved or not") {
  Program program = program_of(
      "  0 = parameter m\n  1 = multiply 0 0  ; square\n  2 = parameter l\n"
      "  3 = multiply 1 0  ; cube\n  result 1 1 = 3\n");
  program.functions[0] = pruned(program.functions[0]);
  CHECK(program.functions[0].names == std::vector<std::string>{"", "square", "cube"});
}

TEST_CASE("another order computes the same") {
  Program program = program_of(
      "  0 = parameter m\n  1 = multiply 0 0  ; square\n  2 = parameter l\n  3 = add 1 2\n"
      "  result 1 1 = 3\n");
  program.functions[0] = reordered(program.functions[0], {2, 0, 1, 3});
  CHECK(check_invariants(program).empty());
  CHECK(dump(program) == dump(program_of("  0 = parameter l\n  1 = parameter m\n"
                                         "  2 = multiply 1 1  ; square\n  3 = add 2 0\n"
                                         "  result 1 1 = 3\n")));
}
