// Names, units, ranges and defaults of a header are the model's.
#include <catch2/catch.hpp>

#include "changes.hpp"

namespace elgen {

using test::c99;
using test::Change;
using test::cpp;
using test::expect_refused;

TEST_CASE("another declaration is refused") {
  const std::string h = "wide.hpp";
  for (const Change& change : std::vector<Change>{
           {cpp(), h, "coordinate_units", "rad", "deg", "instead of"},
           {cpp(), h, "coordinate_names", "\"x\", ", "", "instead of"},
           {cpp(), h, "rate_ranges", "-unbounded", "unbounded", "instead of"},
           {cpp(), h, "input_limits", "-unbounded", "-1.0", "instead of"},
           {cpp(), h, "struct Parameters", "{7}, {10}", "{7}, {11}", "is not 0.7"},
           {cpp(), h, "struct Parameters", "Scalar, 2> k", "Scalar, 3> k", "instead of"},
           {c99(), "wide_scene.h", "_parameters {", "float M;", "float N;", "instead of"}}) {
    expect_refused(change);
  }
}

}  // namespace elgen
