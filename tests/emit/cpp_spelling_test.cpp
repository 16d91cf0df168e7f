// cpp_spelling: leaves, calls, types and signatures as C++ writes them.
#include "emit/cpp_spelling.hpp"

#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;
using elgen::testing::Subject;

namespace {

Instruction leaf(Opcode opcode, std::uint32_t index) {
  return {opcode, FunctionId::sin, index, 0};
}

Function with_kind(OutputKind kind, std::uint32_t rows) {
  Function function;
  function.kind = kind;
  function.name = std::string(output_row(kind).name);
  function.fields.push_back({"", rows, 1, std::vector<std::uint32_t>(rows, 0)});
  return function;
}

}  // namespace

TEST_CASE("leaves") {
  Subject subject = cart_pole();
  elgen::testing::add_parameter_array(subject.model, "k", {1, 2});
  subject.program.leaves.parameters = {"g", "k[2]"};
  const CppSpelling spelling(subject.model, subject.program);
  CHECK(spelling.leaf(leaf(Opcode::parameter, 0)) == "p.g");
  CHECK(spelling.leaf(leaf(Opcode::parameter, 1)) == "p.k[1]");
  CHECK(spelling.leaf(leaf(Opcode::coordinate, 1)) == "q[1]");
  CHECK(spelling.leaf(leaf(Opcode::velocity, 0)) == "v[0]");
  CHECK(spelling.leaf(leaf(Opcode::acceleration, 0)) == "a[0]");
  CHECK(spelling.leaf(leaf(Opcode::input, 0)) == "u[0]");
  CHECK(spelling.leaf(leaf(Opcode::time, 0)) == "t");
}

TEST_CASE("constants stand where they are used when they are short") {
  const Subject subject = cart_pole();
  const CppSpelling spelling(subject.model, subject.program);
  CHECK(spelling.constant({2, "2"}).text == "constant<Scalar>(2.0)");
  CHECK(spelling.constant({cln::cl_RA(1) / 3, "1/3"}).text == "number_1_3<Scalar>()");
  const Term negative = spelling.constant({-1, "-1"});
  CHECK(negative.text == "-constant<Scalar>(1.0)");
  CHECK(negative.precedence == Precedence::negation);
}

TEST_CASE("calls") {
  const Subject subject = cart_pole();
  const CppSpelling spelling(subject.model, subject.program);
  CHECK(spelling.call(FunctionId::atan2, "y, x") == "atan2(y, x)");
  CHECK(spelling.call(FunctionId::sign, "x") == "detail::sign_of<Scalar>(x)");
  CHECK(spelling.call(FunctionId::min, "x, y") == "detail::smaller<Scalar>(x, y)");
  CHECK(spelling.call(FunctionId::max, "x, y") == "detail::larger<Scalar>(x, y)");
  CHECK(spelling.square_root("x") == "sqrt(x)");
}

TEST_CASE("types of fields") {
  const Field vector{"", 2, 1, {0, 0}};
  const Field one{"", 1, 1, {0}};
  CHECK(field_type(OutputKind::coriolis_matrix, {"", 2, 2, {}}) == "SquareMatrix<Scalar>");
  CHECK(field_type(OutputKind::bias, vector) == "Forces<Scalar>");
  CHECK(field_type(OutputKind::bias, one) == "Forces<Scalar>");  // of one coordinate
  CHECK(field_type(OutputKind::total_energy, one) == "Scalar");
  CHECK(field_type(OutputKind::user_value, vector) == "std::array<Scalar, 2>");
  CHECK(field_type(OutputKind::user_value, one) == "Scalar");
  CHECK(field_type(OutputKind::user_jacobian, {"", 3, 2, {}}) ==
        "std::array<Scalar, 3 * velocity_count>");
}

TEST_CASE("signatures take all arguments and name those that are used") {
  const Subject subject = cart_pole();
  CHECK(cpp_signature(subject.model, subject.program.functions[2]) ==
        "[[nodiscard]] Scalar kinetic_energy(const Parameters<Scalar>& p, "
        "const Coordinates<Scalar>&,\n"
        "                                    const Velocities<Scalar>& v) noexcept");
}

TEST_CASE("time comes last in every function of a model that has it") {
  Subject subject = cart_pole();
  subject.model.uses_time = true;
  const std::string signature = cpp_signature(subject.model, subject.program.functions[0]);
  CHECK(signature.find("const std::common_type_t<Scalar>&) noexcept") != std::string::npos);
}

TEST_CASE("the mass matrix takes v where L is not quadratic") {
  Subject subject = cart_pole();
  subject.model.quadratic = false;
  CHECK(cpp_signature(subject.model, subject.program.functions[0]).find("Velocities<Scalar>&)") !=
        std::string::npos);
}

TEST_CASE("more entries than a stack should hold are written by reference") {
  const Model model = cart_pole().model;
  const std::string at = cpp_signature(model, with_kind(OutputKind::bias, largest_returned));
  const std::string beyond = cpp_signature(model, with_kind(OutputKind::bias, largest_returned + 1));
  CHECK(at.rfind("[[nodiscard]] Forces<Scalar> bias(const Parameters", 0) == 0);
  CHECK(beyond.rfind("void bias(Forces<Scalar>& result, const Parameters", 0) == 0);
}
