#include "derive/lower/from_ginac.hpp"

#include <rapidcheck.h>

#include <catch2/catch.hpp>

#include "derive/lower/equations_from.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/lower.hpp"

using namespace elgen;
using namespace elgen::test;
using GiNaC::ex;

namespace {

/// Imports a value; returns its node and sign.
SignedNode import_value(EquationsOfMotion& equations, const ex& value, Graph& graph) {
  equations.outputs.clear();
  add_output(equations, OutputKind::bias, {value});
  Result<ImportedOutput> result = from_ginac(equations, equations.outputs.back().request, 1000);
  if (!result) FAIL(result.diagnostics.at(0).message);
  graph = std::move(result->graph);
  return result->values.at(0);
}

std::string failure(EquationsOfMotion& equations, const ex& value) {
  equations.outputs.clear();
  add_output(equations, OutputKind::bias, {value});
  const auto result = from_ginac(equations, equations.outputs.back().request, 1000);
  return result ? "" : result.diagnostics.at(0).message;
}

/// A random expression of bounded depth, smooth and defined everywhere.
rc::Gen<ex> expressions(const std::vector<ex>& leaves, int depth) {
  const auto leaf = rc::gen::elementOf(leaves);
  if (depth == 0) return leaf;
  const auto operand = expressions(leaves, depth - 1);
  const auto two = rc::gen::pair(operand, operand);
  return rc::gen::oneOf(
      leaf, rc::gen::map(two, [](const std::pair<ex, ex>& p) { return ex(p.first + p.second); }),
      rc::gen::map(two, [](const std::pair<ex, ex>& p) { return ex(p.first - 3 * p.second); }),
      rc::gen::map(two, [](const std::pair<ex, ex>& p) { return ex(p.first * p.second); }),
      rc::gen::map(two,
                   [](const std::pair<ex, ex>& p) { return ex(p.first / (2 + cos(p.second))); }),
      rc::gen::map(operand, [](const ex& e) { return ex(sin(-e) + pow(e - 1, 3)); }),
      rc::gen::map(operand, [](const ex& e) { return ex(sqrt(1 + e * e) * tanh(e)); }));
}

}  // namespace

TEST_CASE("GiNaC's functions, including kinked ones, are mapped to ours") {
  EquationsOfMotion equations = leaves();
  const ex x = equations.symbols.q[0];
  const ex y = equations.symbols.q[1];
  Graph graph;
  SignedNode value = import_value(equations, elgen_min(x, y), graph);
  CHECK(graph.node(value.node).function == FunctionId::min);
  value = import_value(equations, elgen_abs(-x), graph);
  CHECK(graph.node(value.node).function == FunctionId::abs);
  value = import_value(equations, atan2(x, y), graph);
  CHECK(graph.node(value.node).function == FunctionId::atan2);
  value = import_value(equations, exp(x), graph);
  CHECK(graph.node(value.node).function == FunctionId::exp);
  value = import_value(equations, ex(elgen_expm1(x)).diff(GiNaC::ex_to<GiNaC::symbol>(x)), graph);
  CHECK(graph.node(value.node).function == FunctionId::exp);
  value = import_value(equations, elgen_hypot(-y, x) - elgen_hypot(x, y), graph);
  CHECK(graph.is_zero(value.node));
  value = import_value(equations, ex(elgen_stumpff(x, 3)).subs(x == 0), graph);
  CHECK(graph.rational_of(value.node) == cln::cl_RA(1) / 6);
  value =
      import_value(equations, ex(elgen_stumpff(x, -3)).diff(GiNaC::ex_to<GiNaC::symbol>(x)), graph);
  const SignedNode by_hand =
      import_value(equations, x * (ex(elgen_stumpff(x, -4)) - 3 * ex(elgen_stumpff(x, -5))), graph);
  CHECK(value == by_hand);
  CHECK_FALSE(import_value(equations, ex(elgen_stumpff(-x, -4)), graph) ==
              import_value(equations, ex(elgen_stumpff(x, 4)), graph));
}

