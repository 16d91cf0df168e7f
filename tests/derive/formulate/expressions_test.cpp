// Translation of expressions to GiNaC: equal values, small definitions.
#include "derive/formulate/expressions.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "derive/formulate/written_out.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;
using GiNaC::ex;

namespace {

/// V/E with definitions written out, in a model with V = E*(`text`), a coordinate x and parameters
/// k and E. Sets `lagrangian`.
ex translate_potential(const std::string& text, Lagrangian& lagrangian) {
  const auto result = formulate(checked_model(model_text("one", R"toml(
[[coordinate]]
name = "x"
[parameters]
k = 2
E = { value = 1, doc = "without a unit, so that V has any" }
[energy]
T = "E*dot(x)^2/2"
V = "E*()toml" + text + ")\"\n"))
                                    .model);
  REQUIRE(result);
  lagrangian = *result;
  ex sum = 0;
  for (const EnergyTerm& term : lagrangian.potential) sum += term.value;
  return written_out(lagrangian.definitions, sum) / lagrangian.symbols.parameters[1];
}

}  // namespace

TEST_CASE("every operation and function is translated") {
  Lagrangian l;
  const auto value = [&](const std::string& text) { return translate_potential(text, l); };
  const auto x = [&] { return l.symbols.q[0]; };
  const auto k = [&] { return l.symbols.parameters[0]; };
  CHECK(value("-x^2*k/3").is_equal(-pow(x(), 2) * k() / 3));
  CHECK(value("x^(1/2) - 0.1").is_equal(sqrt(x()) - GiNaC::numeric(1, 10)));
  CHECK(value("sin(x) + cos(x) + tan(x)").is_equal(sin(x()) + cos(x()) + tan(x())));
  CHECK(value("asin(x)*acos(x)*atan(x)").is_equal(asin(x()) * acos(x()) * atan(x())));
  CHECK(value("atan2(x, k)").is_equal(atan2(x(), k())));
  CHECK(value("sinh(x) + cosh(x) + tanh(x)").is_equal(sinh(x()) + cosh(x()) + tanh(x())));
  CHECK(value("exp(x)*log(k)").is_equal(exp(x()) * log(k())));
  CHECK(value("pi*x").is_equal(GiNaC::Pi * x()));
}

TEST_CASE("a long sum becomes a tree of small definitions with the same value") {
  std::string text = "sin(x)";
  for (int i = 2; i < 200; ++i) text += " + sin(" + std::to_string(i) + "*x)/k";
  Lagrangian l;
  const ex whole = translate_potential("(" + text + ")^2", l);
  ex sum = sin(l.symbols.q[0]);
  for (int i = 2; i < 200; ++i) sum += sin(i * l.symbols.q[0]) / l.symbols.parameters[0];
  CHECK(vanishes(whole - sum * sum, {l.symbols.q[0], l.symbols.parameters[0]}));
  for (const Definition& definition : l.definitions.list) {
    CHECK(symbols_of(l.definitions, definition.value).size() <= 10);
  }
}

TEST_CASE("nested functions become separate definitions") {
  std::string text = "x";
  for (int i = 0; i < 60; ++i) text = "sin(" + text + ")";
  Lagrangian l;
  CHECK_FALSE(translate_potential(text, l).is_zero());
  CHECK(l.definitions.list.size() >= 5);
}

namespace {

/// The printable names of definitions, in order.
std::vector<std::string> names_in(const Lagrangian& lagrangian) {
  std::vector<std::string> names;
  for (const Definition& definition : lagrangian.definitions.list) {
    if (!definition.name.empty()) names.push_back(definition.name);
  }
  return names;
}

std::vector<std::string> names_in(const std::string& text) {
  const auto result = formulate(checked_model(model_text("ordered", text)).model);
  REQUIRE(result);
  return names_in(*result);
}

}  // namespace

