// cpp_signature: arguments by the table, names by the body, lines within their width.
#include "emit/cpp_signature.hpp"

#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;
using elgen::testing::Subject;

namespace {

std::string names(const Model& model, const Function& function) {
  std::string text;
  for (const CppArgument& argument : cpp_arguments(model, function)) text += argument.name;
  return text;
}

}  // namespace

TEST_CASE("arguments in one order, t last") {
  Subject subject = cart_pole();
  const std::vector<Function>& functions = subject.program.functions;
  CHECK(names(subject.model, functions[0]) == "pq");    // mass_matrix
  CHECK(names(subject.model, functions[2]) == "pqv");   // kinetic_energy
  CHECK(names(subject.model, functions[4]) == "pqvu");  // forward_dynamics
  Function inverse_dynamics;
  inverse_dynamics.kind = OutputKind::inverse_dynamics;
  CHECK(names(subject.model, inverse_dynamics) == "pqva");
  subject.model.uses_time = true;
  subject.model.quadratic = false;
  CHECK(names(subject.model, functions[0]) == "pqvt");
}

TEST_CASE("types of results") {
  const Program program = cart_pole().program;
  CHECK(result_type(program.functions[0]) == "SquareMatrix<Scalar>");
  CHECK(result_type(program.functions[4]) == "ForwardDynamics<Scalar>");
}

TEST_CASE("a word is mentioned where it stands alone") {
  CHECK(mentions("p.m * q[0]", "q"));
  CHECK(mentions("sin(q[1])", "sin"));
  CHECK_FALSE(mentions("asin(q[1])", "sin"));
  CHECK_FALSE(mentions("sin_theta + sine", "sin"));
  CHECK_FALSE(mentions("p.v + w.v", "v"));
  CHECK_FALSE(mentions("", "t"));
}

TEST_CASE("arguments without use have no name") {
  const std::vector<CppArgument> arguments = {{"const A&", "a"}, {"const B&", "b"}};
  CHECK(cpp_signature("void f", arguments, "b[0]") == "void f(const A&, const B& b) noexcept");
}

TEST_CASE("long signatures break between arguments, below the first one where there is room") {
  const std::vector<CppArgument> arguments = {{std::string(30, 'A'), "a"},
                                              {std::string(30, 'B'), "b"}};
  const std::string start = "[[nodiscard]] Forces<Scalar> gravity";
  CHECK(cpp_signature(start, arguments, "") == start + "(" + std::string(30, 'A') + ",\n" +
                                                   std::string(start.size() + 1, ' ') +
                                                   std::string(30, 'B') + ") noexcept");
  const std::string wide(70, 'x');
  CHECK(cpp_signature(wide, arguments, "") ==
        wide + "(\n    " + std::string(30, 'A') + ", " + std::string(30, 'B') + ") noexcept");
}
