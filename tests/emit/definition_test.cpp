// definition: short functions in one body, long functions in parts, matrices in storage order.
#include "emit/code/definition.hpp"

#include <fmt/format.h>

#include "elgen/step_methods.hpp"
#include "emit/code/statements.hpp"
#include "emit/cpp/cpp_dialect.hpp"
#include "emit/source/source_dialect.hpp"
#include "fixture.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// A model whose gravity is a chain of `statements` sums, each of the two values before the sum.
/// The entries of gravity are the last sum and the value of the instruction `entry`.
Subject long_function(std::size_t statements, std::size_t entry = 1) {
  Subject subject = cart_pole();
  std::string text =
      "coordinates x theta\nfunction gravity\n  0 = coordinate x\n  1 = sin 0\n  2 = cos 0\n";
  for (std::size_t i = 3; i < statements + 3; ++i) {
    text += fmt::format("  {} = add {} {}  ; s{}\n", i, i - 1, i - 2, i);
  }
  text += fmt::format("  result 2 1 = {} {}\n", statements + 2, entry);
  subject.program = read_program(text);
  return subject;
}

FunctionDefinition function_of(const Subject& subject, Storage storage = Storage::row_major) {
  const auto dialect = cpp_dialect(subject.model, subject.program);
  return function_definition(*dialect, subject.program, subject.program.functions.front(), storage);
}

}  // namespace

TEST_CASE("a short function is one body") {
  const FunctionDefinition function = function_of(long_function(20));
  CHECK(function.parts.empty());
  CHECK(function.workspace.members.empty());
  CHECK(mentions(function.whole.body, "return {{"));
}

TEST_CASE("a long function calls its parts in order") {
  const FunctionDefinition function = function_of(long_function(max_body_statements));
  REQUIRE(function.parts.size() == 3);
  CHECK(function.workspace.name == "GravityWorkspace");
  CHECK(function.whole.body ==
        "  Forces<Scalar> result;\n"
        "  detail::GravityWorkspace<Scalar> w;\n"
        "  detail::gravity_part_1(result, w, p, q);\n"
        "  detail::gravity_part_2(result, w, p, q);\n"
        "  detail::gravity_part_3(result, w, p, q);\n"
        "  return result;\n");
  CHECK(mentions(function.whole.signature, "Parameters<Scalar>& p"));
  CHECK(function.workspace.members.size() == 4);  // two values at each of two cuts
  const std::string& member = function.workspace.members.front();
  REQUIRE(member.starts_with("Scalar "));
  const std::string shared = "w." + member.substr(std::string("Scalar ").size());
  CHECK(mentions(function.parts[0].body, "\n  " + shared + " = "));
  CHECK(mentions(function.parts[1].body, shared));
}

TEST_CASE("parts share values of both scalars of a step") {
  Subject subject = long_function(max_body_statements);
  std::vector<Instruction>& all = subject.program.functions.front().instructions;
  for (std::size_t i = 3; i < all.size() / 2; ++i) all[i].is_inner = true;
  const auto dialect = mixed_dialect(subject.model, subject.program, "cart_pole");
  const FunctionDefinition function =
      dialect->function_definition(subject.program.functions.front(), Storage::row_major);
  REQUIRE(function.parts.size() == 3);
  CHECK(function.workspace.members.front().starts_with("Inner "));
  CHECK(function.workspace.members.back().starts_with("Scalar "));
  CHECK(mentions(function.whole.body, "  detail::GravityWorkspace<Scalar, Inner> w;\n"));
  CHECK(mentions(function.whole.signature, "const Parameters<double>& p"));
  CHECK(mentions(function.parts[0].signature, "GravityWorkspace<Scalar, Inner>& w"));
}

TEST_CASE("one call computes the sine and the cosine of an angle") {
  const FunctionDefinition whole = function_of(long_function(20));
  CHECK(whole.whole.body.find(
            "  const auto [sin_x, cos_x] = detail::SineCosine<Scalar>::of(q[0]);\n") == 0);
}

