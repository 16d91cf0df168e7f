// arguments: what is read from them.
#include "emit/code/arguments.hpp"

#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;
using elgen::testing::Subject;

TEST_CASE("members of parameters") {
  Subject subject = cart_pole();
  elgen::testing::add_parameter_array(subject.model, "k", {1, 2});
  subject.program.leaves.parameters = {"g", "k[2]"};
  CHECK(parameter_members(subject.model, subject.program.leaves) ==
        std::vector<std::string>{"g", "k[1]"});
}
