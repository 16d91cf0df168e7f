// parameters: how they are read, and what is said of them.
#include "emit/text/parameters.hpp"

#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;
using elgen::testing::Subject;

TEST_CASE("text, unit and range of a parameter") {
  Subject subject = cart_pole();
  CHECK(parameter_doc(subject.model.parameter_arrays[0]) == "cart mass [kg]");
  subject.model.parameter_arrays[1].range = Interval{0, 2};
  CHECK(parameter_doc(subject.model.parameter_arrays[1]) == "[kg] in [0, 2]");
}

TEST_CASE("leaves are members of what holds the parameters") {
  Subject subject = cart_pole();
  elgen::testing::add_parameter_array(subject.model, "k", {1, 2});
  subject.program.leaves.parameters = {"g", "k[2]"};
  CHECK(parameter_members(subject.model, subject.program.leaves) ==
        std::vector<std::string>{"g", "k[1]"});
}
