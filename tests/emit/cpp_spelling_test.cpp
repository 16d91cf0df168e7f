// cpp_spelling: leaves, calls, types and signatures as C++ writes them.
#include "emit/cpp_spelling.hpp"

#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;
using elgen::testing::Subject;

namespace {

Instruction leaf(Opcode opcode, std::uint32_t index) { return {opcode, FunctionId::sin, index, 0}; }

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
  CHECK(spelling.temporary("sin") == "sin_");
  CHECK(spelling.shared("sin_theta") == "w.sin_theta");
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
