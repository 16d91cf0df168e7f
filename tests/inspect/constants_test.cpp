// Constants without a value, and the root expressions of the equations.
#include <algorithm>
#include <catch2/catch.hpp>

#include "elgen/references.hpp"
#include "inspect/checks.hpp"
#include "inspect/found.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string constant_findings(const std::string& definitions, const std::string& potential,
                              const SceneOptions& options = {}) {
  const CheckedModel checked = checked_model(
      "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\n[parameters]\nk = 3\n"
      "[define]\n" +
          definitions + "[energy]\nT = \"dot(x)^2\"\nV = \"" + potential + "\"\n",
      options);
  return text_of(inspect_constants({checked.model, checked.scene}));
}

/// The definitions c0 = `first`, c1, ..., c`count`. The value of each definition after c0 is
/// `next`, with the previous name in place of `c`.
std::string chain(const std::string& first, const std::string& next, int count) {
  std::string text = "c0 = \"" + first + "\"\n";
  for (int i = 1; i <= count; ++i) {
    std::string value = next;
    for (std::size_t at = 0; (at = value.find('c', at)) != std::string::npos; ++at) {
      if (at + 1 < value.size() && std::isalpha(value[at + 1]) != 0) continue;
      value.insert(at + 1, std::to_string(i - 1));
    }
    text += "c" + std::to_string(i) + " = \"" + value + "\"\n";
  }
  return text;
}

std::string texts(const Model& model, const std::vector<ExpressionId>& ids) {
  std::string text;
  for (const ExpressionId id : ids) text += (text.empty() ? "" : ", ") + to_string(model, id);
  return text;
}

}  // namespace

TEST_CASE("a constant is evaluated through the names it contains") {
  CHECK(constant_findings("c = \"1\"\n", "asin(c)*x").empty());
  CHECK(constant_findings("c = \"2\"\n", "asin(c)*x") == "E314: `asin(c)` is not a real number");
  CHECK(constant_findings("c = \"-1\"\n", "x*c^(1/2)") == "E314: `c^(1/2)` is not a real number");
  CHECK(constant_findings("c = \"0\"\n", "x/c") == "E312: `c` is zero");
  CHECK(constant_findings("c = \"0\"\n", "x*c^-2") == "E312: `c` is zero");
  CHECK(constant_findings("c = \"0\"\n", "x*log(c)") == "E313: `log(c)` has no value");
  CHECK(constant_findings("c = \"2\"\nd = \"c\"\ne = \"d - 2\"\n", "x/e") == "E312: `e` is zero");
  CHECK(constant_findings("c = \"2\"\n", "x/dot(c)") == "E312: `dot(c)` is zero");
}

TEST_CASE("only the first subexpression without a value is reported") {
  CHECK(constant_findings("c = \"2\"\nd = \"asin(c)\"\ne = \"1/d\"\n", "x*log(e)") ==
        "E314: `asin(c)` is not a real number");
}

TEST_CASE("an exact zero is found despite rounding, and a small value is not zero") {
  CHECK(constant_findings("c = \"pi/2\"\n", "x*tan(c)") == "E313: `tan(c)` has no value");
  CHECK(constant_findings("c = \"sqrt(2)\"\nd = \"c*c\"\n", "x/(d - 2)") ==
        "E312: `(d - 2)` is zero");
  CHECK(constant_findings("c = \"1e30*pi\"\n", "x/sin(c)") == "E312: `sin(c)` is zero");
  CHECK(constant_findings("c = \"pi + 1e-60\"\n", "x/sin(c)").empty());
  CHECK(constant_findings("c = \"exp(-300)\"\n", "x/c").empty());
}

TEST_CASE("a value without correct digits proves nothing") {
  CHECK(constant_findings(chain("1", "10*sin(100*c)", 400), "x/c400 + x*log(c400) + x*asin(c400)")
            .empty());
  CHECK(constant_findings("c = \"exp(800)\"\nd = \"pi*c\"\n", "x*log(sin(d))").empty());
}

TEST_CASE("values of fixed parameters are used, values of other parameters are not") {
  CHECK(constant_findings("", "x/(k - 3)").empty());
  SceneOptions options;
  options.fixed = {make_source("command line", "k=3")};
  CHECK(constant_findings("", "x/(k - 3)", options) == "E312: `(k - 3)` is zero");
  CHECK(constant_findings("d = \"k - 4\"\n", "x*sqrt(d)", options) ==
        "E314: `sqrt(d)` is not a real number");
}

