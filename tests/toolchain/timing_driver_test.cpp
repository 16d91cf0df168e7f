// The driver that times.
#include "toolchain/timing_driver.hpp"

#include <catch2/catch.hpp>

#include "toolchain/sample_model.hpp"

using Catch::Matchers::Contains;
using namespace elgen;

namespace {

std::string driver(const Scene& scene, const std::vector<TimedVariant>& variants,
                   std::size_t function = 0) {
  Program program = sample::program();
  program.functions.erase(program.functions.begin(),
                          program.functions.begin() + static_cast<std::ptrdiff_t>(function));
  return timing_driver({sample::model(), scene, program}, variants).text;
}

}  // namespace

TEST_CASE("one by one, a state is gathered from all arrays and its fields are scattered") {
  const std::string text = driver(sample::scene(), {{ScalarKind::single_precision, false}}, 1);
  CHECK_THAT(text, Contains("#include \"sample/sample.hpp\""));
  CHECK_THAT(text, Contains("gathered<emitted::Coordinates<Scalar>>(q, i, count)"));
  CHECK_THAT(text, Contains("scatter(values.acceleration, i, count, result + 0 * count);"));
  CHECK_THAT(text, Contains("scatter(values.relative_pivots, i, count, result + 1 * count);"));
  CHECK_THAT(text, Contains("void elgen_timed_0(std::size_t count, const float* parameters"));
  CHECK_THAT(text, !Contains("batch"));
}

TEST_CASE("in packs, the header of batches does all of it") {
  Scene scene = sample::scene();
  scene.emission.batch = true;
  const std::string text = driver(scene, {{}, {ScalarKind::double_precision, true}});
  CHECK_THAT(text, Contains("#include \"sample/sample_batch.hpp\""));
  CHECK_THAT(text,
             Contains("emitted::batch::inverse_dynamics<Scalar>(model_parameters<Scalar>(), count, "
                      "q, v, a, result);"));
  CHECK_THAT(text, Contains("in_packs<double>(count, parameters, q, v, a, u, t, h, result);"));
}
