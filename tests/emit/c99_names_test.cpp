// c99_names: what the header needs is refused, and nothing else.
#include "emit/c99/c99_artifact.hpp"
#include "fixture.hpp"

using namespace elgen;
using elgen::testing::in_c;
using elgen::testing::Subject;

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