TEST_CASE("definitions, prescribed functions and points come after their operands") {
  CHECK(names_in(R"toml(
[[coordinate]]
name = "x"
[parameters]
m = 1
[define]
late = "early*x(tip)"
early = "2*phi"
[[prescribed]]
name = "phi"
value = "m*t^2"
[[point]]
name = "tip"
at = ["x(base) + early", "x"]
[[point]]
name = "base"
at = ["2*x", "0"]
mass = "m"
)toml") == std::vector<std::string>{"phi", "early", "base_x", "tip_x", "late"});
}

TEST_CASE("frames come after their parents and before their contents", "[frames]") {
  CHECK(names_in(R"toml(
[[coordinate]]
name = "q"
[parameters]
m = 1
[define]
angle = "2*q"
height = "x(tip)"
[[point]]
name = "tip"
frame = "lower"
at = ["m", "0", "0"]
mass = "m"
[[frame]]
name = "lower"
parent = "upper"
rotate = [["z", "angle"]]
[[frame]]
name = "upper"
parent = "world"
translate = ["2*m", "0", "m"]
)toml") == std::vector<std::string>{"angle", "upper_x", "lower_R11", "tip_x"});
}

namespace {

/// A model with a point of a rotating frame; `more` has keys of the point and other entries.
std::string arm(const std::string& more) {
  return R"toml(
[[coordinate]]
name = "q"
[parameters]
m = 1
[[frame]]
name = "arm"
parent = "world"
rotate = [["z", "2*q"]]
[[point]]
name = "tip"
frame = "arm"
at = ["m", "0", "0"]
)toml" + more;
}

}  // namespace

TEST_CASE("rotation entries used by a force have printable names", "[frames]") {
  const auto is_named = [](const std::vector<std::string>& names, const std::string& name) {
    return std::count(names.begin(), names.end(), name) > 0;
  };
  CHECK_FALSE(is_named(names_in(arm("mass = \"m\"\n")), "arm_R11"));
  const std::vector<std::string> names = names_in(
      arm("mass = \"m\"\n[[force]]\nat = \"tip\"\nin = \"arm\"\nvalue = [\"0\", \"m\", \"0\"]\n"));
  CHECK(is_named(names, "arm_R11"));
  CHECK(is_named(names, "arm_R21"));
}

TEST_CASE("a point of a frame is defined only if something refers to it", "[frames]") {
  const auto tips = [&](const std::string& rest) {
    const std::vector<std::string> names = names_in(arm(rest));
    return std::count_if(names.begin(), names.end(), [](const std::string& name) {
      return name.starts_with("tip") && !name.ends_with("_dot");
    });
  };
  const std::string bob = "[[body]]\nname = \"bob\"\nmass = \"m\"\n";
  CHECK(tips(bob + "com = [\"q\", \"0\", \"0\"]\n") == 0);
  CHECK(tips(bob + "com = [\"x(tip)\", \"0\", \"0\"]\n") == 1);
  CHECK(tips(bob + "com = [\"q\", \"0\", \"0\"]\ninertia = [\"m\", \"m\", \"m\"]\n"
                   "spin = [\"0\", \"0\", \"dot(y(tip))\"]\n") == 1);
  const std::string hung = "[[frame]]\nname = \"hung\"\nparent = \"world\"\n";
  CHECK(tips(hung + "translate = [\"x(tip)\", \"0\", \"0\"]\n" + bob +
             "frame = \"hung\"\ncom = [\"0\", \"0\", \"m\"]\n") == 1);
  CHECK(tips(hung + "rotate = [[\"x\", \"x(tip)/m\"]]\n" + bob +
             "frame = \"hung\"\ncom = [\"0\", \"0\", \"m\"]\n") == 1);
}

TEST_CASE("shared subexpressions are translated once") {
  // If expanded to a tree, the rotation about fourteen oblique axes would have 9^14 nodes.
  std::string axes;
  for (int i = 0; i < 14; ++i) axes += R"toml([["1", "2", "2"], "q"], )toml";
  const Model model = checked_model(model_text("slanted", R"toml(
[[coordinate]]
name = "q"
[parameters]
m = 1
[[frame]]
name = "arm"
parent = "world"
rotate = [)toml" + axes + R"toml(]
[[body]]
name = "bob"
frame = "arm"
mass = "m"
com = ["1", "2", "3"]
[[output]]
name = "pose"
frame = "arm"
)toml"))
                          .model;
  CHECK(formulate(model));
}

TEST_CASE("a long chain declared backwards is ordered without recursion") {
  std::string text =
      "[[coordinate]]\nname = \"x\"\n[parameters]\nk = 1\n[energy]\nT = \"k*dot(x)^2\"\n[define]\n";
  for (int i = 4000; i > 0; --i) {
    text += "d" + std::to_string(i) + " = \"d" + std::to_string(i - 1) + " + 1\"\n";
  }
  text += "d0 = \"2*x\"\n";
  const std::vector<std::string> names = names_in(text);
  REQUIRE(names.size() == 4001);
  CHECK(names.front() == "d0");
  CHECK(names.back() == "d4000");
}

TEST_CASE("derivatives of open functions up to order two are leaves") {
  const ex x = GiNaC::realsymbol("x");
  const ex y = GiNaC::realsymbol("y");
  const auto by = [](const ex& value, const ex& symbol) {
    return value.diff(GiNaC::ex_to<GiNaC::symbol>(symbol));
  };
  const ex open = elgen_open(3, 2, 0, x, y, 0, 0);  // leaf 3 is the value, 4 to 8 are derivatives
  CHECK(open_value_number(open) == 3U);
  CHECK(open_value_number(by(open, x)) == 4U);
  CHECK(open_value_number(by(open, y)) == 5U);
  CHECK(open_value_number(by(by(open, y), x)) == 7U);
  CHECK(open_value_number(by(by(open, y), y)) == 8U);
  CHECK_FALSE(open_value_number(by(by(by(open, x), y), x)).has_value());
  const ex chained = elgen_open(0, 1, 0, x * x, 0, 0, 0);
  CHECK((by(chained, x) - 2 * x * elgen_open(0, 1, 1, x * x, 0, 0, 0)).is_zero());
}
