// The entries of a function, and those that are written in another way to keep digits.
#include "choose/entries.hpp"

#include <catch2/catch.hpp>

#include "lower/expression_leaves.hpp"
#include "lower/read_program.hpp"

using namespace elgen;

namespace {

/// 1 - cos(a) and b
const char* two_entries =
    "coordinates a b c d e\nfunction bias\n  0 = coordinate a\n  1 = coordinate b\n  2 = cos 0\n"
    "  3 = constant 1\n  4 = subtract 3 2\n  result 2 1 = 4 1\n";

}  // namespace

TEST_CASE("all entries of a function have a form") {
  const Program program = testing::read_program(two_entries);
  const ClosedForms forms = present(program);
  const ReadableEntries entries = read_entries(
      {program, program.functions[0], forms, forms.functions[0]}, mixed_points(program.leaves));
  REQUIRE(is_complete(entries));
  CHECK(length(entries) == entries[0]->length + entries[1]->length);
  CHECK_FALSE(is_complete({}));
  CHECK_FALSE(is_complete({entries[0], std::nullopt}));
}

TEST_CASE("code is rewritten where it loses digits, what people read stays") {
  const Program program = testing::read_program(two_entries);
  const ClosedForms forms = present(program);
  const BothForms both{program, program.functions[0], forms, forms.functions[0]};
  const MixedPoints points = mixed_points(program.leaves);
  const ExtremePoints extremes = extreme_points(program, Preference::accuracy);
  ReadableEntries entries = read_entries(both, points);
  const auto with_losses = [&](const std::vector<double>& losses) {
    return rewrite(entries, losses, both, {.points = extremes, .prefers_short = true});
  };
  CHECK_FALSE(with_losses({0, 0}));
  REQUIRE(with_losses({1e15, 0}));
  CHECK(entries[0]->is_rewritten);
  CHECK_FALSE(entries[1]->is_rewritten);
  CHECK(rewritten_entries(entries, 2) == std::vector<std::uint32_t>{0});
  CHECK(rewritten_entries(entries, 0).empty());
  read_as_precisely(entries, points);
  CHECK(testing::texts_of(entries[0]->readable).at(0) == "1 - cos(a)");
  CHECK(testing::texts_of(entries[0]->compact).at(0) == "2*sin(1/2*a)^2");
}
