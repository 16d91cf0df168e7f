// Tests quotients that are 0/0 if a coordinate is 0. Quotients and outputs have values at 0. Pages
// print quotients as typed.
#include <cmath>

#include "elgen/oracle.hpp"
#include "elgen/page.hpp"
#include "pipeline/pipeline_testing.hpp"

namespace elgen::test {
namespace {

constexpr double nothing = 1e300;

/// A potential and its value at q = 0, r = 1/2.
struct QuotientRow {
  std::string potential;
  double at_zero;
};

const std::string with_potential = R"toml(format = 1
[model]
name = "arm"
[[coordinate]]
name = "q"
[[coordinate]]
name = "r"
[parameters]
L = 0.25
[define]
a = "L*q"
s = "sin(a)"
c = "cos(a)"
b = "sqrt(q^2 + (r - 1/2)^2)"
R = "L/q"
[energy]
T = "1/2*dot(q)^2 + 1/2*dot(r)^2"
V = ")toml";

CheckedModel checked_arm(const std::string& potential) {
  Products products = products_with(
      &Products::checked, inputs_of(with_potential + potential + "\"\n"), {.goals = {Goal::check}});
  return std::move(*products.checked);
}

std::optional<double> potential_at(const Model& model, const cln::cl_RA& q) {
  State state = nominal_state(model, {});
  state.q = {q, cln::cl_RA(1) / 2};
  const auto value = oracle_expression_value(model, *model.energies.V, state);
  return value ? std::optional(cln::double_approx(*value)) : std::nullopt;
}

Model as_typed(Model model) {
  for (const auto& [id, quotient] : model.original_expressions) model.expressions[id] = quotient;
  model.original_expressions.clear();
  return model;
}

const std::string soft = R"toml(format = 1
[model]
name = "soft"
[[coordinate]]
name = "q"
unit = "rad"
range = [-2, 2]
[parameters]
m = { value = 0.1, unit = "kg", assume = "positive" }
L = { value = 0.3, unit = "m", assume = "positive" }
g = { value = 9.81, unit = "m/s^2" }
[gravity]
vector = ["0", "-g"]
[[output]]
name = "pose"
value = ["x(tip)", "y(tip)"]
jacobian = true
[[point]]
name = "tip"
mass = "m"
at = )toml";
const std::string by_quotients = R"toml(["L*(1 - cos(q))/q", "-L*sin(q)/q"])toml";
const std::string by_functions = R"toml(["L*q*cosc(q)", "-L*sinc(q)"])toml";

std::string steps_of(const std::string& at) {
  const Products products =
      products_with(&Products::steps, inputs_of(soft + at + "\n"), {.goals = {Goal::steps}});
  return text_of(
      derivation_page(products.checked->model, products.checked->scene, *products.steps));
}

}  // namespace

