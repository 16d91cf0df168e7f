// Values at a state: digits, states, and records.
#include "elgen/values.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "run/values/values_testing.hpp"

using namespace elgen;
using namespace elgen::test;

/// Taylor, Classical Mechanics (2005), equation (11.37) and the preceding lines: M and the
/// accelerations of a double pendulum with absolute angles, evaluated by mpmath in 70 digits.
TEST_CASE("mass matrix and accelerations of the double pendulum agree with the book") {
  const SceneOptions options = options_of("theta1=0.1, theta2=-0.2, dot(theta1)=2, dot(theta2)=-1",
                                          "mass_matrix,forward_dynamics");
  const CheckedModel checked = checked_model(model_file("double_pendulum"), options);
  const Result<ValueTable> values = state_values(checked, {});
  REQUIRE(values);
  CHECK(to_text(*values) ==
        "double_pendulum at theta1 = 0.1, theta2 = -0.2, dot(theta1) = 2.0, dot(theta2) = -1.0\n"
        "mass_matrix\n"
        "                              theta1                      theta2\n"
        "  theta1                 0.45 kg*m^2  0.15285383826009696 kg*m^2\n"
        "  theta2  0.15285383826009696 kg*m^2                0.128 kg*m^2\n"
        "forward_dynamics.acceleration\n"
        "  theta1  -7.1011870194506835 1/s^2\n"
        "  theta2   14.829995215788502 1/s^2\n"
        "forward_dynamics.relative_pivots\n"
        "  theta1                  1.0\n"
        "  theta2  0.59436986335340482\n");
  const Result<ValueTable> more = state_values(checked, {.digits = 40});
  REQUIRE(more);
  CHECK(mentions(to_csv(*more),
                 "forward_dynamics,acceleration,theta1,,1/s^2,"
                 "-7.101187019450683540632670504377957262624,,state,"));
}

TEST_CASE("the state is the start with the stated changes") {
  const Json plain = evaluated(block, options_of("", "inverse_dynamics,kinetic_energy"));
  const Json energy = plain["values"][0];
  CHECK(energy["function"] == "kinetic_energy");
  CHECK(energy["q"] == Json{2.0});
  CHECK(energy["v"] == Json{-1.0});
  CHECK(energy["p"] == Json{{"m", 4.0}});
  CHECK(energy["value"] == Json{2.0});
  CHECK_FALSE(energy.contains("a"));
  CHECK(plain["values"][1]["a"] == Json{0.0});
  const Json stated =
      evaluated(block, options_of("dot(dot(x))=3", "inverse_dynamics"))["values"][0];
  CHECK(stated["a"] == Json{3.0});
  CHECK(stated["value"] == Json{12.0});
}

TEST_CASE("functions with inputs have an empty list of inputs in models without inputs") {
  for (const auto& [text, inputs] :
       {std::pair{block, 1U}, std::pair{block.substr(0, block.find("[[input]]")), 0U}}) {
    const Vectors vectors(text, {.samples = 2}, "forward_dynamics,mass_matrix");
    REQUIRE(vectors.table);
    const Json object = Json::parse(to_json(*vectors.table));
    REQUIRE(object["functions"].size() == 2);
    for (const Json& function : object["functions"]) {
      const bool takes_inputs = function["name"] == "forward_dynamics";
      REQUIRE(function["takes"].contains("u") == takes_inputs);
      if (takes_inputs) CHECK(function["takes"]["u"].size() == inputs);
    }
    REQUIRE(object["values"].size() == 4);
    for (const Json& record : object["values"]) {
      const bool takes_inputs = record["function"] == "forward_dynamics";
      REQUIRE(record.contains("u") == takes_inputs);
      if (takes_inputs) CHECK(record["u"].size() == inputs);
    }
    // C has no empty arrays, and CSV columns have no empty names.
    CHECK(mentions(to_header(*vectors.table), "double u[") == (inputs > 0));
    CHECK(mentions(to_csv(*vectors.table),
                   inputs > 0 ? ",state,m,x,dot(x),u\n" : ",state,m,x,dot(x)\n"));
  }
}

TEST_CASE("momenta follow from the rates, or are stated") {
  CHECK(evaluated(block, options_of("", "hamiltonian"))["values"][0]["momenta"] == Json{-4.0});
  const Json stated = evaluated(block, options_of("p(x)=8", "hamiltonian"))["values"][0];
  CHECK(stated["momenta"] == Json{8.0});
  CHECK(stated["value"] == Json{8.0});
}

TEST_CASE("inputs have their laws' values at the state and time") {
  const std::string text = block + "[[force]]\nname = \"pull\"\non = \"x\"\nvalue = \"2*t\"\n";
  SceneOptions options = options_of("t=3, x=0.5", "forward_dynamics");
  options.laws = option("u=-4*x - t");
  const Json record = evaluated(text, options)["values"][0];
  CHECK(record["u"] == Json{-5.0});
  CHECK(record["t"] == 3.0);
  CHECK(record["value"][0] == 0.25);
}

