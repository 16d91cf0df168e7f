// Correct models that elgen once rejected, and energies with nested calls, nested roots, quotients,
// high powers and unusual angles. Every check of `verify` must hold, whichever form of a function
// is emitted.
#include <catch2/catch.hpp>

#include "pipeline/pipeline_testing.hpp"
#include "support/models.hpp"

namespace elgen::test {
namespace {

Products check_accepted(const std::string& text, const std::string& scene = {}) {
  Products products = products_with(&Products::self_check, inputs_of(text, scene));
  VerifyOptions options;
  options.is_quick = true;
  options.forms = &*products.closed_forms;
  const auto& [model, of_scene] = *products.checked;
  const Certificate certificate =
      verify(model, of_scene, *products.program, {}, options).certificate;
  INFO(to_text(certificate));
  CHECK(holds(certificate));
  return products;
}

std::string energies(const std::string& coordinates, const std::string& T, const std::string& V) {
  return model_text("accepted", coordinates +
                                    "[parameters]\nm = { value = 1, assume = \"positive\" }\n"
                                    "k = 2\n[energy]\nT = \"" +
                                    T + "\"\nV = \"" + V + "\"\n");
}

struct EnergyTexts {
  const char* T;
  const char* V;
};

std::string awkward_model(const EnergyTexts& energies) {
  return std::string(
             "format = 1\n[model]\nname = \"awkward\"\n"
             "[[coordinate]]\nname = \"x\"\nrange = [0.2, 1.5]\n"
             "[[coordinate]]\nname = \"y\"\nrange = [0.3, 1.2]\n"
             "[parameters]\na = { value = 1.3, assume = \"positive\" }\nb = 0.7\nc = 2\n"
             "[energy]\nT = \"") +
         energies.T + "\"\nV = \"" + energies.V + "\"\n";
}

/// A frame that rotates about its fixed origin: on paper the acceleration of the origin is 0. V
/// exceeds every double at large negative times.
constexpr const char* boundless_drive = R"toml(format = 1
[model]
name = "swing"
[[coordinate]]
name = "q"
[parameters]
h = 4
[[prescribed]]
name = "drive"
value = "exp(-t)"
[[frame]]
name = "swing"
parent = "world"
translate = ["h", "h", "0.75"]
rotate = [[["1", "1", "1"], "2*q"]]
[[body]]
name = "stone"
frame = "swing"
mass = 4
com = ["0", "4", "1"]
[energy]
V = "cos(q)*drive"
[[output]]
name = "tip"
frame = "swing"
axes = "swing"
jacobian = true
)toml";

}  // namespace

TEST_CASE("a power of a call has the rounding of every factor") {
  const std::string y = "[[coordinate]]\nname = \"y\"\n";
  const std::string T = "1/2*m*(dot(x)^2 + dot(y)^2)";
  check_accepted(energies("[[coordinate]]\nname = \"x\"\nrange = [0.1, 10]\n" + y, T,
                          "(1 + log(x)^20)*cos(y)"));
  check_accepted(energies("[[coordinate]]\nname = \"x\"\n" + y, T, "(1 + cosh(x)^10)*cos(y)"));
}

TEST_CASE("a proved 0 is right although the oracle's terms leave a rounding error") {
  check_accepted(energies("[[coordinate]]\nname = \"x\"\nrange = [-3, 3]\n", "1/2*m*dot(x)^2",
                          "k*(sqrt(x^2 + 1)^2*exp(x) - x^2*exp(x) - exp(x))"));
}

TEST_CASE("definitions that each use the previous one twice do not explode") {
  std::string text = "[define]\nd1 = \"x*sin(x)\"\n";
  for (int i = 2; i <= 12; ++i) {
    const std::string last = "d" + std::to_string(i - 1);
    text += "d" + std::to_string(i) + " = \"sin(" + last + ")*" + last + "\"\n";
  }
  check_accepted(
      energies("[[coordinate]]\nname = \"x\"\nrange = [-3, 3]\n", "1/2*m*dot(x)^2", "k*d12") +
      text);
}

