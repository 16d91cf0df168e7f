#include "emit/pages/page_artifacts.hpp"
#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;
using elgen::testing::Subject;

TEST_CASE("the page ends with the operations of every function") {
  const Subject subject = cart_pole();
  const std::string page = markdown(emission_input(subject.model, subject.scene, subject.program));
  const std::size_t operations = page.find("\n## Operations\n");
  REQUIRE(operations != std::string::npos);
  for (const Function& function : subject.program.functions) {
    CHECK(page.find("\n" + function.name + " ", operations) != std::string::npos);
  }
}

TEST_CASE("the page says what is left out") {
  Subject subject = cart_pole();
  subject.scene.left_out = {{LeftOutReason::too_many_entries, {"linearization"}}};
  const std::string page = markdown(emission_input(subject.model, subject.scene, subject.program));
  CHECK(page.find("\n\nLeft out, with more than 4096 entries: linearization. A scene or --outputs "
                  "that names an output gets it.\n\n") != std::string::npos);
}
