// parameters: which are emitted, how many, and what is said of them.
#include "emit/parameters.hpp"

#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;
using elgen::testing::Subject;

TEST_CASE("an array stays a parameter until every element is fixed") {
  Subject subject = cart_pole();
  elgen::testing::add_parameter_array(subject.model, "k", {1, 2});
  const ParameterArray& array = subject.model.parameter_arrays.back();
  subject.scene.specialisation.fixed[4] = 1;
  CHECK(is_emitted(array, subject.scene));
  subject.scene.specialisation.fixed[5] = 1;
  CHECK_FALSE(is_emitted(array, subject.scene));
}

TEST_CASE("text, unit and range of a parameter") {
  Subject subject = cart_pole();
  CHECK(parameter_doc(subject.model.parameter_arrays[0]) == "cart mass [kg]");
  subject.model.parameter_arrays[1].range = Interval{0, 2};
  CHECK(parameter_doc(subject.model.parameter_arrays[1]) == "[kg] in [0, 2]");
  CHECK(emitted_parameter_count(subject.model, subject.scene) == 4);
}
