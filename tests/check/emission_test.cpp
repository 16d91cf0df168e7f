// emission: [emit] as enumerators, and what does not go together.
#include "check/scene/emission.hpp"

#include <catch2/catch.hpp>

#include "check_testing.hpp"
#include "elgen/artifacts.hpp"

namespace elgen::test {
namespace {

TEST_CASE("without [emit] the code is C++, row-major, without Eigen") {
  const Scene scene = block_scene("");
  CHECK(scene.emission.language == LanguageId::cpp);
  CHECK(scene.emission.storage == Storage::row_major);
  CHECK_FALSE(scene.emission.eigen);
}

TEST_CASE("language, storage and Eigen are what [emit] says") {
  const Scene c = block_scene("[emit]\nstorage = \"column-major\"\nlanguage = \"c99\"\n");
  CHECK(c.emission.language == LanguageId::c99);
  CHECK(c.emission.storage == Storage::column_major);
  CHECK(block_scene("[emit]\neigen = true\n").emission.eigen);
}

TEST_CASE("`files` leaves out the sidecar and the page, but no code") {
  CHECK(block_scene("").emission.equations);
  CHECK(block_scene("").emission.page);
  const Scene bare = block_scene("[emit]\nfiles = [\"header\"]\n");
  CHECK_FALSE(bare.emission.equations);
  CHECK_FALSE(bare.emission.page);
  CHECK(artifacts_of(bare).size() == 1);
  CHECK(block_scene("[emit]\nfiles = [\"page\", \"header\"]\n").emission.page);
  CHECK(block_scene_messages("[emit]\nfiles = [\"page\"]\n")
            .find("`files` has no `header`, which is always written") != std::string::npos);
}

TEST_CASE("code in C is for one scalar, float or double") {
  const std::string language = "[emit]\nlanguage = \"c99\"\n";
  CHECK(block_scene("[numeric]\nscalar = [\"float\"]\n" + language).numerics.scalars.size() == 1);
  for (const char* list : {"[\"long double\"]", "[\"float\", \"double\"]"}) {
    INFO(list);
    CHECK(block_scene_messages(std::string("[numeric]\nscalar = ") + list + "\n" + language)
              .find("code in `c99` is written for one scalar") != std::string::npos);
  }
}

TEST_CASE("Eigen is C++") {
  CHECK(block_scene_messages("[emit]\nlanguage = \"c99\"\neigen = true\n")
            .find("`eigen` needs C++, and `language` is `c99`") != std::string::npos);
}

}  // namespace
}  // namespace elgen::test