TEST_CASE("an arm with fixed parameters and an axisymmetric last link has a column of zeros") {
  const Products products =
      check_accepted(model_file("ur5"),
                     "[parameters]\nfixed = \"all\"\n[outputs]\nlinearization = true\n"
                     "inverse_dynamics_derivatives = true\n");
  const Program& program = *products.program;
  const auto function =
      std::ranges::find(program.functions, OutputKind::linearization, &Function::kind);
  REQUIRE(function != program.functions.end());
  for (std::size_t row = 6; row < 12; ++row) {
    const std::uint32_t entry = function->fields[0].entries[12 * row + 5];
    CHECK(loads_zero(program, function->instructions[entry]));
  }
}

TEST_CASE("states with rates above the speed of light are outside the domain and redrawn") {
  check_accepted(model_file("relativistic_particle"), "[parameters]\nfixed = { c = 1 }\n");
  const Products products = check_accepted(model_text("slow_light", R"toml([[coordinate]]
name = "x"
[parameters]
m = { value = 2, assume = "positive" }
c = { value = 1, assume = "positive" }
[energy]
L = "-m*c^2*sqrt(1 - dot(x)^2/c^2)"
)toml"));
  CHECK(products.self_check->states == 32);
  CHECK(products.self_check->undefined_states > 0);
}

TEST_CASE("awkward energies pass every check") {
  const std::vector<EnergyTexts> all{
      {"1/2*(2+sin(sin(x)))*dot(x)^2 + 1/2*a*dot(y)^2", "cos(x*cos(y))"},
      {"1/2*sqrt(1+x^2)*dot(x)^2 + 1/2*sqrt(a+sqrt(1+y^2))*dot(y)^2", "sqrt(x^2+y^2)"},
      {"1/2*dot(x)^2/(1+x) + 1/2*dot(y)^2/(a+b*cos(y))", "1/(x+y) + tan(x)"},
      {"1/2*exp(x)*dot(x)^2 + 1/2*cosh(y)*dot(y)^2 + 1/4*dot(x)*dot(y)",
       "x*exp(-y) + log(1+x^2) + tanh(x-y)"},
      {"1/2*(2+sinc(x))*dot(x)^2 + 1/2*(1+log1p(y^2))*dot(y)^2",
       "hypot(x, 2+y) + expm1(x-y) + cosc(y)*stumpff(x, 3) + stumpff(x-y, -3)"},
      {"1/2*x^3*dot(x)^2 + 1/2*y^(1/3)*dot(y)^2", "x^(5/2) + (x+y)^12 + atan2(x,y)"},
      {"1/2*(2+cos(x/2)*cos(x/3))*dot(x)^2 + 1/2*(2+sin(x+pi/5))*dot(y)^2",
       "cos(0.3+x)+sin(pi/12+y)*cos(7*x)"},
      {"1/2*(a*dot(x)+b*sin(x-2*y)*dot(y))^2 + 1/2*c*dot(y)^2", "1/(1+sin(x)^2)+1/(2-cos(2*y))"},
  };
  for (const EnergyTexts& energies : all) {
    INFO(energies.T << ", " << energies.V);
    check_accepted(awkward_model(energies));
  }
}

TEST_CASE("motion that vanishes on paper is right where forces have no value") {
  check_accepted(boundless_drive);
}

TEST_CASE("angles, ranges and masses of any size raise no false error") {
  const auto errors = [](const std::string& extra, const std::string& energy) {
    const std::string text =
        "format = 1\n[model]\nname = \"large\"\n[[coordinate]]\nname = \"x\"\n" + extra +
        "[[coordinate]]\nname = \"y\"\n[parameters]\nm = 1e39\nw = " +
        "1e308\n[energy]\nT = \"dot(x)^2 + dot(y)^2\"\nV = \"" + energy + "\"\n";
    const Products products = run_pipeline(inputs_of(text), {});
    return has_errors(products.diagnostics) ? format(products.diagnostics) : std::string();
  };
  CHECK(errors("", "sin(w*x)") == "");
  CHECK(errors("", "cos(1e100*x + y)") == "");
  CHECK(errors("", "sin(exp(1000*x))") == "");
  CHECK(errors("", "tan(1e100*x*y)") == "");
  CHECK(errors("range = [0, \"1e400\"]\n", "x^2") == "");
  CHECK(errors("range = [\"-1e400\", \"1e400\"]\n", "sin(x)") == "");
  CHECK(errors("rate_range = [\"-1e400\", \"1e400\"]\n", "m*x^2*y") == "");
}

}  // namespace elgen::test