TEST_CASE("quotients of sines and cosines have values at 0 and do not change elsewhere") {
  for (const auto& [potential, at_zero] :
       std::vector<QuotientRow>{{"sin(q)/q", 1},
                                {"L*sin(2*q)/q", 0.5},
                                {"1/q*L*sin(q)*r", 0.125},
                                {"sin(L*q)/(L*q)", 1},
                                {"sin(-q)/q", -1},
                                {"-L/q*sin(q)", -0.25},
                                {"sin(q*r)/q", 0.5},
                                {"sin(q*r)/(q*r)", 1},
                                {"sin(q/2)/(q/2)", 1},
                                {"sin(q)*q^(-1)", 1},
                                {"(sin(q)/q)^2", 1},
                                {"sin(q)^2/q^2", 1},
                                {"sin(q)^2/q", 0},
                                {"(1 - cos(q))/q", 0},
                                {"(1 - cos(2*q))/q^2", 2},
                                {"(cos(q) - 1)/q^2", -0.5},
                                {"(1 - cos(-q))/(3*q)", 0},
                                {"(-cos(L*q) + 1)/(L*q)/q", 0.125},
                                {"sin(q)*(1 - cos(q))/q^3", 0.5},
                                {"r*s/q", 0.125},
                                {"s/a", 1},
                                {"(1 - c)/a^2", 0.5},
                                {"(1 - c)/q", 0},
                                {"2 + r*(1 - cos(q))/q^2", 2.25},
                                {"L/q - L*cos(q)/q", 0},
                                {"r + R - R*cos(q)", 0.5},
                                {"R*cos(q) - R + r*(R - R*cos(a))/q", 0.00390625},
                                {"(2 - 2*cos(q))/q^2", 1},
                                {"(L - L*cos(q))/q", 0},
                                {"(q/sin(q))^(-1)", 1}}) {
    INFO(potential);
    const Model model = checked_arm(potential).model;
    REQUIRE_FALSE(model.original_expressions.empty());
    const Model typed = as_typed(model);
    CHECK_FALSE(potential_at(typed, 0));
    CHECK(potential_at(model, 0).value_or(nothing) == Approx(at_zero).margin(1e-15));
    for (const cln::cl_RA& q : {cln::cl_RA(-7) / 5, cln::cl_RA(3) / 10}) {
      const auto right = potential_at(typed, q);
      REQUIRE(right);
      // Both values have 60 correct digits before they are rounded to double.
      CHECK(potential_at(model, q).value_or(nothing) == Approx(*right).epsilon(1e-15).margin(0));
    }
    const std::string text = to_string(model, *model.energies.V);
    CHECK(text == to_string(typed, *model.energies.V));
    CHECK_FALSE(mentions(text, "sinc"));
  }
}

TEST_CASE("quotients that stay 0/0, have poles or different arguments are not changed") {
  for (const std::string potential :
       {"sin(q)/q^2", "cos(q)/q", "(1 + cos(q))/q", "(2 - cos(q))/q", "sin(r)/q", "sin(q + r)/q",
        "sin(b)/b", "sin(L)/L", "(1 - cos(q))/q^3", "q/sin(q)", "tan(q)/q", "sin(q^2)/q",
        "sin(q)/(1 + q)", "L*sin(q)", "L/q - L*cos(r)/q", "R + R*cos(q)", "R - 2*R*cos(q)",
        "1/q^3 - cos(q)/q^3", "r - r*cos(q)"}) {
    INFO(potential);
    CHECK(checked_arm(potential).model.original_expressions.empty());
  }
}

TEST_CASE("a soft arm typed with quotients moves through q = 0") {
  const Products products = derived(inputs_of(soft + by_quotients + "\n"), PipelineOptions{});
  const Model& model = products.checked->model;
  const State straight = start_state(model, products.checked->scene);
  const auto mass = oracle_values(model, {.kind = OutputKind::mass_matrix}, straight);
  REQUIRE(mass);
  CHECK(cln::double_approx(mass->front()) == Approx(0.1 * 0.09 / 4).epsilon(1e-15));
  for (const Function& function : products.program->functions) {
    CHECK(function.sampled_zeros.empty());
  }
}

TEST_CASE("pages print quotients if quotients are typed, and functions if functions are typed") {
  const std::string typed = steps_of(by_quotients);
  CHECK(mentions(typed, "tip = (L*(1 - cos(q))/q, -L/q*sin(q))"));
  CHECK_FALSE(mentions(typed, "stumpff"));
  const std::string named = steps_of(by_functions);
  CHECK(mentions(named, "tip = (L*q*cosc(q), -L*sinc(q))"));
  // The [[output]] names a function, so the page prints functions: stumpff(q, 3) is no quotient.
  const std::string in_output = "\n[[output]]\nname = \"s\"\nvalue = \"stumpff(q, 3)\"";
  const std::string mixed = steps_of(by_quotients + in_output);
  CHECK(mentions(mixed, "tip = (L*q*cosc(q), -L*sinc(q))"));
}

}  // namespace elgen::test
