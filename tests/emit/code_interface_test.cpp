// Tests code_interface: the emitted parameters, the arguments of functions, the types of results
// and fields, and the storage order.
#include "emit/interface/code_interface.hpp"

#include "emit/fixture.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Program program_reading(std::uint32_t leaf) {
  Program program;
  program.leaves.parameters = {"M", "m", "l", "g", "k[1]", "k[2]"};
  Function function;
  function.instructions = {{Opcode::parameter, FunctionId::sin, leaf, 0}};
  program.functions = {function};
  return program;
}

std::string names(const Model& model, const Function& function) {
  std::string text;
  for (const Opcode argument : arguments_of(model, function)) text += leaf_row(argument).symbol;
  return text;
}

}  // namespace

TEST_CASE("struct names") {
  CHECK(camel_case("forward_dynamics") == "ForwardDynamics");
  CHECK(camel_case("x2") == "X2");
}

TEST_CASE("unused parameters are not emitted, and one used element emits its whole array") {
  Subject subject = cart_pole();
  add_parameter_array(subject.model, "k", {1, 2});
  const auto second = emitted_parameters(subject.model, program_reading(5));
  REQUIRE(second.size() == 1);
  CHECK(second.front().name == "k");
  CHECK(emitted_parameter_count(subject.model, program_reading(5)) == 2);
  CHECK(emitted_parameters(subject.model, program_reading(3)).front().name == "g");
  CHECK(emitted_parameters(subject.model, Program()).empty());
}

TEST_CASE("a result with one unnamed field is no struct") {
  const Program program = cart_pole().program;
  CHECK_FALSE(returns_struct(program.functions[0]));
  CHECK(returns_struct(program.functions[4]));
}

TEST_CASE("an energy is a number, the force of one coordinate an array of one") {
  const Field one{"", 1, 1, {0}};
  Model model;
  CHECK(is_scalar(OutputKind::kinetic_energy, one));
  CHECK(is_scalar(OutputKind::user_value, one));
  CHECK_FALSE(is_scalar(OutputKind::gravity, one));
  CHECK_FALSE(is_scalar(OutputKind::user_jacobian, one));
  const Program program = cart_pole().program;
  const Function& function = program.functions[5];
  CHECK_FALSE(is_scalar(program, function, function.fields[1]));
  CHECK(is_scalar(program, function, function.fields[2]));
}

TEST_CASE("column-major matrices are emitted transposed, and vectors are unchanged") {
  Function function;
  function.fields = {{"A", 2, 3, {1, 2, 3, 4, 5, 6}}, {"b", 3, 1, {7, 8, 9}}};
  CHECK(to_storage_order(function, Storage::row_major).fields[0].entries ==
        function.fields[0].entries);
  const Function columns = to_storage_order(function, Storage::column_major);
  CHECK(columns.fields[0].entries == std::vector<std::uint32_t>{1, 4, 2, 5, 3, 6});
  CHECK(columns.fields[0].rows == 3);
  CHECK(columns.fields[1].entries == function.fields[1].entries);
  CHECK(columns.fields[1].rows == 3);
}

TEST_CASE("a result too large for the stack is not returned by value") {
  Function function;
  function.fields = {{"", 64, 64, std::vector<std::uint32_t>(max_returned_entries, 0)}};
  CHECK(is_returned_by_value(function));
  function.fields[0].entries.push_back(0);
  CHECK_FALSE(is_returned_by_value(function));
}

TEST_CASE("types of fields") {
  const Field vector{"", 2, 1, {0, 0}};
  const Field one{"", 1, 1, {0}};
  Model model;
  CHECK(field_type(model, OutputKind::coriolis_matrix, {"", 2, 2, {}}) == "SquareMatrix<Scalar>");
  CHECK(field_type(model, OutputKind::bias, vector) == "Forces<Scalar>");
  CHECK(field_type(model, OutputKind::bias, one) == "Forces<Scalar>");  // an array of one force
  CHECK(field_type(model, OutputKind::total_energy, one) == "Scalar");
  CHECK(field_type(model, OutputKind::user_value, vector) == "std::array<Scalar, 2>");
  CHECK(field_type(model, OutputKind::user_value, one) == "Scalar");
  CHECK(field_type(model, OutputKind::user_jacobian, {"", 3, 2, {}}) ==
        "std::array<Scalar, 3 * velocity_count>");
  const Field pivots{"relative_pivots", 2, 1, {0, 0}};
  CHECK(field_type(model, OutputKind::forward_dynamics, pivots) ==
        "std::array<Scalar, velocity_count>");
  model.constraints.resize(1);
  CHECK(field_type(model, OutputKind::forward_dynamics, pivots) ==
        "std::array<Scalar, velocity_count + constraint_count>");
}

TEST_CASE("types of fields with Eigen") {
  CHECK(eigen_type(OutputKind::coriolis_matrix, {"", 2, 2, {}}) == "Matrix<Scalar, 2, 2>");
  CHECK(eigen_type(OutputKind::bias, {"", 2, 1, {0, 0}}) == "Vector<Scalar, 2>");
  CHECK(eigen_type(OutputKind::total_energy, {"", 1, 1, {0}}) == "Scalar");
}

