// The header of batches: whatever token of a function or number is another one, the file is
// refused.
#include "readback/batch_reader.hpp"

#include <catch2/catch.hpp>

#include "changes.hpp"

namespace elgen {
namespace {

using test::Change;
using test::expect_refused;

const test::Written& batch() {
  static const test::Written all = test::written(
      test::wide_text(),
      "[numeric]\nscalar = [\"float\", \"double\"]\ntrigonometry = { max_error = 1e-6 }\n"
      "[emit]\nbatch = true\n");
  return all;
}

}  // namespace

TEST_CASE("a header of batches is read back") {
  CHECK(test::file_of(batch(), "_batch.hpp")->text.find("Trigonometry<float>") !=
        std::string::npos);
}

TEST_CASE("a header of batches that says something else is refused") {
  const std::string h = "_batch.hpp";
  const std::string solved = "void forward_dynamics(";
  for (const Change& change : std::vector<Change>{
           {batch(), h, "Trigonometry<double> {", "sine[] = {\n      -0.1666",
            "sine[] = {\n      -0.1667", "is another number"},
           {batch(), h, "Trigonometry<double> {", "sine[] = {\n      -", "sine[] = {\n      ",
            "is another number"},
           {batch(), h, "Trigonometry<float> {", "F,", ",", "is another number"},
           {batch(), h, "Trigonometry<double> {", "int64_t", "int32_t", "instead of"},
           {batch(), h, "Trigonometry<double> {", "low =", "high =", "`low`"},
           {batch(), h, "sine_cosine(const", "quadrant & 2", "quadrant & 1", "`2`"},
           {batch(), h, "repeated(", "result.m = p.m", "result.m = p.M", "`m`"},
           {batch(), h, "repeated(", "i < 2", "i < 1", "`2`"},
           {batch(), h, solved, "(q, at)", "(v, at)", "`q`"},
           {batch(), h, solved, "Velocities", "Coordinates", "`Velocities`"},
           {batch(), h, solved, "forward_dynamics<Scalar>", "bias<Scalar>", "`forward_dynamics`"},
           {batch(), h, solved, "values.relative_pivots", "values.acceleration", "instead of"},
           {batch(), h, solved, "2 * count", "1 * count", "`2`"},
           {batch(), h, "void applied_force(", "Scalar = T", "Scalar = Pack<T>", "`T`"}}) {
    expect_refused(change);
  }
}

}  // namespace elgen