TEST_CASE("one call writes a sine and cosine that parts share") {
  const std::size_t sine = 1;
  const FunctionDefinition parts = function_of(long_function(max_body_statements, sine));
  REQUIRE(parts.parts.size() == 3);
  // The sine is an entry of the first part; later parts need neither the sine nor the cosine.
  CHECK(parts.parts[0].body.find("  const auto [sin_x, cos_x] = ") == 0);
  Subject subject = long_function(max_body_statements);
  Function& gravity = subject.program.functions.front();
  gravity.instructions.back().b = sine;
  const FunctionDefinition shared = function_of(subject);
  CHECK(shared.parts[0].body.find(
            "  std::tie(w.sin_x, w.cos_x) = detail::SineCosine<Scalar>::of(q[0]);\n") == 0);
}

namespace {

/// A chain of sums, as in long_function(), of the sines of x, theta and 2 theta.
Subject function_of_angles(std::size_t statements, const std::string& more = "") {
  Subject subject = long_function(statements);
  std::string text =
      "coordinates x theta\nfunction gravity\n  0 = coordinate x\n  1 = coordinate theta\n"
      "  2 = sin 0\n  3 = cos 0\n  4 = add 1 1\n  5 = sin 4\n  6 = cos 1\n" +
      more + "  7 = add 2 5  ; s7\n";
  for (std::size_t i = 8; i < statements + 8; ++i)
    text += fmt::format("  {} = add {} {}  ; s{}\n", i, i - 1, i % 2 == 0 ? 3 : 6, i);
  subject.program = read_program(text + fmt::format("  result 2 1 = {} {}\n", statements + 7, 2));
  return subject;
}

}  // namespace

TEST_CASE("one call computes all angles of a group") {
  const std::string body = function_of(function_of_angles(3)).whole.body;
  CHECK(body.find("  const auto angles = detail::sines_of<Scalar>(q[0], q[1] + q[1], q[1]);\n"
                  "  const auto [sin_x, cos_x] = angles[0];\n"
                  "  const Scalar sin_theta_theta = angles.sine(1);\n"
                  "  const Scalar cos_theta = angles.cosine(2);\n") == 0);
}

TEST_CASE("the sines of a group cross into other parts together") {
  const FunctionDefinition function = function_of(function_of_angles(max_body_statements));
  REQUIRE(function.parts.size() == 3);
  CHECK(function.parts[0].body.find(
            "  const auto angles = detail::sines_of<Scalar>(q[0], q[1] + q[1], q[1]);\n"
            "  std::tie(w.sin_x, w.cos_x) = angles[0];\n"
            "  w.sin_theta_theta = angles.sine(1);\n"
            "  w.cos_theta = angles.cosine(2);\n") == 0);
  CHECK(mentions(function.parts[2].body, "w.cos_x"));
}

TEST_CASE("every sine of a group has a name") {
  Subject subject = long_function(3);
  subject.program = read_program(
      "coordinates x theta\nfunction gravity\n  0 = coordinate x\n  1 = coordinate theta\n"
      "  2 = multiply 0 1\n  3 = sin 2\n  4 = cos 1\n  5 = add 3 4\n  6 = sin 5\n"
      "  7 = multiply 0 0\n  8 = cos 7\n  9 = cos 8\n  10 = add 6 9\n  result 2 1 = 10 0\n");
  CHECK(function_of(subject).whole.body ==
        "  const auto angles = detail::sines_of<Scalar>(q[0] * q[1], q[1], q[0] * q[0]);\n"
        "  const Scalar sin_1 = angles.sine(0);\n"
        "  const Scalar cos_theta = angles.cosine(1);\n"
        "  const Scalar cos_1 = angles.cosine(2);\n"
        "  const auto angles_2 = detail::sines_of<Scalar>(sin_1 + cos_theta, cos_1);\n"
        "  const Scalar sin_2 = angles_2.sine(0);\n"
        "  const Scalar cos_2 = angles_2.cosine(1);\n"
        "  return {{sin_2 + cos_2, q[0]}};\n");
}

TEST_CASE("parts name only arguments that they use") {
  const FunctionDefinition function = function_of(long_function(max_body_statements));
  const std::string& last = function.parts.back().signature;
  CHECK(mentions(last, "GravityWorkspace<Scalar>& w"));
  CHECK(mentions(last, "const Coordinates<Scalar>&)"));
  CHECK(mentions(function.parts.front().signature, "const Coordinates<Scalar>& q)"));
}