TEST_CASE("terms that cancel give exactly 0, and small values keep their digits") {
  const std::string text = model_text("sums", R"(
[[coordinate]]
name = "q"
[energy]
T = "1/2*dot(q)^2"
[[output]]
name = "zero"
value = "sin(q)^2 + cos(q)^2 - 1"
[[output]]
name = "small"
value = "exp(q) - 1 - q - q^2/2"
)");
  const Json values = evaluated(text, options_of("q=1e-20", "zero,small"))["values"];
  CHECK(values[0]["value"] == Json{0.0});
  CHECK(values[1]["value"][0] == Approx(1e-60 / 6).epsilon(1e-15));
  // 1e-120 is smaller than a rounding error at the oracle's working precision.
  const Json smaller = evaluated(text, options_of("q=1e-40", "zero,small"))["values"];
  CHECK(smaller[0]["value"] == Json{0.0});
  CHECK(smaller[1]["value"][0] == Approx(1e-120 / 6).epsilon(1e-15));
}

TEST_CASE("a stated quaternion is normalised") {
  const Json record = evaluated(model_file("quadrotor"),
                                options_of("attitude=[3,0,4,0]", "mass_matrix"))["values"][0];
  const std::vector<double> q = record["q"];
  CHECK(std::count(q.begin(), q.end(), 0.6) == 1);
  CHECK(std::count(q.begin(), q.end(), 0.8) == 1);
}

TEST_CASE("constraints change values that are not stated, unless projection is off") {
  const SceneOptions options = options_of("x=0.3", "constraint_residual");
  const Json moved = evaluated(model_file("pendulum_xy"), options)["values"][0];
  CHECK(std::abs(moved["value"][0].get<double>()) < 1e-50);
  CHECK(moved["q"][0] == 0.3);
  const Json stays =
      evaluated(model_file("pendulum_xy"), options, {.projects = false})["values"][0];
  CHECK(std::abs(stays["value"][0].get<double>()) > 1e-3);
}

TEST_CASE("an output without a value is an error, and the others have values") {
  const std::string text = block + "[[output]]\nname = \"y\"\nvalue = \"1/(x - 2*m/m)\"\n";
  const CheckedModel checked = checked_model(text, options_of("", "kinetic_energy,y"));
  const Result<ValueTable> values = state_values(checked, {});
  REQUIRE(values);
  CHECK(values->records.size() == 1);
  REQUIRE(values.diagnostics.size() == 1);
  CHECK(values.diagnostics[0].code == Code::E521);
  CHECK(values.diagnostics[0].message == "`y` has no value at this state");
}

/// The message for the only output without a value.
std::string refused(const std::string& text, const std::string& state, const std::string& output) {
  const CheckedModel checked = checked_model(text, options_of(state, output));
  const Result<ValueTable> values = state_values(checked, {});
  REQUIRE(values.diagnostics.size() == 1);
  return values.diagnostics[0].message;
}

TEST_CASE("an output that no precision decides has its own error") {
  const std::string text = block + "[[output]]\nname = \"y\"\nvalue = \"1 - cos(x^4)\"\n";
  CHECK(evaluated(text, options_of("x=1e-25", "y"))["values"][0]["value"][0] ==
        Approx(5e-201).epsilon(1e-15));
  CHECK(refused(text, "x=1e-300", "y") ==
        "`y` is undecided at this state: 2000 digits do not distinguish its values from 0, or a "
        "number in them is too large");
}

TEST_CASE("a spring of length 0 has no force at its anchor, and vectors omit that state") {
  const std::string spring = model_text("spring", R"toml(
[[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[parameters]
F = 40
[energy]
T = "dot(x)^2 + dot(y)^2"
V = "F*sqrt(x^2 + y^2)"
)toml");
  CHECK(refused(spring, "x=0, y=0", "gravity") == "`gravity` has no value at this state");
  CHECK(evaluated(spring, options_of("x=3, y=4", "gravity"))["values"][0]["value"][0] == 24.0);
  const Vectors vectors(spring, {.samples = 3}, "gravity,potential_energy");
  REQUIRE(vectors.table);
  const Json records = Json::parse(to_json(*vectors.table))["values"];
  REQUIRE(records.size() == 5);
  CHECK(records[0]["function"] == "gravity");
  CHECK(records[0]["state"] == "rest");
  CHECK(records[2]["function"] == "potential_energy");
  CHECK(records[2]["state"] == "start");
}

TEST_CASE("terms that cancel at 1e100 keep their difference, and exact zeros are 0") {
  const std::string text = model_text("large", R"toml(
[[coordinate]]
name = "x"
[parameters]
k = 2
l = 1
[energy]
T = "dot(x)^2"
V = "1/2*k*(x^2 - (x - l)*(x + l))"
)toml");
  const Json values = evaluated(text, options_of("x=1e100", "potential_energy,gravity"))["values"];
  CHECK(values[0]["function"] == "gravity");
  CHECK(values[0]["value"] == Json{0.0});
  CHECK(values[1]["value"] == Json{1.0});
}
