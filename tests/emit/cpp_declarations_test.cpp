// cpp_declarations: what a model declares, as it stands in the header.
#include "emit/cpp/cpp_declarations.hpp"

#include "emit/text/parameters.hpp"
#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole_model;

namespace {

std::string value_of(const Model& model, const std::string& name) {
  const TemplateData arrays = declarations(model);
  for (const TemplateData& array : arrays.list_value()) {
    if (array.get("name")->string_value() == name) return array.get("value")->string_value();
  }
  return "absent";
}

Member member(const Model& model, std::size_t index) {
  return declared_parameters(model, model.parameter_arrays).at(index);
}

}  // namespace

TEST_CASE("names, units and bounds") {
  Model model = cart_pole_model();
  model.velocities[1].rate_range = Interval{0, cln::expt(cln::cl_RA(10), cln::cl_I(400))};
  CHECK(value_of(model, "coordinate_names") == "{{\"x\", \"theta\"}}");
  CHECK(value_of(model, "coordinate_units") == "{{\"m\", \"rad\"}}");
  CHECK(value_of(model, "coordinate_ranges") == "{{{-2.0, 2.0}, {-unbounded, unbounded}}}");
  CHECK(value_of(model, "rate_ranges").find("{0.0, unbounded}") != std::string::npos);
  CHECK(value_of(model, "input_limits") == "{{{-20.0, 20.0}}}");
}

TEST_CASE("a model without inputs has empty arrays") {
  Model model = cart_pole_model();
  model.inputs.clear();
  CHECK(value_of(model, "input_names") == "{}");
  CHECK(value_of(model, "input_limits") == "{}");
}

TEST_CASE("parameters and their documentation") {
  Model model = cart_pole_model();
  model.parameter_arrays[0].range = Interval{0, 10};
  CHECK(member(model, 0).declaration.rfind("Scalar M = constant<Scalar>(1.0);", 0) == 0);
  CHECK(member(model, 0).doc == "cart mass [kg] in [0, 10]");
  CHECK(member(model, 3).doc == "[m/s^2]");
}

TEST_CASE("array parameters") {
  Model model = cart_pole_model();
  CHECK_FALSE(has_filled_array(model, model.parameter_arrays));
  elgen::testing::add_parameter_array(model, "k", {1, 2});
  CHECK_FALSE(has_filled_array(model, model.parameter_arrays));
  elgen::testing::add_parameter_array(model, "c", {3, 3, 3});
  CHECK(has_filled_array(model, model.parameter_arrays));
  CHECK(member(model, 4).declaration.rfind("std::array<Scalar, 2> k = {{\n", 0) == 0);
  CHECK(member(model, 5).declaration.rfind(
            "std::array<Scalar, 3> c = detail::filled<3>(constant<Scalar>(3.0));", 0) == 0);
}