TEST_CASE("the hint lists the values of the names in a subexpression") {
  const CheckedModel checked = checked_model(
      "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\n[define]\na = \"1/3\"\n"
      "b = \"sqrt(2)\"\n[energy]\nT = \"dot(x)^2\"\nV = \"log(a - b - 2*a)*x\"\n");
  const Diagnostics all = inspect_constants({checked.model, checked.scene});
  REQUIRE(all.size() == 1);
  CHECK(all[0].hint == "`a` is 1/3, `b` is 1.4142");
}

TEST_CASE("the size of a product is checked before it is expanded") {
  CHECK(constant_findings(chain("x", "c*c", 13), "c13").empty());
  CHECK(constant_findings(chain("x", "c*c", 64), "c64") ==
        "E910: `c13*c13` has powers beyond 10000");
  CHECK(constant_findings(chain("x + 1", "c^64", 9), "c9") ==
        "E910: `c2^64` has powers beyond 10000");
  CHECK(mentions(constant_findings(chain("1/x", "c/(1/c)", 64), "c64"), "has powers beyond 10000"));
  CHECK(constant_findings(chain("2", "c*c", 64), "x*c64") ==
        "E910: `c13*c13` has more than 4096 digits");
  CHECK(constant_findings(chain("1000*x", "c*c", 64), "c64") ==
        "E910: `c10*c10` has numbers of more than 4096 digits");
  CHECK(constant_findings(chain("x", "c + c", 64), "c64").empty());
  CHECK(constant_findings(chain("x", "sin(c*c)", 64), "c64").empty());
}

TEST_CASE("a long chain of names needs no recursion") {
  CHECK(constant_findings(chain("cos(1)", "cos(c)", 5000), "x*c5000").empty());
}

TEST_CASE("energies are equation roots, output values are output roots") {
  const Model model = checked_model(
                          "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\n"
                          "[define]\na = \"2*x\"\nunused = \"3*x\"\n[energy]\nT = \"dot(x)^2\"\n"
                          "V = \"sin(a) + a\"\n[[output]]\nname = \"o\"\nvalue = \"cos(x)\"\n")
                          .model;
  CHECK(texts(model, equation_roots(model)) == "dot(x)^2, sin(a) + a");
  CHECK(texts(model, output_roots(model, 0)) == "cos(x)");
}

TEST_CASE("a root names its entry and its role in the entry") {
  const Model model = checked_model(
                          "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\n"
                          "[[coordinate]]\nname = \"y\"\narmature = \"J\"\n[parameters]\n"
                          "J = 1\nm = 2\nk = 3\n[define]\nlength = \"2*x\"\n[[point]]\n"
                          "name = \"p\"\nat = [\"x\", \"y\"]\nmass = \"m\"\n[energy]\n"
                          "V = \"k*length^2\"\n[[force]]\non = \"y\"\nvalue = \"cos(x)\"\n"
                          "[[output]]\nname = \"o\"\nvalue = \"sin(x)\"\n")
                          .model;
  const auto texts_of = [&model](RootRole role) {
    return texts(model,
                 filter_roots(model, [role](const Root& root) { return root.role == role; }));
  };
  CHECK(texts_of(RootRole::armature) == "J");
  CHECK(texts_of(RootRole::mass) == "m");
  CHECK(texts_of(RootRole::potential) == "k*length^2");
  CHECK(texts_of(RootRole::kinetic).empty());
  CHECK(texts_of(RootRole::value) == "cos(x), sin(x), 2*x");
  CHECK(texts(model, filter_roots(model, is_force_value)) == "cos(x)");
  const std::vector<Root> roots = roots_of(model);
  const auto armature = std::ranges::find(roots, RootRole::armature, &Root::role);
  REQUIRE(armature != roots.end());
  CHECK(armature->entity.kind == EntityKind::coordinate);
  CHECK(armature->entity.index == 1);
  const auto mass = std::ranges::find(roots, RootRole::mass, &Root::role);
  REQUIRE(mass != roots.end());
  CHECK(mass->entity.kind == EntityKind::point);
  CHECK(mass->expression == *model.points[0].mass);
}

TEST_CASE("all energies and forces are roots", "[frames]") {
  std::size_t masses = 0;
  for (const auto& [name, text] : frame_systems()) {
    INFO(name);
    const Model model = checked_model(text).model;
    const auto all = reachable_expressions(model, equation_roots(model));
    for (const Body& body : model.bodies) {
      if (!body.mass) continue;
      ++masses;
      CHECK(std::find(all.begin(), all.end(), *body.mass) != all.end());
    }
    auto sorted = all;
    std::sort(sorted.begin(), sorted.end());
    CHECK(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());
  }
  CHECK(masses >= frame_systems().size());
}
