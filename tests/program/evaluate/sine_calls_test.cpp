// sine_calls: sines and cosines that can be computed together, by nesting and by scalar, and those
// that are alone.
#include "program/evaluate/sine_calls.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "program/read_program.hpp"

using namespace elgen;
using elgen::test::read_program;

namespace {

const std::string two_angles =
    "coordinates x y\nfunction gravity\n  0 = coordinate x\n  1 = coordinate y\n";

std::vector<AngleGroup> groups_of(const std::string& lines) {
  return angle_groups(read_program(two_angles + lines + "  result 1 1 = 0\n").functions.front());
}

}  // namespace

TEST_CASE("a group needs two angles") {
  CHECK(groups_of("  2 = multiply 0 1\n").empty());
  CHECK(groups_of("  2 = sin 0\n  3 = cos 0\n").empty());
  CHECK(groups_of("  2 = sin 0\n  3 = cos 1\n") == std::vector<AngleGroup>{{2, 3}});
  const Program program = read_program(two_angles + "  2 = sin 0\n  result 1 1 = 2\n");
  CHECK_FALSE(has_angle_groups(program));
}

TEST_CASE("the calls of an angle are neighbours in its group") {
  CHECK(groups_of("  2 = sin 0\n  3 = sin 1\n  4 = cos 0\n  5 = cos 1\n") ==
        std::vector<AngleGroup>{{2, 4, 3, 5}});
}

TEST_CASE("a group has at most 64 angles") {
  std::string lines;
  for (int i = 2; i < 132; ++i) lines += fmt::format("  {} = add {} 0\n", i, i - 1);
  for (int i = 2; i < 132; ++i) lines += fmt::format("  {} = sin {}\n", i + 130, i);
  const std::vector<AngleGroup> groups = groups_of(lines);
  REQUIRE(groups.size() == 3);
  CHECK(groups[0].size() == 64);
  CHECK(groups[1].front() == 132 + 64);
  CHECK(groups[2].size() == 2);
}

TEST_CASE("an angle that holds a sine is in a later group") {
  CHECK(groups_of("  2 = sin 0\n  3 = cos 1\n  4 = add 2 0\n  5 = multiply 3 1\n  6 = sin 4\n"
                  "  7 = sin 5\n  8 = cos 6\n") == std::vector<AngleGroup>{{2, 3}, {6, 7}});
}

TEST_CASE("both scalars of a step have groups of their own") {
  Program program = read_program(
      two_angles + "  2 = sin 0\n  3 = sin 1\n  4 = cos 0\n  5 = cos 1\n  result 1 1 = 2\n");
  Function& function = program.functions.front();
  for (const std::size_t at : {std::size_t{4}, std::size_t{5}})
    function.instructions[at].is_inner = true;
  CHECK(angle_groups(function) == std::vector<AngleGroup>{{2, 3}, {4, 5}});
  CHECK(has_angle_groups(program));
}

TEST_CASE("the loop over columns has no groups") {
  Program program = read_program(two_angles + "  2 = sin 0\n  3 = sin 1\n  result 2 1 = 2 3\n");
  program.functions.front().repeated = {1, 2};
  CHECK_FALSE(has_angle_groups(program));
}

TEST_CASE("a sine is alone if its function computes no other sine with it") {
  const auto lone = [](const std::string& lines, SineCosinePairing pairing) {
    return lone_sine_calls(
        read_program(two_angles + lines + "  result 1 1 = 0\n").functions.front(), pairing);
  };
  using enum SineCosinePairing;
  const std::vector<bool> none;
  CHECK(lone("  2 = multiply 0 1\n", separate) == none);
  CHECK(lone("  2 = cos 0\n", grouped) == std::vector{false, false, true});
  CHECK(lone("  2 = sin 0\n  3 = cos 0\n", joint) == none);
  CHECK(lone("  2 = sin 0\n  3 = cos 0\n", separate) == std::vector{false, false, true, true});
  CHECK(lone("  2 = sin 0\n  3 = cos 1\n", grouped) == none);
  CHECK(lone("  2 = sin 0\n  3 = cos 1\n", joint) == std::vector{false, false, true, true});
  CHECK(lone("  2 = cos 0\n  3 = sin 2\n  4 = cos 2\n", grouped) ==
        std::vector{false, false, true, false, false});
}
