// Readable forms of expressions, and the comparison of rewritings by precision.
#include <catch2/catch.hpp>

#include "choose/chosen.hpp"
#include "forms/write/rewritings.hpp"
#include "program/expression_leaves.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string written_text(const std::string& expression) {
  const std::string text =
      model_text("written",
                 "[[coordinate]]\nname = \"x\"\n[[coordinate]]\nname = \"y\"\n"
                 "[parameters]\na = 2\nb = 3\nc = 5\n[energy]\n"
                 "T = \"1/2*dot(x)^2 + 1/2*dot(y)^2\"\n[[output]]\nname = \"value\"\nvalue = \"" +
                     expression + "\"\n");
  return readable(chosen(text), "value").at(0);
}

const std::vector<std::string> names{"a", "b", "c", "d", "e"};
const LeafNames leaves{{{}, {}, names, names, {}, {}, names, {}, {}, "t"}, false};

/// True if `rewriting` is as precise as `reference`; their two graphs share no equal parts.
bool is_precise(const char* rewriting, const char* reference, LeafRounding kind) {
  return is_as_precise(expressions_of({rewriting}), expressions_of({reference}),
                       mixed_magnitude_points(leaves), kind);
}

/// The entries whose emitted closed form is less precise than the reference form, such as "bias 0".
std::vector<std::string> imprecise(const std::string& text) {
  const Program program = chosen(text).choice.program;
  const Points points = mixed_magnitude_points(program.leaves);
  std::vector<std::string> result;
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    const Function& function = program.functions[i];
    const Function& readable = program.readable[i];
    if (function.form != Form::closed || readable.fields.empty()) continue;
    const std::vector<std::uint32_t> entries = entries_of(readable);
    for (std::size_t e = 0; e < entries.size(); ++e) {
      const Expressions emitted =
          expressions_from_program(program, function, {entries_of(function)[e]});
      const Expressions judge = expressions_from_program(program, readable, {entries[e]});
      // The bound for rounded leaves, unlike the bound for exact leaves, includes the rounding of
      // angles in sums. An entry must satisfy one of the two bounds.
      const bool is_precise = is_as_precise(emitted, judge, points, LeafRounding::exact) ||
                              is_as_precise(emitted, judge, points, LeafRounding::rounded);
      if (!is_precise) result.push_back(function.name + " " + std::to_string(e));
    }
  }
  return result;
}

}  // namespace

TEST_CASE("the shortest form is written") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"sin(x)^2 + cos(x)^2", "1"},
      {"a*sin(x)^2 + a*cos(x)^2 + b", "a + b"},
      {"a - a*cos(x)^2", "a*sin(x)^2"},
      {"sin(x)*cos(y) - cos(x)*sin(y)", "sin(x - y)"},
      {"cos(x)*cos(y)*a - sin(x)*sin(y)*a", "a*cos(x + y)"},
      {"2*sin(x)*cos(x)", "2*sin(x)*cos(x)"},
      {"(a^2 - b^2)/(a - b)", "a + b"},
      {"a*b + a*c", "a*(b + c)"},
      {"(a*x + b*x)/(c*x)", "(a + b)/c"},
      {"x/a + y/a^2", "(y + a*x)/a^2"},
      {"sin(x)/(1 - cos(x)^2)", "1/sin(x)"},
      {"b - a", "b - a"},
      {"-(a + b)", "-(a + b)"},
      {"sqrt(1 - x^2)/(1 - x^2)^2", "sqrt(1 - x^2)/(1 - x^2)^2"},
      {"cos(x + pi/2)", "-sin(x)"},
      {"exp(x)*exp(y)/exp(x)", "exp(y)"},
  };
  for (const auto& [expression, expected] : rows) {
    INFO(expression);
    CHECK(written_text(expression) == expected);
  }
}

TEST_CASE("a shorter derived form is written only if it loses no digits") {
  CHECK(written_text("(x + a)^3 - x^3") == "a*(3*x*(a + x) + a^2)");
  CHECK(written_text("(a - sqrt(x^2 + y^2))^2") == "(a - sqrt(x^2 + y^2))^2");
  // The rounding of x limits the precision of both forms, cos(x + pi/6) and the derived form.
  CHECK(written_text("cos(x + pi/6)") == "cos(1/6*pi + x)");
}

