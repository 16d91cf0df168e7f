#include "elgen/lower.hpp"

#include <catch2/catch.hpp>
#include <functional>

#include "elgen/evaluate.hpp"
#include "elgen/render.hpp"
#include "lower/equations_from.hpp"

using namespace elgen;
using GiNaC::ex;

namespace {

struct ModelLeaves {
  ex m, l, x, y, vx, vy, ax, u, t;
};

ModelLeaves named(const Symbols& s) {
  return {s.parameters[0], s.parameters[1], s.q[0], s.q[1], s.v[0], s.v[1], s.a[0], s.u[0], s.t};
}

using Make = std::function<std::vector<ex>(const ModelLeaves&)>;

Program lowered(const Make& make, std::size_t rotation = 0) {
  EquationsOfMotion equations = testing::leaves(rotation);
  const std::vector<ex> entries = make(named(equations.symbols));
  const OutputRequest request = testing::add_output(equations, OutputKind::bias, entries);
  Result<Program> program = lower(equations, {request}, {});
  if (!program) FAIL(program.diagnostics.at(0).message);
  CHECK(check_invariants(*program) == "");
  return *program;
}

std::vector<std::string> texts(const Program& program) {
  return equations(program, program.functions.at(0)).entries.at(0);
}

struct LoweredRow {
  std::string what;
  Make make;
  std::vector<std::string> expected;
};

const std::vector<LoweredRow> rows = {
    {"parameters before coordinates before functions before rates",
     [](const ModelLeaves& s) { return std::vector<ex>{s.vx * cos(s.x) * s.y * s.l * s.m}; },
     {"m*l*y*cos(x)*dot(x)"}},
    {"powers",
     [](const ModelLeaves& s) {
       return std::vector<ex>{s.m * s.l * s.l, pow(s.x, -2)};
     },
     {"m*l^2", "1/x^2"}},
    {"a sum starts positive",
     [](const ModelLeaves& s) {
       return std::vector<ex>{s.y - s.x, s.x - s.y};
     },
     {"-(x - y)", "x - y"}},
    {"odd and even functions",
     [](const ModelLeaves& s) {
       return std::vector<ex>{sin(s.y - s.x), cos(s.y - s.x)};
     },
     {"-sin(x - y)", "cos(x - y)"}},
    {"bases merge up to sign",
     [](const ModelLeaves& s) { return std::vector<ex>{(s.x - s.y) * (s.y - s.x) * s.m}; },
     {"-m*(x - y)^2"}},
    {"a common coefficient is pulled out",
     [](const ModelLeaves& s) { return std::vector<ex>{2 * s.y - 2 * s.x}; },
     {"2*(y - x)"}},
    {"half-integer powers",
     [](const ModelLeaves& s) { return std::vector<ex>{pow(s.m, ex(3) / 2)}; },
     {"m*sqrt(m)"}},
    {"other powers",
     [](const ModelLeaves& s) { return std::vector<ex>{pow(s.m, ex(1) / 3)}; },
     {"exp(1/3*log(m))"}},
    {"constants of constants",
     [](const ModelLeaves&) {
       return std::vector<ex>{cos(ex(3) / 10), GiNaC::Pi / 2};
     },
     {"cos(3/10)", "1/2*pi"}},
    {"one division per product",
     [](const ModelLeaves& s) { return std::vector<ex>{s.m * s.x / (s.l * s.y)}; },
     {"m*x/(l*y)"}},
    {"zero and one",
     [](const ModelLeaves& s) {
       return std::vector<ex>{s.x - s.x, s.x / s.x, -ex(1)};
     },
     {"0", "1", "-1"}},
};

}  // namespace

TEST_CASE("GiNaC expressions become canonical programs, whatever GiNaC's order") {
  for (const LoweredRow& row : rows) {
    INFO(row.what);
    const Program program = lowered(row.make);
    CHECK(texts(program) == row.expected);
    for (std::size_t rotation = 1; rotation < 10; ++rotation) {
      CHECK(dump(lowered(row.make, rotation)) == dump(program));
    }
  }
}

TEST_CASE("what outputs share is computed once, up to sign") {
  const Program program = lowered([](const ModelLeaves& s) {
    return std::vector<ex>{s.m * s.l * cos(s.x), -s.m * s.l * sin(s.x), s.x - s.y,
                           s.m * (s.y - s.x)};
  });
  const OperationCounts counts = count_operations(program.functions[0]);
  // m*l, times cos, times sin, x - y, times m
  CHECK(counts.mul == 4);
  CHECK(counts.add == 1);
  CHECK(counts.sincos == 1);
}

