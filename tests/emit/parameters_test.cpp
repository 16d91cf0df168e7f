// parameters: which are emitted, how many, how they are read, and what is said of them.
#include "emit/text/parameters.hpp"

#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;
using elgen::testing::Subject;

namespace {

Program reading(std::uint32_t leaf) {
  Program program;
  program.leaves.parameters = {"M", "m", "l", "g", "k[1]", "k[2]"};
  Function function;
  function.instructions = {{Opcode::parameter, FunctionId::sin, leaf, 0}};
  program.functions = {function};
  return program;
}

}  // namespace

TEST_CASE("what no function reads is no parameter, and one element brings its array") {
  Subject subject = cart_pole();
  elgen::testing::add_parameter_array(subject.model, "k", {1, 2});
  const auto second = emitted_parameters(subject.model, reading(5));
  REQUIRE(second.size() == 1);
  CHECK(second.front().name == "k");
  CHECK(emitted_parameter_count(subject.model, reading(5)) == 2);
  CHECK(emitted_parameters(subject.model, reading(3)).front().name == "g");
  CHECK(emitted_parameters(subject.model, Program()).empty());
}

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
