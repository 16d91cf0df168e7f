// Right models that a check of elgen's own once refused.
#include <catch2/catch.hpp>

#include "pipeline/pipeline_testing.hpp"
#include "support/models.hpp"

namespace elgen::test {
namespace {

Products check_accepted(const std::string& text, const std::string& scene = {}) {
  Products products = run_pipeline(inputs_of(text, scene), {});
  INFO(format(products.diagnostics));
  REQUIRE(products.self_check);
  VerifyOptions options;
  options.quick = true;
  options.parts = &products.parts;
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

}  // namespace

TEST_CASE("powers of calls have the rounding of every call") {
  const std::string y = "[[coordinate]]\nname = \"y\"\n";
  const std::string T = "1/2*m*(dot(x)^2 + dot(y)^2)";
  check_accepted(energies("[[coordinate]]\nname = \"x\"\nrange = [0.1, 10]\n" + y, T,
                          "(1 + log(x)^20)*cos(y)"));
  check_accepted(energies("[[coordinate]]\nname = \"x\"\n" + y, T, "(1 + cosh(x)^10)*cos(y)"));
}

TEST_CASE("a proved 0 is no mistake where the oracle's terms leave rounding") {
  check_accepted(energies("[[coordinate]]\nname = \"x\"\nrange = [-3, 3]\n", "1/2*m*dot(x)^2",
                          "k*(sqrt(x^2 + 1)^2*exp(x) - x^2*exp(x) - exp(x))"));
}

TEST_CASE("a definition that holds the one before it twice is no explosion") {
  std::string text = "[define]\nd1 = \"x*sin(x)\"\n";
  for (int i = 2; i <= 12; ++i) {
    const std::string last = "d" + std::to_string(i - 1);
    text += "d" + std::to_string(i) + " = \"sin(" + last + ")*" + last + "\"\n";
  }
  check_accepted(
      energies("[[coordinate]]\nname = \"x\"\nrange = [-3, 3]\n", "1/2*m*dot(x)^2", "k*d12") +
      text);
}

TEST_CASE("an arm of numbers whose last link is axisymmetric has a column of zeros") {
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

TEST_CASE("rates beyond the speed of light are outside of the domain, and drawn anew") {
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
  CHECK(products.self_check->outside > 0);
}

}  // namespace elgen::test
