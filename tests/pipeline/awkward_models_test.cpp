// Energies that no textbook has: nested calls, roots of roots, quotients, high powers, odd angles.
// Whatever form each function is emitted in, everything verify checks has to hold.
#include <catch2/catch.hpp>

#include "elgen/pipeline.hpp"

namespace elgen {

namespace {

struct EnergyTexts {
  const char* T;
  const char* V;
};

std::string model_of(const EnergyTexts& energies) {
  return std::string(
             "format = 1\n[model]\nname = \"awkward\"\n"
             "[[coordinate]]\nname = \"x\"\nrange = [0.2, 1.5]\n"
             "[[coordinate]]\nname = \"y\"\nrange = [0.3, 1.2]\n"
             "[parameters]\na = { value = 1.3, assume = \"positive\" }\nb = 0.7\nc = 2\n"
             "[energy]\nT = \"") +
         energies.T + "\"\nV = \"" + energies.V + "\"\n";
}

void check_certificate(const std::string& text) {
  const Inputs inputs{make_source("model.toml", text), nullptr};
  Products products = run_pipeline(inputs, {});
  REQUIRE(products.self_check);
  const auto& [model, scene] = *products.checked;
  VerifyOptions options;
  options.quick = true;
  options.forms = &*products.closed_forms;
  const Certificate certificate = verify(model, scene, *products.program, {}, options).certificate;
  INFO(to_text(certificate));
  CHECK(holds(certificate));
}

/// A frame turned by an angle, whose acceleration vanishes on paper, with a potential that grows
/// beyond all numbers at large negative times.
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

TEST_CASE("awkward energies hold in every check") {
  const std::vector<EnergyTexts> all{
      {"1/2*(2+sin(sin(x)))*dot(x)^2 + 1/2*a*dot(y)^2", "cos(x*cos(y))"},
      {"1/2*sqrt(1+x^2)*dot(x)^2 + 1/2*sqrt(a+sqrt(1+y^2))*dot(y)^2", "sqrt(x^2+y^2)"},
      {"1/2*dot(x)^2/(1+x) + 1/2*dot(y)^2/(a+b*cos(y))", "1/(x+y) + tan(x)"},
      {"1/2*exp(x)*dot(x)^2 + 1/2*cosh(y)*dot(y)^2 + 1/4*dot(x)*dot(y)",
       "x*exp(-y) + log(1+x^2) + tanh(x-y)"},
      {"1/2*x^3*dot(x)^2 + 1/2*y^(1/3)*dot(y)^2", "x^(5/2) + (x+y)^12 + atan2(x,y)"},
      {"1/2*(2+cos(x/2)*cos(x/3))*dot(x)^2 + 1/2*(2+sin(x+pi/5))*dot(y)^2",
       "cos(0.3+x)+sin(pi/12+y)*cos(7*x)"},
      {"1/2*(a*dot(x)+b*sin(x-2*y)*dot(y))^2 + 1/2*c*dot(y)^2", "1/(1+sin(x)^2)+1/(2-cos(2*y))"},
  };
  for (const EnergyTexts& energies : all) {
    INFO(energies.T << ", " << energies.V);
    check_certificate(model_of(energies));
  }
}

TEST_CASE("motion that vanishes on paper holds where forces have no value") {
  check_certificate(boundless_drive);
}

TEST_CASE("angles, ranges and masses of any size raise no false alarm") {
  const auto errors = [](const std::string& extra, const std::string& energy) {
    const std::string text =
        "format = 1\n[model]\nname = \"large\"\n[[coordinate]]\nname = \"x\"\n" + extra +
        "[[coordinate]]\nname = \"y\"\n[parameters]\nm = 1e39\nw = " +
        "1e308\n[energy]\nT = \"dot(x)^2 + dot(y)^2\"\nV = \"" + energy + "\"\n";
    const Products products = run_pipeline({make_source("model.toml", text), nullptr}, {});
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

}  // namespace elgen
