// Tests the text that cpp_dialect writes: small functions, leaves, constants and calls, also for
// Eigen. tests/pipeline/languages_test.cpp compiles code for Eigen.
#include "emit/cpp/cpp_dialect.hpp"

#include "emit/code/definition.hpp"
#include "emit/interface/code_interface.hpp"
#include "fixture.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string body_of(const Subject& subject, const Function& function) {
  const auto dialect = cpp_dialect(subject.model, subject.program);
  return function_definition(*dialect, subject.program, function, Storage::row_major).whole.body;
}

std::string body_of(std::size_t function) {
  const Subject subject = cart_pole();
  return body_of(subject, subject.program.functions[function]);
}

DefinitionText on_eigen(std::size_t function) {
  const Subject subject = cart_pole();
  const auto dialect = eigen_dialect(subject.model, subject.program);
  return function_definition(*dialect, subject.program, subject.program.functions[function],
                             Storage::row_major)
      .whole;
}

}  // namespace

TEST_CASE("a body declares used functions and named values, then returns the result") {
  CHECK(body_of(1) ==
        "  const Scalar sin_theta = detail::Sine<Scalar>::of(q[1]);\n"
        "  return {{constant<Scalar>(0.0), -p.g * p.l * p.m * sin_theta}};\n");
}

TEST_CASE("a scalar is returned without braces, a struct field by field") {
  CHECK(body_of(2) == "  return constant<Scalar>(0.5) * p.M * (v[0] * v[0]);\n");
  CHECK(body_of(4) ==
        "  using std::sqrt;\n"
        "  return {\n"
        "      {{u[0] / p.M, number_1_3<Scalar>() * sqrt(p.l)}},\n"
        "      {{constant<Scalar>(1.0), constant<Scalar>(1.0)}},\n"
        "  };\n");
}

TEST_CASE("kinked functions are emitted in the header") {
  Subject subject = cart_pole();
  subject.program = read_program(
      "coordinates x theta\nfunction applied_force\n  0 = velocity x\n  1 = sign 0\n"
      "  2 = abs 0\n  result 2 1 = 1 2\n");
  const std::string body = body_of(subject, subject.program.functions[0]);
  CHECK(mentions(body, "using std::abs;"));
  CHECK_FALSE(mentions(body, "using std::sign;"));
}

TEST_CASE("a matrix too long for a line has one row or one entry per line") {
  Subject subject = cart_pole();
  Function function;
  function.instructions = {{Opcode::velocity, FunctionId::sin, 0, 0}};
  function.names = {""};
  function.fields = {{"", 12, 12, std::vector<std::uint32_t>(144, 0)}};
  const std::string row =
      "      v[0], v[0], v[0], v[0], v[0], v[0], v[0], v[0], v[0], v[0], v[0], v[0],\n";
  CHECK(mentions(body_of(subject, function), row + row));
  function.fields = {{"", 2, 40, std::vector<std::uint32_t>(80, 0)}};
  CHECK(mentions(body_of(subject, function), "      v[0],\n      v[0],\n"));
}

TEST_CASE("big results are written entry by entry") {
  Subject subject = cart_pole();
  Function function;
  function.kind = OutputKind::bias;
  function.name = "bias";
  function.instructions = {{Opcode::velocity, FunctionId::sin, 1, 0}};
  function.names = {""};
  const auto count = static_cast<std::uint32_t>(max_returned_entries + 1);
  function.fields = {{"", count, 1, std::vector<std::uint32_t>(count, 0)}};
  const auto dialect = cpp_dialect(subject.model, subject.program);
  const FunctionDefinition written =
      function_definition(*dialect, subject.program, function, Storage::row_major);
  REQUIRE(written.parts.size() > 1);
  const std::string& first = written.parts.front().body;
  CHECK(first.rfind("  result[0] = v[1];\n  result[1] = v[1];\n", 0) == 0);
  CHECK(written.whole.signature.rfind("ELGEN_FUNCTION void bias(Forces<Scalar>& result,", 0) == 0);
  CHECK_FALSE(mentions(written.whole.body, "return"));
}