TEST_CASE("no entry of any output contains both squares") {
  // The spherical pendulum: l^2 (theta'^2 + sin(theta)^2 phi'^2) from three Cartesian components.
  const ChosenForms c = chosen(model_text("spherical", R"toml(
[[coordinate]]
name = "theta"
[[coordinate]]
name = "phi"
[parameters]
m = { value = 2, assume = "positive" }
l = { value = 3, assume = "positive" }
[[point]]
name = "bob"
at = ["l*sin(theta)*cos(phi)", "l*sin(theta)*sin(phi)", "-l*cos(theta)"]
mass = "m"
)toml"));
  CHECK(readable(c, "mass_matrix") ==
        std::vector<std::string>{"m*l^2", "0", "0", "m*l^2*sin(theta)^2"});
  CHECK(readable(c, "velocity_force") ==
        std::vector<std::string>{"-m*l^2*sin(theta)*cos(theta)*dot(phi)^2",
                                 "2*m*l^2*sin(theta)*cos(theta)*dot(theta)*dot(phi)"});
}

TEST_CASE("cancelling terms are detected, and other orders of equal roundings are accepted") {
  const char* const plain = "b + a*d";
  const char* const cancelling = "b + 2*a*(c + 1/2*d) - 2*a*c";
  CHECK_FALSE(is_precise(cancelling, plain, LeafRounding::exact));
  CHECK_FALSE(is_precise(cancelling, plain, LeafRounding::rounded));
  CHECK(is_precise(plain, cancelling, LeafRounding::exact));
  const char* const square = "(a - sqrt(c^2 + d^2))^2";
  const char* const multiplied_out = "a^2 + c^2 + d^2 - 2*a*sqrt(c^2 + d^2)";
  CHECK(is_precise(square, multiplied_out, LeafRounding::exact));
  CHECK(is_precise(square, multiplied_out, LeafRounding::rounded));
  CHECK(is_precise("sin(2*c)", "2*sin(c)*cos(c)", LeafRounding::exact));
  CHECK(is_precise("2*sin(c)*cos(c)", "sin(2*c)", LeafRounding::exact));
}

TEST_CASE("a sum of angles is less precise only if the angles are exact") {
  const char* const shifted = "cos(c + 1)";
  const char* const apart = "cos(c)*cos(1) - sin(c)*sin(1)";
  CHECK_FALSE(is_precise(shifted, apart, LeafRounding::exact));
  CHECK(is_precise(shifted, apart, LeafRounding::rounded));
}

TEST_CASE("a difference of angles is less precise only if the angles are exact") {
  const char* const whole = "a + cos(c - d)";
  const char* const apart = "a + cos(c)*cos(d) + sin(c)*sin(d)";
  CHECK_FALSE(is_precise(whole, apart, LeafRounding::exact));
  CHECK(is_precise(whole, apart, LeafRounding::rounded));
  CHECK(is_precise(whole, whole, LeafRounding::exact));
}

TEST_CASE("without any value no rewriting is accepted") {
  CHECK_FALSE(is_precise("sqrt(-(1 + c^2))", "sqrt(-(1 + c^2))", LeafRounding::exact));
}

TEST_CASE("the code of a closed form is as precise as the reference form") {
  for (const auto& [name, text] : systems()) {
    INFO(name);
    CHECK(imprecise(text) == std::vector<std::string>());
  }
  // The derived form of the second velocity force is the shortest form. In this form the terms
  // c cos(y) x' y', c = cos(1 + sqrt(2)), cancel. Other forms add the angle 1 + sqrt(2) to y.
  CHECK(imprecise(model_text("phase", R"toml(
[[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[parameters]
p = 1
[energy]
T = "(-cos(sqrt(2) + 1))/2*(dot(x) + sin(y)*dot(y))^2 + 3/2*dot(x)^2 + (p + cos(x - y)^2)/2*dot(y)^2"
)toml"))
            .empty());
}
