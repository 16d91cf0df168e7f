// angle_groups: sines and cosines that can be computed together, by nesting and by scalar.
#include "emit/code/angle_groups.hpp"

#include "fixture.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const std::string head =
    "coordinates x y\nfunction gravity\n  0 = coordinate x\n  1 = coordinate y\n";

std::vector<AngleGroup> groups_of(const std::string& lines) {
  return angle_groups(read_program(head + lines + "  result 1 1 = 0\n").functions.front());
}

}  // namespace

TEST_CASE("a group needs two angles") {
  CHECK(groups_of("  2 = multiply 0 1\n").empty());
  CHECK(groups_of("  2 = sin 0\n  3 = cos 0\n").empty());
  CHECK(groups_of("  2 = sin 0\n  3 = cos 1\n") == std::vector<AngleGroup>{{2, 3}});
  const Program program = read_program(head + "  2 = sin 0\n  result 1 1 = 2\n");
  CHECK_FALSE(has_angle_groups(program));
}

TEST_CASE("the calls of an angle are neighbours in its group") {
  CHECK(groups_of("  2 = sin 0\n  3 = sin 1\n  4 = cos 0\n  5 = cos 1\n") ==
        std::vector<AngleGroup>{{2, 4, 3, 5}});
}

TEST_CASE("an angle that holds a sine is in a later group") {
  CHECK(groups_of("  2 = sin 0\n  3 = cos 1\n  4 = add 2 0\n  5 = multiply 3 1\n  6 = sin 4\n"
                  "  7 = sin 5\n  8 = cos 6\n") == std::vector<AngleGroup>{{2, 3}, {6, 7}});
}

TEST_CASE("both scalars of a step have groups of their own") {
  Program program =
      read_program(head + "  2 = sin 0\n  3 = sin 1\n  4 = cos 0\n  5 = cos 1\n  result 1 1 = 2\n");
  Function& function = program.functions.front();
  for (const std::size_t at : {std::size_t{4}, std::size_t{5}})
    function.instructions[at].is_inner = true;
  CHECK(angle_groups(function) == std::vector<AngleGroup>{{2, 3}, {4, 5}});
  CHECK(has_angle_groups(program));
}

TEST_CASE("the loop over columns has no groups") {
  Program program = read_program(head + "  2 = sin 0\n  3 = sin 1\n  result 2 1 = 2 3\n");
  program.functions.front().repeated = {1, 2};
  CHECK_FALSE(has_angle_groups(program));
}
