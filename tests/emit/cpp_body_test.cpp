// cpp_body: small functions, line for line.
#include "emit/cpp_body.hpp"

#include <fmt/format.h>

#include "emit/cpp_spelling.hpp"
#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;
using elgen::testing::Subject;

namespace {

std::string body_of(const Subject& subject, const Function& function) {
  const CppSpelling spelling(subject.model, subject.program);
  const FunctionBody body = statements(subject.program, function, spelling);
  return cpp_body(cpp_text(subject.program, function, body));
}

std::string body_of(std::size_t function) {
  const Subject subject = cart_pole();
  return body_of(subject, subject.program.functions[function]);
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
  const std::string body = body_of(subject, subject.program.functions[0]);
  CHECK(body.find("using std::abs;") != std::string::npos);
  CHECK(body.find("using std::sign;") == std::string::npos);
}

TEST_CASE("a matrix too long for a line is one row a line, or one entry a line") {
  Subject subject = cart_pole();
  Function function;
  function.instructions = {{Opcode::velocity, FunctionId::sin, 0, 0}};
  function.names = {""};
  function.fields = {{"", 12, 12, std::vector<std::uint32_t>(144, 0)}};
  const std::string row =
      "      v[0], v[0], v[0], v[0], v[0], v[0], v[0], v[0], v[0], v[0], v[0], v[0],\n";
  CHECK(body_of(subject, function).find(row + row) != std::string::npos);
  function.fields = {{"", 2, 40, std::vector<std::uint32_t>(80, 0)}};
  CHECK(body_of(subject, function).find("      v[0],\n      v[0],\n") != std::string::npos);
}

TEST_CASE("big results are written entry by entry") {
  Subject subject = cart_pole();
  Function function;
  function.kind = OutputKind::bias;
  function.instructions = {{Opcode::velocity, FunctionId::sin, 1, 0}};
  function.names = {""};
  const auto count = static_cast<std::uint32_t>(largest_returned + 1);
  function.fields = {{"", count, 1, std::vector<std::uint32_t>(count, 0)}};
  const std::string body = body_of(subject, function);
  CHECK(body.rfind("  result[0] = v[1];\n  result[1] = v[1];\n", 0) == 0);
  CHECK(body.find("return") == std::string::npos);
}

TEST_CASE("a part writes its own values, the shared ones and the entries") {
  Subject subject = cart_pole();
  subject.program = elgen::testing::read_program(
      "coordinates x theta\nfunction gravity\n  0 = coordinate x\n  1 = sin 0\n"
      "  2 = add 1 0  ; sum\n  3 = multiply 2 2  ; square\n  4 = multiply 3 1\n"
      "  result 2 1 = 3 4\n");
  const Function& function = subject.program.functions[0];
  const CppSpelling spelling(subject.model, subject.program);
  const Sections cut = sections(statements(subject.program, function, spelling), 3);
  REQUIRE(cut.parts.size() == 2);
  const FunctionBody body = statements(subject.program, function, spelling, cut.crosses);
  const CppText text = cpp_text(subject.program, function, body);
  CHECK(cpp_part(text, cut, 0) ==
        "  using std::sin;\n"
        "  w.sin_x = sin(q[0]);\n"
        "  const Scalar sum = w.sin_x + q[0];\n"
        "  w.square = sum * sum;\n");
  CHECK(cpp_part(text, cut, 1) ==
        "  result[0] = w.square;\n"
        "  result[1] = w.square * w.sin_x;\n");
}