TEST_CASE("definitions stay shared and keep their names") {
  EquationsOfMotion equations = testing::leaves();
  const ModelLeaves s = named(equations.symbols);
  const ex height = testing::define_as(equations, "height", s.x + s.l * sin(s.y));
  const ex unused = testing::define_as(equations, "unused", s.x * s.y);
  const OutputRequest request =
      testing::add_output(equations, OutputKind::bias, {height * s.m, height / s.m});
  const Result<Program> program = lower(equations, {request}, {});
  REQUIRE(program);
  const Function& function = program->functions.at(0);
  const std::vector<std::string> names = temporary_names(*program, function);
  CHECK(std::count(names.begin(), names.end(), "height") == 1);
  CHECK(std::count(names.begin(), names.end(), "unused") == 0);
  CHECK(count_operations(function) == OperationCounts{.add = 1, .mul = 2, .div = 1, .sincos = 1});
}

TEST_CASE("dynamics holds what takes neither a nor u, from one computation") {
  EquationsOfMotion equations = testing::leaves();
  const ModelLeaves s = named(equations.symbols);
  std::vector<OutputRequest> requests = {
      testing::add_output(equations, OutputKind::gravity, {sin(s.x)}),
      testing::add_output(equations, OutputKind::bias, {s.vx * sin(s.x)}),
      testing::add_output(equations, OutputKind::inverse_dynamics, {s.ax * sin(s.x)})};
  requests.push_back({.kind = OutputKind::dynamics, .name = "dynamics"});
  const Result<Program> program = lower(equations, requests, {});
  REQUIRE(program);
  CHECK(check_invariants(*program) == "");
  const Function& dynamics = program->functions.at(3);
  REQUIRE(dynamics.fields.size() == 2);
  CHECK(dynamics.fields[0].name == "gravity");
  CHECK(dynamics.fields[1].name == "bias");
  CHECK(count_operations(dynamics) == OperationCounts{.mul = 1, .sincos = 1});
}

TEST_CASE("limits and mistakes") {
  EquationsOfMotion equations = testing::leaves();
  const ModelLeaves s = named(equations.symbols);
  ex chain = s.x;
  for (int i = 0; i < 20; ++i) chain = testing::define_as(equations, "", sin(chain));
  const OutputRequest request = testing::add_output(equations, OutputKind::bias, {chain});
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

TEST_CASE("a denominator that is 0 in any way of writing it is a pivot where M is solved for") {
  const auto message = [](const Make& denominator, const std::vector<OutputKind>& kinds) {
    EquationsOfMotion equations = testing::leaves();
    const ModelLeaves s = named(equations.symbols);
    const ex m_xx = denominator(s)[0];
    std::vector<OutputRequest> requests;
    for (const OutputKind kind : kinds) {
      const bool is_mass = kind == OutputKind::mass_matrix;
      requests.push_back(testing::add_output(
          equations, kind, is_mass ? std::vector<ex>{m_xx, s.m, s.m, s.m} : std::vector{1 / m_xx}));
      if (!is_mass) continue;
      FieldEquations& field = equations.outputs.back().fields[0];
      field.rows = field.columns = 2;
    }
    const Result<Program> program = lower(equations, requests, {});
    return program ? std::string() : program.diagnostics.at(0).message;
  };
  const Make by_import = [](const ModelLeaves& s) {
    return std::vector<ex>{pow(cos(s.x), 2) + pow(sin(s.x), 2) - 1};
  };
  const Make by_angles = [](const ModelLeaves& s) {
    return std::vector<ex>{sin(3 * s.x) - sin(s.x) * cos(2 * s.x) - cos(s.x) * sin(2 * s.x)};
  };
  for (const Make& zero : {by_import, by_angles}) {
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

TEST_CASE("a chain of 5000 definitions is lowered without recursion on it") {
  EquationsOfMotion equations = testing::leaves();
  const ModelLeaves s = named(equations.symbols);
  ex position = s.x;
  for (int i = 0; i < 5000; ++i) {
    Definition definition;
    definition.symbol = GiNaC::symbol();
    definition.value = s.m * sin(position) + s.l;
    if (i > 0) definition.uses = {static_cast<std::uint32_t>(i - 1)};
    equations.definitions.list.push_back(definition);
    position = definition.symbol;
  }
  const OutputRequest request = testing::add_output(equations, OutputKind::bias, {position});
  const Result<Program> program = lower(equations, {request}, {});
  REQUIRE(program);
  CHECK(count_operations(program->functions[0]) ==
        OperationCounts{.add = 5000, .mul = 5000, .sincos = 5000});
}