TEST_CASE("leaves") {
  Subject subject = cart_pole();
  add_parameter_array(subject.model, "k", {1, 2});
  subject.program.leaves.parameters = {"g", "k[2]"};
  const auto dialect = cpp_dialect(subject.model, subject.program);
  CHECK(dialect->leaf(Opcode::parameter, 0) == "p.g");
  CHECK(dialect->leaf(Opcode::parameter, 1) == "p.k[1]");
  CHECK(dialect->leaf(Opcode::coordinate, 1) == "q[1]");
  CHECK(dialect->leaf(Opcode::velocity, 0) == "v[0]");
  CHECK(dialect->leaf(Opcode::acceleration, 0) == "a[0]");
  CHECK(dialect->leaf(Opcode::input, 0) == "u[0]");
  CHECK(dialect->leaf(Opcode::time, 0) == "t");
}

TEST_CASE("short constants are written at their use") {
  const Subject subject = cart_pole();
  const auto dialect = cpp_dialect(subject.model, subject.program);
  CHECK(dialect->constant(rational_constant(2)).text == "constant<Scalar>(2.0)");
  CHECK(dialect->constant(rational_constant(cln::cl_RA(1) / 3)).text == "number_1_3<Scalar>()");
  const FormulaText negative = dialect->constant(rational_constant(-1));
  CHECK(negative.text == "-constant<Scalar>(1.0)");
  CHECK(negative.binding == Binding::negation);
}

TEST_CASE("calls") {
  const Subject subject = cart_pole();
  const auto dialect = cpp_dialect(subject.model, subject.program);
  CHECK(dialect->call(FunctionId::atan2, {{"y"}, {"x"}}).text == "atan2(y, x)");
  CHECK(dialect->call(FunctionId::cos, {{"x"}}).text == "detail::Cosine<Scalar>::of(x)");
  CHECK(dialect->call(FunctionId::sign, {{"x"}}).text == "detail::sign_of<Scalar>(x)");
  CHECK(dialect->call(FunctionId::min, {{"x"}, {"y"}}).text == "detail::smaller<Scalar>(x, y)");
  CHECK(dialect->call(FunctionId::max, {{"x"}, {"y"}}).text == "detail::larger<Scalar>(x, y)");
  CHECK(dialect->square_root({"x"}).text == "sqrt(x)");
  CHECK(dialect->temporary_name("sin") == "sin_");
  CHECK(dialect->workspace_member("sin_theta") == "w.sin_theta");
}

TEST_CASE("Eigen: arguments are read in place, entries written into the result") {
  const DefinitionText text = on_eigen(1);
  CHECK(text.signature ==
        "[[nodiscard]] Vector<Scalar, 2> gravity(const Parameters<Scalar>& p,\n"
        "                                        const Argument<Scalar, 2>& q) noexcept");
  CHECK(text.body ==
        "  const Scalar sin_theta = detail::Sine<Scalar>::of(q[1]);\n"
        "  Vector<Scalar, 2> result;\n"
        "  result(0) = constant<Scalar>(0.0);\n"
        "  result(1) = -p.g * p.l * p.m * sin_theta;\n"
        "  return result;\n");
}

TEST_CASE("Eigen: a matrix stored by columns has the shape of the function's result") {
  const Subject subject = cart_pole();
  const auto dialect = eigen_dialect(subject.model, subject.program);
  Function function = subject.program.functions[1];
  function.fields = {{"", 2, 3, {0, 1, 0, 1, 0, 1}}};
  const DefinitionText text =
      function_definition(*dialect, subject.program, function, Storage::column_major).whole;
  CHECK(mentions(text.signature, "Matrix<Scalar, 2, 3> gravity("));
  CHECK(mentions(text.body, "  Matrix<Scalar, 2, 3> result;\n"));
}

TEST_CASE("Eigen: numbers are returned, structs filled") {
  CHECK(on_eigen(2).body == "  return constant<Scalar>(0.5) * p.M * (v[0] * v[0]);\n");
  CHECK(
      mentions(on_eigen(4).body, "  ForwardDynamics<Scalar> result;\n  result.acceleration(0) = "));
}

TEST_CASE("Eigen: temporaries hide no names of the header") {
  const Subject subject = cart_pole();
  const auto dialect = eigen_dialect(subject.model, subject.program);
  CHECK(dialect->temporary_name("Vector") == "Vector_");
  CHECK(dialect->temporary_name("sin") == "sin_");
  CHECK(dialect->temporary_name("Vectors") == "Vectors");
}

TEST_CASE("temporaries with a used name get an underscore") {
  const Subject subject = cart_pole();
  const auto dialect = cpp_dialect(subject.model, subject.program);
  CHECK(dialect->temporary_name("sin_theta") == "sin_theta");
  for (const std::string name : {"p", "w", "sin", "constant", "velocity_count"}) {
    CHECK(dialect->temporary_name(name) == name + "_");
  }
}
