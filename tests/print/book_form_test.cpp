// The book form of a model keeps typed sums, definitions of parameters, and irrational numbers.
#include <algorithm>
#include <catch2/catch.hpp>

#include "elgen/pipeline.hpp"
#include "print/small_page.hpp"
#include "program/evaluate/subject.hpp"
#include "support/inputs.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

struct Typed {
  std::string energies;
  std::string definitions = {};
  SceneOptions scene = {};
};

/// The text of the derivation of a mass on a line.
std::string derivation(const Typed& typed) {
  const std::string text = model_text("typed", R"toml(
[[coordinate]]
name = "x"
[parameters]
m = { value = 1, unit = "kg", assume = "positive" }
k = { value = 3, unit = "N/m" }
a = { value = 2, unit = "N" }
b = { value = 1, unit = "J" }
l = { value = 1, unit = "m" }
c = { value = 1 }
[define]
)toml" + typed.definitions + "\n[energy]\n" + typed.energies);
  const Products products =
      products_with(&Products::steps, {make_source("typed.toml", text), nullptr},
                    {.scene = typed.scene, .goals = {Goal::steps}});
  return text_of(derivation_sections(products.checked->model, *products.steps));
}

const std::string kinetic = "T = \"1/2*m*dot(x)^2\"\n";

std::string with_potential(const std::string& potential) {
  return derivation({kinetic + "V = \"" + potential + "\"\n"});
}

/// The page and the derivation of a model with coordinates x and y, parameter p and these energies.
Products irrational(const std::string& T, const std::string& V) {
  const std::string text = model_text("irrational",
                                      "[[coordinate]]\nname = \"x\"\n[[coordinate]]\nname = \"y\"\n"
                                      "[parameters]\np = 1.07812\n[energy]\nT = \"" +
                                          T + "\"\nV = \"" + V + "\"\n");
  return run_pipeline({make_source("irrational.toml", text), nullptr},
                      {.goals = {Goal::typeset, Goal::steps}});
}

/// Compares the derived entries of a function with its readable entries.
void check_meaning(const Program& program, std::size_t function, const Arguments<double>& at) {
  INFO(program.functions[function].name);
  const std::vector<double> derived = evaluate(program, program.functions[function], at);
  const std::vector<double> read = evaluate(program, program.readable[function], at);
  REQUIRE(read.size() == derived.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    CHECK(read[i] ==
          Approx(derived[i]).epsilon(1e-9).margin(1e-9));  // rounding error of sums up to 100
  }
}

}  // namespace

TEST_CASE("each summand of an energy is printed as typed") {
  struct PotentialRow {
    const char* typed;
    const char* energy;
    const char* equation;
  };
  for (const PotentialRow& row : std::initializer_list<PotentialRow>{
           {"1/2*k*(x - l)^2", "V = 1/2*k*(x - l)^2", "m*dot(dot(x)) + k*(x - l) = 0"},
           {"1/2*k*(l - x)^2", "V = 1/2*k*(l - x)^2", "m*dot(dot(x)) - k*(l - x) = 0"},
           {"-(x - l)^2*k", "V = -k*(x - l)^2", "m*dot(dot(x)) - 2*k*(x - l) = 0"},
           {"b*(sin(x) - sin(c))^2", "V = b*(sin(x) - sin(c))^2",
            "m*dot(dot(x)) + 2*b*(sin(x) - sin(c))*cos(x) = 0"},
           {"b*(1 - exp(-x))^2", "V = b*(1 - exp(-x))^2",
            "m*dot(dot(x)) + 2*b*(1 - exp(-x))*exp(-x) = 0"},
           {"1/2*k*x^2 + 1/2*k*(x - l)^2", "V = 1/2*k*x^2 + 1/2*k*(x - l)^2",
            "m*dot(dot(x)) + k*x + k*(x - l) = 0"},
           {"a*sqrt(x^2 + l^2)", "V = a*sqrt(x^2 + l^2)",
            "m*dot(dot(x)) + a*x/sqrt(x^2 + l^2) = 0"},
           {"1/2*k*(sqrt(x^2 + l^2) - l)^2", "V = 1/2*k*(sqrt(x^2 + l^2) - l)^2",
            "m*dot(dot(x)) + k*x - k*l*x/sqrt(x^2 + l^2) = 0"}}) {
    const std::string text = with_potential(row.typed);
    INFO(text);
    CHECK(mentions(text, "  " + std::string(row.energy) + "\n"));
    CHECK(mentions(text, "  " + std::string(row.equation) + "\n"));
  }
}

TEST_CASE("terms that cancel in a typed sum are printed, and have no force") {
  const std::string text = with_potential("a*x + b - a*x");
  CHECK(mentions(text, "  V = a*x + b - a*x\n"));
  CHECK(mentions(text, "  L does not contain x, so p_x"));
  CHECK(mentions(text, "  m*dot(dot(x)) = 0\n"));
}

TEST_CASE("a potential that is 0 as a whole has no force and no rate") {
  const std::string text = with_potential("a*x + k*l*x - (a + k*l)*x");
  CHECK(mentions(text, "  L does not contain x, so p_x"));
  CHECK(mentions(text, "  m*dot(dot(x)) = 0\n"));
  const std::string turned = with_potential("1/2*k*(x*cos(c*t))^2 + 1/2*k*(x*sin(c*t))^2");
  CHECK(mentions(turned, "  L does not contain t, so E is conserved\n"));
}

TEST_CASE("a sum typed in two orders is printed in the first order") {
  const std::string text = with_potential("1/2*k*(x - l)^2 + 1/4*k*(l - x)^2");
  CHECK(mentions(text, "  V = 1/2*k*(x - l)^2 + 1/4*k*(x - l)^2\n"));
}

