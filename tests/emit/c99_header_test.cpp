// c99_header: golden header of a small model; ELGEN_UPDATE=1 rewrites it.
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "emit/c99/c99_artifact.hpp"
#include "fixture.hpp"

using namespace elgen;
using elgen::testing::in_c;
using elgen::testing::Subject;

namespace {

std::string c99_text(const Subject& subject) {
  return c99_header(emission_input(subject.model, subject.scene, subject.program));
}

}  // namespace

TEST_CASE("the header in C is the golden one, byte for byte") {
  const std::string golden = std::string(ELGEN_SOURCE_DIR) + "/tests/emit/golden/cart_pole.h";
  const std::string text = c99_text(in_c());
  if (std::getenv("ELGEN_UPDATE") != nullptr) std::ofstream(golden, std::ios::binary) << text;
  std::ifstream stream(golden, std::ios::binary);
  std::ostringstream expected;
  expected << stream.rdbuf();
  CHECK(text == expected.str());
}

TEST_CASE("without parameters there is still a struct, because C has no empty one") {
  Subject subject = in_c();
  subject.program = elgen::testing::read_program(
      "coordinates x theta\nfunction gravity\n  0 = coordinate x\n  result 2 1 = 0 0\n");
  CHECK(c99_text(subject).find("  char none;") != std::string::npos);
}
