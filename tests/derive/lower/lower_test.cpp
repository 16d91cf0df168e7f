#include "elgen/lower.hpp"

#include <catch2/catch.hpp>

#include "derive/lower/equations_from.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/page.hpp"

using namespace elgen;
using namespace elgen::test;
using GiNaC::ex;

namespace {

struct ModelLeaves {
  ex m, l, x, y, vx, vy, ax, u, t;
};

ModelLeaves leaves_of(const Symbols& s) {
  return {s.parameters[0], s.parameters[1], s.q[0], s.q[1], s.v[0], s.v[1], s.a[0], s.u[0], s.t};
}

using Strings = std::vector<std::string>;

/// The expressions of `texts`, parsed by GiNaC with the symbols m, l, x, y and vx.
std::vector<ex> expressions(const Symbols& s, const Strings& texts) {
  const auto [m, l, x, y, vx, vy, ax, u, t] = leaves_of(s);
  GiNaC::parser reader({{"m", m}, {"l", l}, {"x", x}, {"y", y}, {"vx", vx}}, true);
  std::vector<ex> result;
  for (const std::string& text : texts) result.push_back(reader(text));
  return result;
}

Program lowered(const Strings& entries, std::size_t rotation = 0) {
  EquationsOfMotion equations = leaves(rotation);
  const OutputRequest request =
      add_output(equations, OutputKind::bias, expressions(equations.symbols, entries));
  Result<Program> program = lower(equations, {request}, {});
  if (!program) FAIL(program.diagnostics.at(0).message);
  CHECK(find_invariant_violation(*program) == "");
  return *program;
}

struct LoweredRow {
  const char* what;
  Strings entries;
  Strings expected;
};

const std::vector<LoweredRow> rows = {
    {"parameters before coordinates before functions before rates",
     {"vx*cos(x)*y*l*m"},
     {"m*l*y*cos(x)*dot(x)"}},
    {"powers", {"m*l*l", "x^(-2)"}, {"m*l^2", "1/x^2"}},
    {"a sum starts positive", {"y - x", "x - y"}, {"-(x - y)", "x - y"}},
    {"odd and even functions", {"sin(y - x)", "cos(y - x)"}, {"-sin(x - y)", "cos(x - y)"}},
    {"bases merge up to sign", {"(x - y)*(y - x)*m"}, {"-m*(x - y)^2"}},
    {"a common coefficient is pulled out", {"2*y - 2*x"}, {"2*(y - x)"}},
    {"half-integer powers", {"m^(3/2)"}, {"m*sqrt(m)"}},
    {"other powers", {"m^(1/3)"}, {"exp(1/3*log(m))"}},
    {"constants of constants", {"cos(3/10)", "Pi/2"}, {"cos(3/10)", "1/2*pi"}},
    {"one division per product", {"m*x/(l*y)"}, {"m*x/(l*y)"}},
    {"zero and one", {"x - x", "x/x", "-1"}, {"0", "1", "-1"}},
};

}  // namespace

TEST_CASE("GiNaC expressions become canonical programs, independent of GiNaC's order") {
  for (const LoweredRow& row : rows) {
    INFO(row.what);
    const Program program = lowered(row.entries);
    const Function& function = program.functions.at(0);
    const std::vector<std::string> names = temporary_names(program, function);
    CHECK(texts_of(function_equations(program, function, names).entries.at(0)) == row.expected);
    for (std::size_t rotation = 1; rotation < 10; ++rotation) {
      CHECK(dump(lowered(row.entries, rotation)) == dump(program));
    }
  }
}

TEST_CASE("common subexpressions of outputs are computed once, up to sign") {
  const Program program = lowered({"m*l*cos(x)", "-m*l*sin(x)", "x - y", "m*(y - x)"});
  // Instructions: m*l, times cos, times sin, x - y, times m.
  CHECK(count_operations(program.functions[0]) == OperationCounts{.add = 1, .mul = 4, .sincos = 1});
}

TEST_CASE("definitions stay shared and keep their names") {
  EquationsOfMotion equations = leaves();
  const ModelLeaves s = leaves_of(equations.symbols);
  const ex height = define_as(equations, "height", s.x + s.l * sin(s.y));
  const ex unused = define_as(equations, "unused", s.x * s.y);
  const OutputRequest request =
      add_output(equations, OutputKind::bias, {height * s.m, height / s.m});
  const Result<Program> program = lower(equations, {request}, {});
  REQUIRE(program);
  const Function& function = program->functions.at(0);
  const std::vector<std::string> names = temporary_names(*program, function);
  CHECK(std::count(names.begin(), names.end(), "height") == 1);
  CHECK(std::count(names.begin(), names.end(), "unused") == 0);
  CHECK(count_operations(function) == OperationCounts{.add = 1, .mul = 2, .div = 1, .sincos = 1});
}

