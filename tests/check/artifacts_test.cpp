// Which files a scene wants, and where.
#include "elgen/artifacts.hpp"
#include <catch2/catch.hpp>

namespace elgen::test {

namespace {

std::vector<std::string> paths(const Emission& emission) {
  Scene scene;
  scene.base_name = "arm";
  scene.emission = emission;
  std::vector<std::string> result;
  for (const Artifact& artifact : artifacts_of(scene)) result.push_back(artifact.path);
  return result;
}

}  // namespace

TEST_CASE("files are known without deriving, the header first") {
  Emission emission;
  CHECK(paths(emission) ==
        std::vector<std::string>{"arm/arm.hpp", "arm/arm.equations.json", "arm/arm.md"});
  emission.eigen = true;
  CHECK(paths(emission) == std::vector<std::string>{"arm/arm.hpp", "arm/arm_eigen.hpp",
                                                    "arm/arm.equations.json", "arm/arm.md"});
  emission = {};
  emission.language = LanguageId::c99;
  CHECK(paths(emission) ==
        std::vector<std::string>{"arm/arm.h", "arm/arm.equations.json", "arm/arm.md"});
}

}  // namespace elgen::test
