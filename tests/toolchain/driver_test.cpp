// The driver names parameters as the header does, and passes the arguments each function takes.
#include "toolchain/driver.hpp"

#include <catch2/catch.hpp>

#include "toolchain/sample_model.hpp"

using Catch::Matchers::Contains;

namespace {

std::string driver(const elgen::Model& model, const elgen::Scene& scene) {
  return elgen::driver_source(model, scene, sample::program());
}

}  // namespace

TEST_CASE("parameters go to the members of the emitted struct") {
  const std::string text = driver(sample::model(), sample::scene());
  CHECK_THAT(text, Contains("result.m = values[0];"));
  CHECK_THAT(text, Contains("result.l[0] = values[1];"));
  CHECK_THAT(text, Contains("result.l[1] = values[2];"));
}

TEST_CASE("parameters that no function reads are no members") {
  elgen::Program program = sample::program();
  program.functions.front().instructions.erase(program.functions.front().instructions.begin());
  const std::string text = elgen::driver_source(sample::model(), sample::scene(), program);
  CHECK_THAT(text, !Contains("result.m"));
  CHECK_THAT(text, Contains("result.l[0] = values[1];"));
}

TEST_CASE("each function gets the arguments of its row, and t last where t occurs") {
  elgen::Model model = sample::model();
  CHECK_THAT(driver(model, sample::scene()), !Contains(", t)"));
  model.uses_time = true;
  const std::string text = driver(model, sample::scene());
  CHECK_THAT(text, Contains("1>(a), t)"));
  CHECK_THAT(text, Contains("0>(u), t)"));
}

TEST_CASE("the mass matrix takes v where L is not quadratic") {
  elgen::Model model = sample::model();
  elgen::Program program = sample::program();
  program.functions = {
      {.kind = elgen::OutputKind::mass_matrix, .name = "M", .fields = {{.entries = {0}}}}};
  CHECK_THAT(driver_source(model, sample::scene(), program), !Contains(">(v)"));
  model.quadratic = false;
  CHECK_THAT(driver_source(model, sample::scene(), program), Contains(">(v)"));
}

TEST_CASE("a chosen namespace is used, the file keeps its name") {
  elgen::Scene scene = sample::scene();
  scene.emission.name_space = "plant";
  const std::string text = driver(sample::model(), scene);
  CHECK_THAT(text, Contains("#include \"sample/sample.hpp\""));
  CHECK_THAT(text, Contains("namespace emitted = ::plant;"));
}

TEST_CASE("results beyond 4096 entries are taken by reference") {
  elgen::Program program = sample::program();
  program.functions[0].fields[0].entries.assign(4096, 0);
  CHECK_THAT(driver_source(sample::model(), sample::scene(), program),
             !Contains("inverse_dynamics(result,"));
  program.functions[0].fields[0].entries.push_back(0);
  CHECK_THAT(driver_source(sample::model(), sample::scene(), program),
             Contains("inverse_dynamics(result,"));
  program.functions[1].fields[1].entries.assign(4097, 0);
  CHECK_THAT(driver_source(sample::model(), sample::scene(), program),
             Contains("emitted::ForwardDynamics<Scalar> result{};"));
}

TEST_CASE("a driver of C calls prefixed functions, for the scene's scalar alone") {
  elgen::Scene scene = sample::scene();
  scene.emission.language = elgen::LanguageId::c99;
  scene.numerics.scalars = {elgen::ScalarKind::single_precision};
  const std::string text = driver(sample::model(), scene);
  CHECK_THAT(text, Contains("#include \"sample/sample.h\""));
  CHECK_THAT(text, Contains("sample_inverse_dynamics(&p, q, v, a, result);"));
  CHECK_THAT(text, Contains("sample_forward_dynamics(&p, q, v, u, &result);"));
  CHECK_THAT(text, Contains("elgen_driver_float_0"));
  CHECK_THAT(text, !Contains("elgen_driver_double_0"));
}

TEST_CASE("column-major results come out row by row") {
  elgen::Scene scene = sample::scene();
  scene.emission.storage = elgen::Storage::column_major;
  CHECK_THAT(driver(sample::model(), scene), Contains("stored[j * rows + i]"));
}
