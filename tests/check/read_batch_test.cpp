// Batches: what a scene asks for, and what it cannot have.
#include "check/scene/read_batch.hpp"

#include <catch2/catch.hpp>

#include "check_testing.hpp"

namespace elgen::test {
namespace {

const std::string batch = "[emit]\nbatch = true\n";

}  // namespace

TEST_CASE("a batch is asked for, its accuracy is the best or a given one") {
  CHECK_FALSE(block_scene("").emission.batch);
  const Scene best = block_scene(batch);
  CHECK(best.emission.batch);
  CHECK(trigonometry_error(best.numerics, ScalarKind::double_precision) ==
        cln::expt(cln::cl_RA(2), -52));
  CHECK(trigonometry_error(best.numerics, ScalarKind::single_precision) ==
        cln::expt(cln::cl_RA(2), -23));
  const Scene given = block_scene(batch + "[numeric]\ntrigonometry = { max_error = 1e-7 }\n");
  CHECK(given.numerics.trigonometry_error == cln::cl_RA(1) / 10'000'000);
}

TEST_CASE("accuracies that no scalar has are E625") {
  const std::string range = "`max_error` is at least 2^-52";
  for (const std::string value : {"0", "-1e-7", "2.2e-16", "1", "\"sqrt(2)/2\""}) {
    INFO(value);
    const std::string said =
        block_scene_messages(batch + "[numeric]\ntrigonometry = { max_error = " + value + " }\n");
    CHECK_THAT(said, Catch::Contains("E625") && Catch::Contains(range));
  }
  const std::string floats =
      "[numeric]\nscalar = [\"float\"]\ntrigonometry = { max_error = 1e-7 }\n";
  CHECK_THAT(block_scene_messages(batch + floats), Catch::Contains("in float is at least 2^-23"));
}

TEST_CASE("polynomials are for batches, and these for C++ in float and double") {
  CHECK_THAT(block_scene_messages("[numeric]\ntrigonometry = { max_error = 1e-7 }\n"),
             Catch::Contains("E625") && Catch::Contains("in batches alone"));
  CHECK_THAT(block_scene_messages(batch + "language = \"c99\"\n"), Catch::Contains("E611"));
  CHECK_THAT(block_scene_messages(batch + "[numeric]\nscalar = [\"double\", \"long double\"]\n"),
             Catch::Contains("E625") && Catch::Contains("`float` or `double`"));
}

}  // namespace elgen::test
