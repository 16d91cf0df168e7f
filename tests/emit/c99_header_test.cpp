// c99_header: its parameters, and the names that it needs; the golden header shows it whole.
#include "emit/c99/c99_artifact.hpp"
#include "fixture.hpp"

using namespace elgen;
using elgen::testing::in_c;
using elgen::testing::Subject;

TEST_CASE("without parameters there is still a struct, because C has no empty one") {
  Subject subject = in_c();
  subject.program = elgen::testing::read_program(
      "coordinates x theta\nfunction gravity\n  0 = coordinate x\n  result 2 1 = 0 0\n");
  const std::string text =
      c99_header(emission_input(subject.model, subject.scene, subject.program));
  CHECK(text.find("  char none;") != std::string::npos);
}

TEST_CASE("names of the header and of other functions' helpers are E701") {
  for (const char* name : {"parameters", "is_regular", "forward_dynamics_result", "gravity_part_2",
                           "gravity_workspace"}) {
    Subject subject = in_c();
    subject.program.functions[0].name = name;
    INFO(name);
    CHECK(c99_check_names(subject.model, subject.scene, subject.program).size() == 1);
  }
  const Subject subject = in_c();
  CHECK(c99_check_names(subject.model, subject.scene, subject.program).empty());
}