TEST_CASE("an inexact number is refused, because its exact value is lost") {
  EquationsOfMotion equations = leaves();
  CHECK(failure(equations, equations.symbols.q[0] * GiNaC::numeric("-0.3")) ==
        "a rounded number reached the equations");
}

TEST_CASE("only the needed definitions are imported, and only once") {
  EquationsOfMotion equations = leaves();
  const ex sine = define_as(equations, "sine", sin(equations.symbols.q[0]));
  define_as(equations, "cosine", cos(equations.symbols.q[0]));
  const ex alias = define_as(equations, "alias", -sine);
  Graph graph;
  const SignedNode value = import_value(equations, alias * sine, graph);
  CHECK(value.is_negative);
  bool has_cosine = false;
  for (NodeId id = 0; id < graph.size(); ++id) {
    has_cosine = has_cosine || graph.node(id).name == "cosine";
  }
  CHECK_FALSE(has_cosine);
}

TEST_CASE("expressions that cannot be imported are reported") {
  EquationsOfMotion equations = leaves();
  const ex x = equations.symbols.q[0];
  CHECK(failure(equations, GiNaC::symbol("stranger")) ==
        "symbol `stranger` is not defined before its use");
  CHECK(failure(equations, x + GiNaC::I) == "a complex number reached the equations");
  CHECK(failure(equations, lgamma(x)) == "cannot import the GiNaC function `lgamma`");
  CHECK(failure(equations, GiNaC::lst{x}) == "cannot import the GiNaC class `lst`");
  const ex zero = define_as(equations, "zero", x - x);
  CHECK(failure(equations, 1 / zero) == "a denominator is 0");
}

TEST_CASE("an open function is a leaf, whatever its arguments") {
  EquationsOfMotion equations = leaves();
  const ex x = equations.symbols.q[0];
  Graph graph;
  const SignedNode value = import_value(equations, elgen_open(0, 1, 11, x * x, 0, 0, 0), graph);
  CHECK(graph.node(value.node).leaf == Opcode::open_value);
  CHECK(graph.node(value.node).index == 2);
  CHECK(failure(equations, elgen_open(0, 1, 111, x, 0, 0, 0)) ==
        "a third derivative of an open function reached the equations");
}

TEST_CASE("a program has the value GiNaC gives") {
  EquationsOfMotion equations = leaves();
  const std::vector<ex> leaves = {equations.symbols.parameters[0], equations.symbols.q[0],
                                  equations.symbols.q[1], equations.symbols.v[0], 2};
  const GiNaC::exmap point = {{leaves[0], GiNaC::numeric(3, 2)},
                              {leaves[1], GiNaC::numeric(-2, 5)},
                              {leaves[2], GiNaC::numeric(7, 8)},
                              {leaves[3], GiNaC::numeric(1, 3)}};
  const auto real = [](const char* text) { return Real(cln::cl_RA(text)); };
  Arguments<Real> arguments;
  arguments.parameters = {real("3/2"), Real()};
  arguments.q = {real("-2/5"), real("7/8")};
  arguments.v = {real("1/3"), Real()};
  GiNaC::Digits = 60;
  CHECK(rc::check("value", [&] {
    const ex first = *expressions(leaves, 3);
    const ex second = *expressions(leaves, 2);
    EquationsOfMotion copy = equations;
    const OutputRequest request =
        add_output(copy, OutputKind::bias, {first + second, first * second - first});
    const Result<Program> program = lower(copy, {request}, {});
    RC_ASSERT(bool(program));
    RC_ASSERT(find_invariant_violation(*program).empty());
    const std::vector<Real> values = evaluate(*program, program->functions[0], arguments);
    for (std::size_t i = 0; i < 2; ++i) {
      const ex exact = copy.outputs[0].fields[0].entries[i].subs(point).evalf();
      const ex difference = GiNaC::abs(exact - GiNaC::numeric(cln::cl_N(values[i].value())));
      // Of the 60 digits, some may be lost if terms up to 1e10 cancel.
      RC_ASSERT(GiNaC::ex_to<GiNaC::numeric>(difference.evalf()).to_double() < 1e-40);
    }
  }));
  GiNaC::Digits = 17;
}