TEST_CASE("dynamics computes all outputs without a and u together") {
  EquationsOfMotion equations = leaves();
  const ModelLeaves s = leaves_of(equations.symbols);
  std::vector<OutputRequest> requests = {
      add_output(equations, OutputKind::gravity, {sin(s.x)}),
      add_output(equations, OutputKind::bias, {s.vx * sin(s.x)}),
      add_output(equations, OutputKind::inverse_dynamics, {s.ax * sin(s.x)})};
  requests.push_back({.kind = OutputKind::dynamics, .name = "dynamics"});
  const Result<Program> program = lower(equations, requests, {});
  REQUIRE(program);
  CHECK(find_invariant_violation(*program) == "");
  const Function& dynamics = program->functions.at(3);
  REQUIRE(dynamics.fields.size() == 2);
  CHECK(dynamics.fields[0].name == "gravity");
  CHECK(dynamics.fields[1].name == "bias");
  CHECK(count_operations(dynamics) == OperationCounts{.mul = 1, .sincos = 1});
}

TEST_CASE("limits and mistakes") {
  EquationsOfMotion equations = leaves();
  const ModelLeaves s = leaves_of(equations.symbols);
  ex chain = s.x;
  for (int i = 0; i < 20; ++i) chain = define_as(equations, "", sin(chain));
  const OutputRequest request = add_output(equations, OutputKind::bias, {chain});
  Limits limits;
  limits.derived_nodes = 15;
  const Result<Program> too_many = lower(equations, {request}, limits);
  REQUIRE_FALSE(too_many);
  CHECK(too_many.diagnostics.at(0).code == Code::E908);
  const Result<Program> underived =
      lower(equations, {{.kind = OutputKind::gravity, .name = "gravity"}}, {});
  REQUIRE_FALSE(underived);
  CHECK(underived.diagnostics.at(0).message == "`gravity` was not derived");
}

TEST_CASE("a denominator that simplifies to 0 is reported, as a pivot if the output solves for M") {
  const auto message = [](const std::string& denominator, const std::vector<OutputKind>& kinds) {
    EquationsOfMotion equations = leaves();
    const ex m = leaves_of(equations.symbols).m;
    const ex m_xx = expressions(equations.symbols, {denominator})[0];
    std::vector<OutputRequest> requests;
    for (const OutputKind kind : kinds) {
      const bool is_mass = kind == OutputKind::mass_matrix;
      requests.push_back(add_output(
          equations, kind, is_mass ? std::vector<ex>{m_xx, m, m, m} : std::vector{1 / m_xx}));
      if (!is_mass) continue;
      FieldEquations& field = equations.outputs.back().fields[0];
      field.rows = field.columns = 2;
    }
    const Result<Program> program = lower(equations, requests, {});
    return program ? std::string() : program.diagnostics.at(0).message;
  };
  // The first zero is found by the import, the second by angle sums.
  for (const char* zero :
       {"cos(x)^2 + sin(x)^2 - 1", "sin(3*x) - sin(x)*cos(2*x) - cos(x)*sin(2*x)"}) {
    CHECK(message(zero, {OutputKind::mass_matrix}).empty());
    CHECK(message(zero, {OutputKind::gravity}) ==
          "a denominator of `gravity` is 0, whatever the state is");
    CHECK(message(zero, {OutputKind::forward_dynamics}) ==
          "`forward_dynamics` has no value: the mass matrix is singular, whatever the state is");
    CHECK(message(zero, {OutputKind::mass_matrix, OutputKind::forward_dynamics}) ==
          "`forward_dynamics` has no value: the rate of `x` alone has no kinetic energy, whatever "
          "the state is");
  }
}

TEST_CASE("a chain of 5000 definitions is lowered without deep recursion") {
  EquationsOfMotion equations = leaves();
  const ModelLeaves s = leaves_of(equations.symbols);
  ex position = s.x;
  for (int i = 0; i < 5000; ++i) {
    Definition definition;
    definition.symbol = GiNaC::symbol();
    definition.value = s.m * sin(position) + s.l;
    if (i > 0) definition.used_definitions = {static_cast<std::uint32_t>(i - 1)};
    equations.definitions.list.push_back(definition);
    position = definition.symbol;
  }
  const OutputRequest request = add_output(equations, OutputKind::bias, {position});
  const Result<Program> program = lower(equations, {request}, {});
  REQUIRE(program);
  CHECK(count_operations(program->functions[0]) ==
        OperationCounts{.add = 5000, .mul = 5000, .sincos = 5000});
}
