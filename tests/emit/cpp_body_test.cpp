// cpp_body: small functions, line for line.
#include "emit/cpp_body.hpp"

#include <fmt/format.h>

#include "emit/cpp_spelling.hpp"
#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;
using elgen::testing::Subject;

namespace {

std::string body_of(std::size_t function) {
  const Subject subject = cart_pole();
  return cpp_body(subject.model, subject.program, subject.program.functions[function]);
}

}  // namespace

TEST_CASE("functions called, named values, result") {
  CHECK(body_of(1) ==
        "  using std::sin;\n"
        "  const Scalar sin_theta = sin(q[1]);\n"
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

TEST_CASE("kinked functions are the header's own") {
  Subject subject = cart_pole();
  subject.program = elgen::testing::read_program(
      "coordinates x theta\nfunction applied_force\n  0 = velocity x\n  1 = sign 0\n"
      "  2 = abs 0\n  result 2 1 = 1 2\n");
  const std::string body = cpp_body(subject.model, subject.program, subject.program.functions[0]);
  CHECK(body.find("using std::abs;") != std::string::npos);
  CHECK(body.find("using std::sign;") == std::string::npos);
}

TEST_CASE("a matrix too long for a line is one row a line, or one entry a line") {
  Subject subject = cart_pole();
  Function function;
  function.instructions = {{Opcode::velocity, FunctionId::sin, 0, 0}};
  function.names = {""};
  function.fields = {{"", 12, 12, std::vector<std::uint32_t>(144, 0)}};
  const std::string row = "      v[0], v[0], v[0], v[0], v[0], v[0], v[0], v[0], v[0], v[0], v[0], v[0],\n";
  CHECK(cpp_body(subject.model, subject.program, function).find(row + row) != std::string::npos);
  function.fields = {{"", 2, 40, std::vector<std::uint32_t>(80, 0)}};
  CHECK(cpp_body(subject.model, subject.program, function).find("      v[0],\n      v[0],\n") !=
        std::string::npos);
}

TEST_CASE("big results are written entry by entry") {
  Subject subject = cart_pole();
  Function function;
  function.kind = OutputKind::bias;
  function.instructions = {{Opcode::velocity, FunctionId::sin, 1, 0}};
  function.names = {""};
  const auto count = static_cast<std::uint32_t>(largest_returned + 1);
  function.fields = {{"", count, 1, std::vector<std::uint32_t>(count, 0)}};
  const std::string body = cpp_body(subject.model, subject.program, function);
  CHECK(body.rfind("  result[0] = v[1];\n  result[1] = v[1];\n", 0) == 0);
  CHECK(body.find("return") == std::string::npos);
}
