// Derivatives of a step are polynomials in A for x' = A x + b u, and symplectic matrices for
// symplectic methods. Rotations are differentiated along rotation vectors. Every self-check
// compares the derivatives with differences of the oracle's steps in 205 digits.
#include <catch2/catch.hpp>

#include "numbers/exact_number.hpp"
#include "pipeline/constrained_testing.hpp"

namespace elgen::test {
namespace {

using cln::cl_R;

std::string stepping(const std::string& method) {
  return "[outputs]\nstep_derivatives = { method = " + method + " }\n";
}

Products checked_products(const std::string& model, const std::string& scene) {
  return run_pipeline(inputs_of(model, scene), {.goals = {Goal::choose, Goal::self_check}});
}

/// The derivatives of the step at `state` in 64 digits: the field A, then the field B.
ExactNumbers values_at(const Products& products, const State& state) {
  const Program& program = *products.program;
  const Function& function = program.functions.front();
  return to_oracle_values(evaluate(program, function, arguments_at<Real>(state))).value();
}

State start_of(const Products& products) {
  return nominal_state(products.checked->model, products.checked->scene);
}

constexpr const char* oscillator = R"toml(format = 1
[model]
name = "oscillator"
[[coordinate]]
name = "x"
unit = "m"
[parameters]
m = { value = 2, unit = "kg" }
k = { value = 3, unit = "N/m" }
d = { value = "1/2", unit = "N*s/m" }
[energy]
T = "1/2*m*dot(x)^2"
V = "1/2*k*x^2"
D = "1/2*d*dot(x)^2"
[[input]]
name = "f"
unit = "N"
on = "x"
)toml";

/// Twelve equal masses on springs, x1 to x12, the first on a spring to a wall.
std::string masses_text() {
  std::string coordinates;
  std::string kinetic = "0";
  std::string potential = "1/2*k*x1^2";
  for (int i = 1; i <= 12; ++i) {
    const std::string x = "x" + std::to_string(i);
    coordinates += "[[coordinate]]\nname = \"" + x + "\"\nunit = \"m\"\n";
    kinetic += " + 1/2*m*dot(" + x + ")^2";
    if (i > 1) potential += " + 1/2*k*(" + x + " - x" + std::to_string(i - 1) + ")^2";
  }
  return "format = 1\n[model]\nname = \"masses\"\n" + coordinates +
         "[parameters]\nm = { value = 2, unit = \"kg\" }\nk = { value = 3, unit = \"N/m\" }\n"
         "[energy]\nT = \"" +
         kinetic.substr(4) + "\"\nV = \"" + potential + "\"\n";
}

/// free_body.toml with an arm of five links: eleven velocities, three of them of a rotation.
std::string floating_arm_text() {
  std::string text = model_file("free_body");
  text.resize(text.find("[[expect]]"));
  std::string parent = "body";
  for (int i = 1; i <= 5; ++i) {
    const std::string number = std::to_string(i);
    text += "[[coordinate]]\nname = \"j" + number + "\"\nunit = \"rad\"\n[[frame]]\nname = \"link" +
            number + "\"\nparent = \"" + parent +
            "\"\ntranslate = [\"sqrt(A/m)\", \"0\", \"0\"]\nrotate = [[\"" +
            (i % 2 == 0 ? "y" : "z") + "\", \"j" + number + "\"]]\n[[body]]\nname = \"load" +
            number + "\"\nframe = \"link" + number +
            "\"\nmass = \"m\"\ninertia = [\"A\", \"B\", \"C\"]\n";
    parent = "link" + number;
  }
  return text;
}

}  // namespace