TEST_CASE("a Lagrangian given as L is printed as L, and a missing V as 0") {
  CHECK(mentions(derivation({"L = \"1/2*m*dot(x)^2 - 1/2*k*(x - l)^2\"\n"}),
                 "  L = 1/2*m*dot(x)^2 - 1/2*k*(x - l)^2\n"));
  const std::string free = derivation({kinetic});
  CHECK(mentions(free, "  V = 0\n"));
  CHECK(mentions(free, "  dot(dot(x)) = 0\n"));
}

TEST_CASE("a rate in V contributes to the momentum") {
  const std::string text = with_potential("c*x*dot(x) + a*x");
  CHECK(mentions(text, "  V = c*x*dot(x) + a*x\n"));
  CHECK(mentions(text, "  dL/d(dot(x)) = m*dot(x) - c*x\n"));
  CHECK(mentions(text, "  m*dot(dot(x)) + a = 0\n"));
}

TEST_CASE("definitions of parameters keep their names, other definitions are substituted") {
  const std::string text = derivation(
      {kinetic + "V = \"1/2*k*e^2 + a*e + 1/2*mu*x^2\"\n", "e = \"x - l\"\nmu = \"k + a/l\"\n"});
  CHECK(mentions(text, "  V = 1/2*k*(x - l)^2 + a*(x - l) + 1/2*mu*x^2\n"));
  CHECK(mentions(text, "  where mu = k + a/l\n"));
  CHECK(mentions(text, "  m*dot(dot(x)) + k*(x - l) + a + mu*x = 0\n"));
  const std::string rates = derivation({"T = \"1/2*m*w^2\"\nV = \"0*x\"\n", "w = \"c*dot(x)\"\n"});
  CHECK(mentions(rates, "  T = 1/2*m*c^2*dot(x)^2\n"));
}

TEST_CASE("a long definition keeps its name") {
  std::string sum = "x^13";
  for (int power = 1; power < 13; ++power) sum += " + c*x^" + std::to_string(power);
  const std::string text = derivation({kinetic + "V = \"a*e^2\"\n", "e = \"" + sum + "\"\n"});
  INFO(text);
  CHECK(mentions(text, "  V = a*e^2\n"));
}

TEST_CASE("a parameter fixed by a scene is a number in the typed sum") {
  SceneOptions scene;
  scene.fixed = {make_source("--fix", "l=1/2")};
  const std::string text = derivation({kinetic + "V = \"1/2*k*(x - l)^2\"\n", "", scene});
  CHECK(mentions(text, "  V = 1/2*k*(x - 1/2)^2\n"));
  CHECK(mentions(text, "  dot(dot(x)) = -k*(x - 1/2)/m\n"));
}

TEST_CASE("sums, products and quotients of irrational numbers keep their value in readable form") {
  const std::string plain = "dot(x)^2 + 1/2*dot(y)^2";
  for (const auto& [T, V] : std::vector<std::pair<std::string, std::string>>{
           {plain, "x + ((exp(1)*x) + ((pi - 1)*x))"},
           {"p*dot(x)^2 + dot(y)^2 + ((2 + sqrt(3))*dot(x) + sin(0.5)*dot(y))^2", "cos(1)*x"},
           {plain + " + ((sqrt(2) - 1 + sin(1)*pi)*dot(x) + 1/(1 + pi)*dot(y))^2",
            "p + 1/(1 + pi)*(cos(pi/8) - y) + x^2"},
           {plain + " + (exp(1)*dot(x) + tan(0.3)*dot(y)/(1 + pi)^2)^2",
            "x^2 + y*(x - (1 + sqrt(2))) + x + (sqrt(2) - 1)"},
           {plain, "x*(pi + exp(1))/(1 + sqrt(2)) + y/(pi*sqrt(2))"},
           {plain, "(sin(cos(sin(1)*pi + exp(1))) + cos(pi/8))*cosh(1)*x"},
           {plain, "sin(x)*(pi + sqrt(2) + sin(0.5)*p)*(1 + exp(1)) - cos(y)*sqrt(3)*exp(1)/pi"},
           {plain, "y + sin(0.5) + (x - (atan(2) - (2 + sqrt(3)))) + 2"},
           {plain, "sqrt(1 + sqrt(2))*x^2 + sin(2)*sin(3)*x*y/(exp(1) - sqrt(7))"}}) {
    INFO("T = " << T << ", V = " << V);
    const Products products = irrational(T, V);
    INFO(format(products.diagnostics));
    REQUIRE(products.page_programs);
    REQUIRE(products.steps);
    CHECK(std::ranges::count(products.diagnostics, Code::E915, &Diagnostic::code) == 0);
    const auto& [model, scene] = *products.checked;
    Arguments<double> at = arguments_at<double>(nominal_state(model, scene));
    at.q = {0.7, -0.4};
    at.v = {1.5, 0.3};
    at.a = {-0.6, 2};
    const Program& page = products.page_programs->program;
    for (const OutputKind kind :
         {OutputKind::mass_matrix, OutputKind::gravity, OutputKind::potential_energy}) {
      const auto function = std::ranges::find(page.functions, kind, &Function::kind);
      REQUIRE(function != page.functions.end());
      check_meaning(page, static_cast<std::size_t>(function - page.functions.begin()), at);
    }
    const Program& derivation = products.steps->program;
    for (std::size_t i = 0; i < derivation.functions.size(); ++i) {
      if (!derivation.readable[i].fields.empty()) check_meaning(derivation, i, at);
    }
  }
}
