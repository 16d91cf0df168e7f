// Energies and forces with a different branch on each side of a kink: no branch is lost, and values
// and derivatives are right on both sides.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "elgen/evaluate.hpp"
#include "pipeline/pipeline_testing.hpp"
#include "support/models.hpp"

namespace elgen::test {
namespace {

using std::numbers::pi;
using Curve = std::function<double(double)>;

double positive_part(double x) { return std::max(x, 0.0); }
double sign(double x) { return x < 0 ? -1 : 1; }
double step(double x) { return x < 0 ? 0 : 1; }

/// Positions on both sides of every kink below.
const std::vector<double> places{-2.7, -1.3, -0.4, 0.3, 0.7, 1.4, 1.8, 2.9};

Products products_of(const std::string& rest, const std::string& scene = {}) {
  const std::string text =
      model_text("kinked",
                 "[[coordinate]]\nname = \"x\"\nrange = [-3, 3]\n[parameters]\n"
                 "m = { value = 2, assume = \"positive\" }\nk = 5\ns = 0.5\n" +
                     rest);
  return products_with(&Products::files, inputs_of(text, scene));
}

/// The first entry of an output.
double value(const Products& products, const std::string& output, double x, double v) {
  const Program& program = *products.program;
  const auto function = std::ranges::find(program.functions, output, &Function::name);
  REQUIRE(function != program.functions.end());
  Arguments<double> at = map_leaves([](const std::string&) { return 0.0; }, program.leaves);
  at.parameters = {2, 5, 0.5};
  at.q = {x};
  at.v = {v};
  return evaluate(program, *function, at)[0];
}

struct KinkedEnergy {
  const char* V;
  Curve force;  ///< dV/dx
  Curve slope;  ///< d^2 V/dx^2
};

const std::vector<KinkedEnergy> kinked_energies{
    {"1/8*k*(x - 1 + sqrt((x - 1)^2))^2", [](double x) { return 5 * positive_part(x - 1); },
     [](double x) { return 5 * step(x - 1); }},
    {"1/8*k*(x - s + sqrt((x - s)^2))^2", [](double x) { return 5 * positive_part(x - 0.5); },
     [](double x) { return 5 * step(x - 0.5); }},
    {"k*(x + sqrt(x^2))^3/8", [](double x) { return 15 * std::pow(positive_part(x), 2); },
     [](double x) { return 30 * positive_part(x); }},
    {"k*sqrt(x^2)", [](double x) { return 5 * sign(x); }, [](double) { return 0; }},
    {"k*x*sqrt(x^2)/2", [](double x) { return 5 * std::abs(x); },
     [](double x) { return 5 * sign(x); }},
    {"(sqrt((x^2 - 1)^2) - x^2 + 1)/2", [](double x) { return std::abs(x) < 1 ? -2 * x : 0; },
     [](double x) { return std::abs(x) < 1 ? -2 : 0; }},
    {"(sqrt((x - 1)^2) + sqrt((x + 1)^2) - 2)^2/8",
     [](double x) { return sign(x) * positive_part(std::abs(x) - 1); },
     [](double x) { return step(std::abs(x) - 1); }},
    {"k*(asin(sin(x)) - x)^2/2",
     [](double x) { return 5 * (std::asin(std::sin(x)) - x) * (sign(std::cos(x)) - 1); },
     [](double x) { return 5 * std::pow(sign(std::cos(x)) - 1, 2); }},
    {"k*acos(cos(x))", [](double x) { return 5 * sign(std::sin(x)); }, [](double) { return 0; }},
    {"(acos(cos(x)) - x)^2/2",
     [](double x) { return (std::acos(std::cos(x)) - x) * (sign(std::sin(x)) - 1); },
     [](double x) { return std::pow(sign(std::sin(x)) - 1, 2); }},
    {"(atan(tan(x)) - x)*x", [](double x) { return std::atan(std::tan(x)) - x; },
     [](double) { return 0; }},
    {"(atan2(sin(x), cos(x) - 1/2) - x)*k",
     [](double x) {
       const double square = 1.25 - std::cos(x);
       return 5 * ((1 - std::cos(x) / 2) / square - 1);
     },
     [](double x) {
       const double square = 1.25 - std::cos(x);
       return 5 * std::sin(x) * (square / 2 - 1 + std::cos(x) / 2) / (square * square);
     }},
    {"(atan(x) + atan(1/x) - pi/2)*x", [](double x) { return x < 0 ? -pi : 0; },
     [](double) { return 0; }},
    {"sqrt(1 + 1/x^2)*x - sqrt(x^2 + 1)",
     [](double x) { return x < 0 ? -2 * x / std::sqrt(x * x + 1) : 0; },
     [](double x) { return x < 0 ? -2 / std::pow(x * x + 1, 1.5) : 0; }},
    {"sqrt(cos(x)^2)", [](double x) { return -std::sin(x) * sign(std::cos(x)); },
     [](double x) { return -std::abs(std::cos(x)); }},
    {"sqrt((sin(x) - 1/2)^2) - sin(x)",
     [](double x) { return std::cos(x) * (sign(std::sin(x) - 0.5) - 1); },
     [](double x) { return -std::sin(x) * (sign(std::sin(x) - 0.5) - 1); }},
    {"sqrt((exp(x) - 1)^2) - exp(x)", [](double x) { return std::exp(x) * (sign(x) - 1); },
     [](double x) { return std::exp(x) * (sign(x) - 1); }},
    {"log(x^2) - 2*log(sqrt(x^2)) + k*x*sqrt(x^2)", [](double x) { return 10 * std::abs(x); },
     [](double x) { return 10 * sign(x); }},
    {"sqrt(x^2*(1 - x)^2)", [](double x) { return sign(x * (1 - x)) * (1 - 2 * x); },
     [](double x) { return -2 * sign(x * (1 - x)); }},
    {"k*sqrt((x - s)^2*cosh(x)^2)/cosh(x)", [](double x) { return 5 * sign(x - 0.5); },
     [](double) { return 0; }},
};

struct KinkedForce {
  const char* value;
  Curve force;  ///< as a function of x, with v = 2 x
};

const std::vector<KinkedForce> forces{
    {"-k*max(x - 1, 0)", [](double x) { return -5 * positive_part(x - 1); }},
    {"k*(max(x, 0) - x)", [](double x) { return 5 * (positive_part(x) - x); }},
    {"min(x, 2) - x", [](double x) { return std::min(x, 2.0) - x; }},
    {"abs(x - 2) + x - 2", [](double x) { return std::abs(x - 2) + x - 2; }},
    {"-k*sign(dot(x))", [](double x) { return -5 * sign(x); }},
    {"max(-1, min(1, x)) - x", [](double x) { return std::clamp(x, -1.0, 1.0) - x; }},
    {"max(x, 0) + min(x, 0) - x", [](double) { return 0; }},
    {"dot(x)*(abs(x)/x - 1)", [](double x) { return 2 * x * (sign(x) - 1); }},
    {"-k*(dot(x) + sqrt(dot(x)^2))/2", [](double x) { return -5 * positive_part(2 * x); }},
};

void check_near(double x, double truth) { CHECK(x == Approx(truth).margin(1e-12)); }

}  // namespace

TEST_CASE("a potential with two branches keeps its force and its stiffness") {
  for (const auto& [V, force, slope] : kinked_energies) {
    const Products products =
        products_of(std::string("[energy]\nT = \"1/2*m*dot(x)^2\"\nV = \"") + V + "\"\n");
    for (const double x : places) {
      INFO(V << " at " << x);
      check_near(value(products, "gravity", x, 0), force(x));
      check_near(value(products, "inverse_dynamics_derivatives", x, 0), slope(x));
    }
  }
}

TEST_CASE("a force with a kink keeps both branches") {
  for (const auto& [text, force] : forces) {
    const Products products =
        products_of(std::string("[energy]\nT = \"1/2*m*dot(x)^2\"\n[[force]]\non = \"x\"\n") +
                    "value = \"" + text + "\"\n");
    for (const double x : places) {
      INFO(text << " at " << x);
      check_near(value(products, "applied_force", x, 2 * x), force(x));
    }
  }
}

TEST_CASE("a mass and a damper with two branches keep both") {
  const Products products = products_of(
      "[energy]\nT = \"1/2*(m + k*(x + sqrt(x^2)))*dot(x)^2\"\n"
      "D = \"1/8*k*(dot(x) + sqrt(dot(x)^2))^2\"\n");
  for (const double x : places) {
    INFO(x);
    check_near(value(products, "mass_matrix", x, 0), 2 + 10 * positive_part(x));
    check_near(value(products, "velocity_force", x, 3), 45 * step(x));
    check_near(value(products, "dissipation", x, x), 5 * positive_part(x));
  }
}

TEST_CASE("a stop at a fixed parameter keeps both branches") {
  const Products products =
      products_of("[energy]\nT = \"1/2*m*dot(x)^2\"\nV = \"1/8*k*(x - s + sqrt((x - s)^2))^2\"\n",
                  "[parameters]\nfixed = \"all\"\n");
  for (const double x : places) {
    check_near(value(products, "gravity", x, 0), 5 * positive_part(x - 0.5));
  }
}

}  // namespace elgen::test