TEST_CASE("the default namespace is the base name") {
  Scene scene;
  scene.base_name = "cart_pole";
  CHECK(name_space(scene) == "cart_pole");
  CHECK(upper_case(name_space(scene)) == "CART_POLE");
  scene.emission.name_space = "cart2";
  CHECK(name_space(scene) == "cart2");
}

TEST_CASE("sign, min, max and Stumpff functions are emitted and compare numbers") {
  Program program;
  program.functions.emplace_back();
  CHECK_FALSE(needs_ordered_scalar(program.functions[0]));
  program.functions[0].instructions = {{Opcode::call, FunctionId::abs, 0, 0}};
  CHECK_FALSE(needs_ordered_scalar(program.functions[0]));
  program.functions[0].instructions = {{Opcode::call, FunctionId::sign, 0, 0}};
  CHECK(needs_ordered_scalar(program.functions[0]));
  CHECK(function_row(FunctionId::sign).own_name == "sign_of");
  CHECK(function_row(FunctionId::min).own_name == "smaller");
  CHECK(function_row(FunctionId::max).own_name == "larger");
  CHECK(function_row(FunctionId::stumpff).own_name == "stumpff");
}

TEST_CASE("forward dynamics gives pivots") {
  Program program;
  program.functions.emplace_back().kind = OutputKind::bias;
  CHECK_FALSE(returns_pivots(program));
  Function& dynamics = program.functions.emplace_back();
  dynamics.kind = OutputKind::forward_dynamics;
  dynamics.fields = {{.rows = 2, .entries = {0, 1}}};
  CHECK_FALSE(returns_pivots(program));
  dynamics.fields = {{"acceleration", 2, 1, {0, 1}}, {"relative_pivots", 2, 1, {2, 2}}};
  CHECK(returns_pivots(program));
}

TEST_CASE("pages number the entries of a field") {
  const std::vector<std::uint32_t> six{0, 1, 2, 3, 4, 5};
  CHECK(index_text({"", 2, 3, six}, 0) == "[1,1]");
  CHECK(index_text({"", 2, 3, six}, 4) == "[2,2]");
  CHECK(index_text({"", 6, 1, six}, 4) == "[5]");
  CHECK(index_text({"", 1, 1, {0}}, 0).empty());
}

TEST_CASE("the kind of a field of `dynamics` follows from the function or output of its name") {
  Program program;
  Function& renamed = program.functions.emplace_back();
  renamed.kind = OutputKind::gravity;
  renamed.name = "weight";
  Function all;
  all.kind = OutputKind::dynamics;
  CHECK(kind_of_field(program, all, {"weight", 2, 1, {}}) == OutputKind::gravity);
  CHECK(kind_of_field(program, all, {"bias", 2, 1, {}}) == OutputKind::bias);
  CHECK(kind_of_field(program, renamed, {"bias", 2, 1, {}}) == OutputKind::gravity);
}

TEST_CASE("a header declares arrays of names, units and ranges") {
  Model model = cart_pole().model;
  model.coordinates[1].range = Interval{-1, 1};
  model.velocities[1].rate_range = Interval{-2, 2};
  model.inputs[0].limits = Interval{-3, 3};
  std::vector<std::string> names;
  for (const DeclaredArray& array : declared_arrays(model, {})) {
    names.push_back(array.name);
    if (array.name == "coordinate_ranges") CHECK(array.intervals[1]->high == 1);
    if (array.name == "rate_ranges") CHECK(array.intervals[1]->high == 2);
    if (array.name == "input_limits") CHECK(array.intervals[0]->high == 3);
    CHECK(array.size() == (array.name.starts_with("input") ? 1 : 2));
  }
  CHECK(names == std::vector<std::string>{"coordinate_names", "coordinate_units",
                                          "coordinate_ranges", "start_coordinates", "rate_ranges",
                                          "start_rates", "input_names", "input_units",
                                          "input_limits"});
}

TEST_CASE("the values of a parameter array are the values of its elements") {
  Model model = cart_pole().model;
  add_parameter_array(model, "k", {1, 2});
  CHECK(element_values(model, model.parameter_arrays.back()) == std::vector<cln::cl_R>{1, 2});
}

TEST_CASE("arguments have a fixed order, with t and h last") {
  Subject subject = cart_pole();
  const std::vector<Function>& functions = subject.program.functions;
  CHECK(names(subject.model, functions[0]) == "pq");    // mass_matrix
  CHECK(names(subject.model, functions[2]) == "pqv");   // kinetic_energy
  CHECK(names(subject.model, functions[4]) == "pqvu");  // forward_dynamics
  Function inverse_dynamics;
  inverse_dynamics.kind = OutputKind::inverse_dynamics;
  CHECK(names(subject.model, inverse_dynamics) == "pqva");
  Function step;
  step.kind = OutputKind::step;
  CHECK(names(subject.model, step) == "pqvuh");
  subject.model.uses_time = true;
  CHECK(names(subject.model, step) == "pqvuth");
  subject.model.is_quadratic = false;
  CHECK(names(subject.model, functions[0]) == "pqvt");
  Function inverse;
  inverse.kind = OutputKind::inverse_mass_matrix;
  CHECK(names(subject.model, inverse) == "pqvt");
}
