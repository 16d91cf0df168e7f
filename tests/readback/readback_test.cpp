// Files of unusual shape are read back as well: no parameters, time, rotations, results too large
// to return, numbers alone, scalars that cannot hold a number.
#include <catch2/catch.hpp>

#include "changes.hpp"
#include "support/frame_systems.hpp"

namespace elgen {
namespace {

const std::vector<std::string>& emissions() {
  static const std::vector<std::string> all{
      "[emit]\neigen = true\n", "[emit]\neigen = true\nstorage = \"column-major\"\n",
      "[emit]\nlanguage = \"c99\"\n",
      "[emit]\nlanguage = \"c99\"\nstorage = \"column-major\"\n[numeric]\nscalar = [\"float\"]\n"};
  return all;
}

void expect_read(const std::string& model, const std::string& scene = "") {
  for (const std::string& emission : emissions()) {
    INFO(emission);
    CHECK_NOTHROW(test::written(model, scene + emission));
  }
}

std::string many_masses(int count) {
  return "format = 1\n[model]\nname = \"many\"\n[sizes]\nn = " + std::to_string(count) +
         R"toml(
[parameters]
m = { value = 2, size = "n" }
[[coordinate]]
for = "i in 1..n"
name = "x[i]"
[[point]]
for = "i in 1..n"
name = "mass[i]"
at = ["x[i]", "0"]
mass = "m[i]"
)toml";
}

}  // namespace

TEST_CASE("a model whose parameters are all numbers is read back") {
  expect_read(test::wide_text(), "[parameters]\nfixed = \"all\"\n");
}

TEST_CASE("a model with time is read back") {
  expect_read(test::turntable_text(), "[outputs]\nbias = true\nforward_dynamics = true\n");
}

TEST_CASE("a model with a rotation is read back") { expect_read(test::tumbler_text()); }

TEST_CASE("systems of frames are read back") {
  for (const auto& [name, text] : test::frame_systems()) {
    INFO(name);
    CHECK_NOTHROW(test::written(text));
  }
}

TEST_CASE("a result too large to be returned is read back") {
  expect_read(many_masses(70), "[outputs]\nmass_matrix = true\nbias = true\n");
}

TEST_CASE("a model of one coordinate and no input is read back") { expect_read(many_masses(1)); }

TEST_CASE("numbers beyond float are read back") {
  const std::string model =
      "format = 1\n[model]\nname = \"far\"\n[[coordinate]]\nname = \"x\"\n[parameters]\n"
      "m = 1e-60\nk = \"pi*1e60\"\n[energy]\nT = \"m*dot(x)^2*1e50\"\nV = \"k*x^2/7e45\"\n";
  CHECK_NOTHROW(test::written(model, "[emit]\neigen = true\n"));
}

TEST_CASE("a file that is not there is refused") {
  for (const std::string ending : {"wide.hpp", ".md", ".equations.json"}) {
    std::vector<SourcePointer> files = test::cpp().files;
    files.erase(std::find(files.begin(), files.end(), test::file_of(test::cpp(), ending)));
    const Diagnostics found =
        read_back(files, test::cpp().checked, test::cpp().program).diagnostics;
    REQUIRE(found.size() == 1);
    CHECK_THAT(found.front().message, Catch::Contains(ending + "` is missing"));
  }
}

}  // namespace elgen