TEST_CASE("the derivatives of a linear system's step are a polynomial of its matrix") {
  const Products products = checked_products(oscillator, stepping("\"rk4\""));
  INFO(format(products.diagnostics));
  REQUIRE(products.self_check);
  State state = start_of(products);
  state.q = {1};
  state.v = {2};
  state.u = {3};
  state.h = cln::cl_RA(1) / 10;
  // A = [0 1; -k/m -d/m], b = [0; 1/m]: d/dx = sum_0^4 (hA)^k/k!, d/du = sum_1^4 h^k A^(k-1) b/k!
  const cln::cl_RA c = cln::cl_RA(-3) / 2;
  const cln::cl_RA e = cln::cl_RA(-1) / 4;
  std::array<cln::cl_RA, 4> power{1, 0, 0, 1};
  std::array<cln::cl_RA, 4> sum = power;
  std::array<cln::cl_RA, 2> of_input{0, 0};
  cln::cl_RA factor = 1;
  for (int order = 1; order <= 4; ++order) {
    factor = factor / (10 * order);
    of_input[0] = of_input[0] + factor * power[1] / 2;
    of_input[1] = of_input[1] + factor * power[3] / 2;
    power = {power[1] * c, power[0] + power[1] * e, power[3] * c, power[2] + power[3] * e};
    for (std::size_t i = 0; i < 4; ++i) sum[i] = sum[i] + factor * power[i];
  }
  check_digits(values_at(products, state),
               {sum[0], sum[1], sum[2], sum[3], of_input[0], of_input[1]}, 60);
}

TEST_CASE("steps of symplectic methods have symplectic derivatives") {
  for (const char* const method : {"\"verlet\"", "\"verlet\", order = 4"}) {
    const Products pendulum = checked_products(model_file("simple_pendulum"), stepping(method));
    INFO(format(pendulum.diagnostics));
    REQUIRE(pendulum.self_check);
    State state = start_of(pendulum);
    state.q = {cln::cl_RA(7) / 5};
    state.v = {cln::cl_RA(2) / 3};
    state.h = cln::cl_RA(1) / 10;
    const ExactNumbers a = values_at(pendulum, state);
    check_digits({a[0] * a[3] - a[1] * a[2]}, {1}, 55);
  }
}

TEST_CASE("a spinning body rotates deviations along with it") {
  const Products products = checked_products(model_file("free_body"), stepping("\"rk4\""));
  INFO(format(products.diagnostics));
  REQUIRE(products.self_check);
  State state = start_of(products);
  const Model& model = products.checked->model;
  REQUIRE(model.rotations.size() == 1);
  const std::size_t first = model.rotations[0].first_velocity;
  state.v[first + 2] = 3;
  state.h = cln::cl_RA(1) / 100;
  const ExactNumbers a = values_at(products, state);
  const std::size_t columns = 2 * model.velocities.size();
  const auto entry = [&](std::size_t i, std::size_t j) {
    return double_of(a[(first + i) * columns + first + j]);
  };
  // exp(-[w]x h), up to the order of the method.
  CHECK(entry(0, 0) == Approx(std::cos(0.03)).margin(1e-9));
  CHECK(entry(0, 1) == Approx(std::sin(0.03)).margin(1e-9));
  CHECK(entry(1, 0) == Approx(-std::sin(0.03)).margin(1e-9));
  CHECK(entry(2, 2) == Approx(1).margin(1e-15));
}

TEST_CASE("derivatives of steps agree with differences of the oracle's steps") {
  for (const auto& [name, method] :
       {std::pair("double_pendulum", "\"midpoint\", iterations = 3"),
        std::pair("cart_pole", "\"rk4\""), std::pair("quadrotor", "\"rk4\""),
        std::pair("pendulum_in_lift", "\"rk4\""), std::pair("two_link_arm", "\"rk4\""),
        // The programs of the next three steps contain negations.
        std::pair("simple_pendulum", "\"midpoint\""), std::pair("elastic_pendulum", "\"midpoint\""),
        std::pair("chain", "\"midpoint\", order = 4, iterations = 2")}) {
    INFO(name);
    const Products products = checked_products(model_file(name), stepping(method));
    INFO(format(products.diagnostics));
    CHECK(products.self_check);
    CHECK(find_invariant_violation(*products.program) == "");
  }
}

