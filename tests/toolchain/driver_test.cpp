// One driver for every header; parameters go to the members that the header has.
#include "toolchain/driver.hpp"

#include <catch2/catch.hpp>

#include "toolchain/sample_model.hpp"

using Catch::Matchers::Contains;

namespace {

std::string driver(const elgen::Program& program) {
  return elgen::drivers({sample::model(), sample::scene(), program}).front().text;
}

}  // namespace

TEST_CASE("every header that is emitted has a driver, in its language") {
  elgen::Scene scene = sample::scene();
  const auto files = [&scene] {
    std::string names;
    for (const elgen::Driver& driver :
         elgen::drivers({sample::model(), scene, sample::program()})) {
      names += driver.file + "[" + driver.types + "] ";
    }
    return names;
  };
  CHECK(files() == "driver.cpp[] ");
  scene.emission.eigen = true;
  CHECK(files() == "driver.cpp[] eigen_driver.cpp[Eigen] ");
  scene.emission.batch = true;
  CHECK(files() == "driver.cpp[] eigen_driver.cpp[Eigen] batch_driver.cpp[batch] ");
  scene.emission = {};
  scene.emission.language = elgen::LanguageId::c99;
  scene.numerics.scalars = {elgen::ScalarKind::double_precision};
  CHECK(files() == "driver.c[] ");
}

TEST_CASE("parameters go to the members of the emitted struct") {
  const std::string text = driver(sample::program());
  CHECK_THAT(text, Contains("result.m = values[0];"));
  CHECK_THAT(text, Contains("result.l[0] = values[1];"));
  CHECK_THAT(text, Contains("result.l[1] = values[2];"));
}

TEST_CASE("parameters that no function reads are no members") {
  elgen::Program program = sample::program();
  program.functions.front().instructions.erase(program.functions.front().instructions.begin());
  const std::string text = driver(program);
  CHECK_THAT(text, !Contains("result.m"));
  CHECK_THAT(text, Contains("result.l[0] = values[1];"));
}