TEST_CASE("column-major matrices are written column by column") {
  Subject subject = cart_pole();
  subject.program = read_program(
      "coordinates x theta\nfunction mass_matrix\n  0 = coordinate x\n  1 = coordinate theta\n"
      "  2 = add 0 1\n  3 = multiply 0 1\n  result 2 2 = 0 1 2 3\n");
  CHECK(function_of(subject).whole.body == "  return {{q[0], q[1], q[0] + q[1], q[0] * q[1]}};\n");
  CHECK(function_of(subject, Storage::column_major).whole.body ==
        "  return {{q[0], q[0] + q[1], q[1], q[0] * q[1]}};\n");
}

namespace {

/// gravity = (s x, s theta), s = x^2 + n theta, n = `before`. The two products are repetitions.
Subject repeating_function(std::size_t before = 0) {
  Subject subject = cart_pole();
  std::string text =
      "coordinates x theta\nfunction gravity\n  0 = coordinate x\n  1 = coordinate theta\n"
      "  2 = multiply 0 0  ; square\n";
  std::size_t at = 3;
  for (; at < before + 3; ++at) text += fmt::format("  {} = add {} 1  ; s{}\n", at, at - 1, at);
  text += fmt::format("  {} = multiply {} 0\n  {} = multiply {} 1\n  result 2 1 = {} {}\n", at,
                      at - 1, at + 1, at - 1, at, at + 1);
  subject.program = read_program(text);
  subject.program.functions.front().repeated = {1, 2};
  return subject;
}

}  // namespace

TEST_CASE("repetitions are a loop over columns") {
  CHECK(function_of(repeating_function()).whole.body ==
        R"(  Scalar given[2];
  Scalar solved[2];
  const Scalar square = q[0] * q[0];
  given[0] = q[0];
  given[1] = q[1];
  using Columns = detail::Columns<Scalar>;
  for (std::size_t first = 0; first < 2; first += Columns::size) {
    const std::size_t at = first + Columns::size < 2 ? first : 2 - Columns::size;
    const typename Columns::Value solved_1 = square * Columns::load(given + at);
    Columns::store(solved_1, solved + at);
  }
  return {{solved[0], solved[1]}};
)");
}

TEST_CASE("interpreted languages loop over the columns of models with many velocities") {
  Subject subject = repeating_function();
  const auto body_in = [&subject](LanguageId language) {
    subject.scene.emission.language = language;
    return source_dialect(subject.model, subject.scene, subject.program)
        ->function_definition(subject.program.functions.front(), Storage::row_major)
        .whole.body;
  };
  CHECK(mentions(body_in(LanguageId::matlab), "  result = [square * q(1); square * q(2)];\n"));
  subject.model.velocities.resize(max_unrolled_velocities + 1);
  CHECK(mentions(body_in(LanguageId::python), R"(    given = [q_0, q_1]
    solved = [0.0] * 2
    for at in range(2):
        solved_1 = square * given[at]
        solved[at] = solved_1
    return [solved[0], solved[1]]
)"));
  CHECK(mentions(body_in(LanguageId::matlab), R"(  given = [q(1); q(2)];
  solved = given(1) + zeros(2, 1);
  for at = 1:2
    solved_1 = square * given(at);
    solved(at) = solved_1;
  end
  result = [solved(1); solved(2)];
)"));
  CHECK(mentions(body_in(LanguageId::javascript), R"(  const solved = [];
  for (let at = 0; at < 2; ++at) {
    const solved_1 = square * given[at];
    solved[at] = solved_1;
  }
)"));
}

TEST_CASE("parts share the arrays of a loop") {
  const FunctionDefinition function = function_of(repeating_function(max_body_statements));
  REQUIRE(function.parts.size() == 3);
  const std::vector<std::string>& shared = function.workspace.members;
  CHECK(shared[shared.size() - 2] == "Scalar given[2]");
  CHECK(shared.back() == "Scalar solved[2]");
  const std::string& last = function.parts.back().body;
  CHECK(mentions(function.parts.front().body, "  w.given[1] = q[1];\n"));
  CHECK(mentions(last,
                 "Columns::load(w.given + at);\n    Columns::store(solved_1, w.solved + at);\n"));
  CHECK(mentions(last, "  result[1] = w.solved[1];\n"));
}
