// The whole path in double against published values: model text -> program -> numbers.
//
// Each entry is within 4 ulp of the exact value for the same binary inputs. An entry whose terms
// cancel is within u E, with the unit roundoff u and the running error E.
#include <cln/real.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "elgen/evaluate.hpp"
#include "elgen/oracle.hpp"
#include "elgen/pipeline.hpp"
#include "parse/decimal.hpp"
#include "support/inputs.hpp"
#include "verify/bounds/exact_run.hpp"

using namespace elgen;
using namespace elgen::test;
using nlohmann::json;

namespace {

constexpr double largest_ulps = 4.0;

std::string model_text(const json& system) {
  std::string text = "format = 1\n[model]\nname = \"reference\"\n";
  for (const auto& name : system["coordinates"]) {
    text += "[[coordinate]]\nname = \"" + name.get<std::string>() + "\"\n";
    text += "[[input]]\nname = \"tau_" + name.get<std::string>() + "\"\non = \"" +
            name.get<std::string>() + "\"\n";
  }
  text += "[parameters]\n";
  for (const auto& [name, value] : system["parameters"].items()) {
    text += name + " = \"" + value.get<std::string>() + "\"\n";
  }
  return text + "[energy]\nT = \"" + system["T"].get<std::string>() + "\"\nV = \"" +
         system["V"].get<std::string>() + "\"\n";
}

cln::cl_R exact(const std::string& decimal) { return decimal_value(decimal_parts(decimal)); }

std::vector<double> rounded(const json& decimals) {
  std::vector<double> values;
  for (const auto& decimal : decimals) values.push_back(std::stod(decimal.get<std::string>()));
  return values;
}

struct BinaryState {
  Arguments<double> arguments;
  State state;
};

BinaryState binary_state(const Model& model, const json& given) {
  BinaryState result;
  Arguments<double>& x = result.arguments;
  for (const Parameter& parameter : model.parameters) {
    x.parameters.push_back(to_double(parameter.value));
  }
  x.q = rounded(given["q"]);
  x.v = rounded(given["v"]);
  x.u = rounded(given["u"]);
  x.a.assign(x.q.size(), 0.0);
  const auto all = [](const std::vector<double>& values) {
    std::vector<cln::cl_R> numbers;
    for (const double value : values) numbers.push_back(exact_value(value));
    return numbers;
  };
  result.state = {
      .parameters = all(x.parameters), .q = all(x.q), .v = all(x.v), .a = all(x.a), .u = all(x.u)};
  return result;
}

/// The distance from the exact value, in ulps of its nearest double.
double ulps(double x, const cln::cl_R& value) {
  const double nearest = to_double(value);
  const double step = std::nextafter(std::fabs(nearest), std::numeric_limits<double>::infinity()) -
                      std::fabs(nearest);
  const cln::cl_R distance = cln::abs(exact_value(x) - value) / exact_value(step);
  return to_double(distance);
}

void check_state(const Products& products, const json& given) {
  const BinaryState at = binary_state(products.checked->model, given["state"]);
  for (const auto& [name, decimals] : given["state"]["expected"].items()) {
    for (const Function& function : products.program->functions) {
      if (function.name != name) continue;
      const auto values = evaluate(*products.program, function, at.arguments);
      const ExactRun run =
          run_exactly(*products.program, function, at.state, rounding_constants<double>());
      REQUIRE(run.regime == Regime::regular);
      for (std::size_t i = 0; i < decimals.size(); ++i) {
        const double in_ulps = ulps(values[i], exact(decimals[i].get<std::string>()));
        const RunningValue<Real>& entry = run.entries[i];
        const double in_errors = error_in_roundoffs(
            excess_error(values[i], entry.value, 1000, rounding_constants<double>()), entry.error,
            rounding_constants<double>());
        INFO(given["id"] << " " << name << "[" << i << "]: " << in_ulps << " ulp, " << in_errors
                         << " u E");
        CHECK((in_ulps <= largest_ulps || in_errors <= 1));
      }
    }
  }
}

}  // namespace

TEST_CASE("static values of textbook systems are right in double") {
  std::ifstream file(ELGEN_SOURCE_DIR "/tests/pipeline/reference_cases.json");
  const json cases = json::parse(file);
  REQUIRE(cases["cases"].size() == 9);
  for (const json& system : cases["cases"]) {
    const PipelineSources inputs{make_source("reference.toml", model_text(system)), nullptr};
    const Products products = products_with(&Products::program, inputs);
    for (const json& state : system["states"]) {
      check_state(products, {{"id", system["id"]}, {"state", state}});
    }
  }
}