TEST_CASE("derivatives of more than ten velocities are polynomials of a linear system's matrix") {
  const Products products =
      derived(inputs_of(masses_text(), stepping("\"rk4\"")), {.goals = {Goal::choose}});
  State state = start_of(products);
  state.h = cln::cl_RA(1) / 10;
  // d/dx = sum_0^4 (hA)^k/k!, A = [0 1; -K/m 0], K: 2 k on the diagonal (k at the free end), -k
  // beside
  constexpr std::size_t n = 12;
  using Matrix = std::vector<std::vector<cln::cl_RA>>;
  Matrix a(2 * n, std::vector<cln::cl_RA>(2 * n, 0));
  const cln::cl_RA stiffness = cln::cl_RA(3) / 2;
  for (std::size_t i = 0; i < n; ++i) {
    a[i][n + i] = 1;
    a[n + i][i] = i + 1 < n ? -2 * stiffness : -stiffness;
    if (i > 0) a[n + i][i - 1] = a[n + i - 1][i] = stiffness;
  }
  Matrix sum(2 * n, std::vector<cln::cl_RA>(2 * n, 0));
  for (std::size_t i = 0; i < 2 * n; ++i) sum[i][i] = 1;
  Matrix term = sum;
  for (int order = 1; order <= 4; ++order) {
    Matrix next(2 * n, std::vector<cln::cl_RA>(2 * n, 0));
    for (std::size_t i = 0; i < 4 * n * n; ++i) {
      cln::cl_RA& entry = next[i / (2 * n)][i % (2 * n)];
      for (std::size_t l = 0; l < 2 * n; ++l) {
        entry = entry + term[i / (2 * n)][l] * a[l][i % (2 * n)] / (10 * order);
      }
      sum[i / (2 * n)][i % (2 * n)] = sum[i / (2 * n)][i % (2 * n)] + entry;
    }
    term = std::move(next);
  }
  ExactNumbers expected;
  for (const std::vector<cln::cl_RA>& row : sum)
    expected.insert(expected.end(), row.begin(), row.end());
  check_digits(values_at(products, state), expected, 60);
}

TEST_CASE("derivatives of more than ten velocities agree with the oracle's steps") {
  const Products masses = checked_products(masses_text(), stepping("\"verlet\""));
  INFO(format(masses.diagnostics));
  CHECK(masses.self_check);
  for (const std::string& text : {model_file("chain"), floating_arm_text()}) {
    const bool is_chain = text == model_file("chain");
    const Products products =
        checked_products(text, stepping("\"rk4\"") + (is_chain ? "[sizes]\nn = 11\n" : ""));
    INFO(format(products.diagnostics));
    REQUIRE(products.self_check);
    CHECK(find_invariant_violation(*products.program) == "");
    CHECK(products.program->functions.front().repeated.count >= 16);
  }
}

TEST_CASE("derivatives of steps cost a small multiple of the linearization") {
  const std::string scene = stepping("\"rk4\"") + "linearization = true\n[sizes]\nn = 16\n";
  const Products products =
      derived(inputs_of(model_file("chain"), scene), {.goals = {Goal::choose}});
  std::vector<std::size_t> counts;
  for (const Function& function : products.program->functions)
    counts.push_back(operations(function));
  REQUIRE(counts.size() == 2);
  CHECK(std::max(counts[0], counts[1]) < 10 * std::min(counts[0], counts[1]));
}

TEST_CASE("derivatives of steps that do not exist are refused") {
  using Catch::Contains;
  const auto message = [](const std::string& name, const std::string& scene) {
    return format(checked_products(model_file(name), scene).diagnostics);
  };
  CHECK_THAT(message("pendulum_xy", stepping("\"rk4\"")),
             Contains("E539") && Contains("`step_derivatives` does not support constraints"));
  CHECK_THAT(message("chain", stepping("\"rk4\"") + "[sizes]\nn = 41\n"),
             Contains("E603") && Contains("supports at most 40 velocities, but the model has 41"));
  CHECK_THAT(message("chain", stepping("\"midpoint\"") + "[sizes]\nn = 11\n"),
             Contains("E622") &&
                 Contains("derivatives of its steps support at most 10 velocities, not 11"));
  CHECK_THAT(message("cart_pole", "[outputs]\nstep_derivatives = true\n"),
             Contains("E105") && Contains("`step_derivatives` needs a `method`"));
  CHECK_THAT(message("cart_pole", stepping("\"euler\"")),
             Contains("E620") && Contains("`step_derivatives` has no method `euler`"));
}

}  // namespace elgen::test
