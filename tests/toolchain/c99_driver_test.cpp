// C: prefixed functions, results through pointers, one scalar.
#include <catch2/catch.hpp>

#include "toolchain/driver_parts.hpp"
#include "toolchain/sample_model.hpp"

using Catch::Matchers::Contains;

TEST_CASE("a driver of C calls prefixed functions, for the scene's scalar alone") {
  elgen::Scene scene = sample::scene();
  scene.emission.language = elgen::LanguageId::c99;
  scene.numerics.scalars = {elgen::ScalarKind::single_precision};
  const std::string text = elgen::c99_driver({sample::model(), scene, sample::program()});
  CHECK_THAT(text, Contains("#include \"sample/sample.h\""));
  CHECK_THAT(text, Contains("sample_inverse_dynamics(&p, q, v, a, result);"));
  CHECK_THAT(text, Contains("sample_forward_dynamics(&p, q, v, u, &result);"));
  CHECK_THAT(text, Contains("elgen_driver_float_0"));
  CHECK_THAT(text, !Contains("elgen_driver_double_0"));
}
