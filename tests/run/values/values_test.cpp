// Values at a state, and test vectors: digits, states, and what each record has.
#include "elgen/values.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "elgen/pipeline.hpp"
#include "support/models.hpp"
#include "support/shell.hpp"

using namespace elgen;
using elgen::test::checked_model;
using elgen::test::count;
using elgen::test::mentions;
using elgen::test::model_text;
using Json = nlohmann::json;

namespace {

std::string file_of(const std::string& name) {
  return elgen::test::read_text(std::string(ELGEN_SOURCE_DIR) + "/models/" + name + ".toml");
}

std::vector<SourcePointer> option(const std::string& text) {
  return {make_source("command line", text)};
}

SceneOptions options_of(const std::string& state, const std::string& outputs) {
  SceneOptions options;
  options.states_all = true;
  options.close_functions = true;
  if (!state.empty()) options.starts = option(state);
  if (!outputs.empty()) options.outputs = option(outputs);
  return options;
}

/// The record of a function as JSON, at the state of these options.
Json evaluated(const std::string& text, const SceneOptions& given, const StateOptions& how = {}) {
  const CheckedModel checked = checked_model(text, given);
  const Result<ValueTable> values = state_values(checked, how);
  REQUIRE(values);
  return Json::parse(to_json(*values));
}

/// Derived, with vectors of it.
class Vectors {
 public:
  explicit Vectors(const std::string& text, const VectorOptions& options = {},
                   const std::string& outputs = {})
      : products_(derived(text, outputs)),
        table(test_vectors(*products_.checked, *products_.program, options)) {}

 private:
  static Products derived(const std::string& text, const std::string& outputs) {
    PipelineOptions pipeline;
    pipeline.goals = {Goal::choose};
    if (!outputs.empty()) pipeline.scene.outputs = option(outputs);
    Products products = run_pipeline({make_source("test.toml", text), nullptr}, pipeline);
    REQUIRE(products.program);
    return products;
  }

  Products products_;

 public:
  Result<ValueTable> table;
};

const std::string block = model_text("block", R"(
[[coordinate]]
name = "x"
start = { value = 2, rate = -1 }
[parameters]
m = { value = 4 }
[energy]
T = "1/2*m*dot(x)^2"
[[input]]
name = "u"
on = "x"
)");

}  // namespace

/// Taylor, Classical Mechanics (2005), equation (11.37) and the lines before it: M and the
/// accelerations of a double pendulum with absolute angles, by mpmath in 70 digits.
TEST_CASE("mass matrix and accelerations of the double pendulum are those of the book") {
  const SceneOptions options = options_of("theta1=0.1, theta2=-0.2, dot(theta1)=2, dot(theta2)=-1",
                                          "mass_matrix,forward_dynamics");
  const CheckedModel checked = checked_model(file_of("double_pendulum"), options);
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

TEST_CASE("the state is the start, and what is stated beside it") {
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

TEST_CASE("functions with inputs have an empty list of them in models without inputs") {
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
    // C has no empty arrays, and rows have no empty names.
    CHECK(mentions(to_header(*vectors.table), "double u[") == (inputs > 0));
    CHECK(mentions(to_csv(*vectors.table),
                   inputs > 0 ? ",state,m,x,dot(x),u\n" : ",state,m,x,dot(x)\n"));
  }
}

TEST_CASE("momenta are those of the rates, or stated") {
  CHECK(evaluated(block, options_of("", "hamiltonian"))["values"][0]["momenta"] == Json{-4.0});
  const Json stated = evaluated(block, options_of("p(x)=8", "hamiltonian"))["values"][0];
  CHECK(stated["momenta"] == Json{8.0});
  CHECK(stated["value"] == Json{8.0});
}

TEST_CASE("inputs are what their laws say at the state and the time") {
  const std::string text = block + "[[force]]\nname = \"pull\"\non = \"x\"\nvalue = \"2*t\"\n";
  SceneOptions options = options_of("t=3, x=0.5", "forward_dynamics");
  options.laws = option("u=-4*x - t");
  const Json record = evaluated(text, options)["values"][0];
  CHECK(record["u"] == Json{-5.0});
  CHECK(record["t"] == 3.0);
  CHECK(record["value"][0] == 0.25);
}

TEST_CASE("what cancels on paper is 0, and small values keep their digits") {
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
  // Smaller than the rounding of 95 digits.
  const Json smaller = evaluated(text, options_of("q=1e-40", "zero,small"))["values"];
  CHECK(smaller[0]["value"] == Json{0.0});
  CHECK(smaller[1]["value"][0] == Approx(1e-120 / 6).epsilon(1e-15));
}

TEST_CASE("a quaternion is scaled to length 1") {
  const Json record =
      evaluated(file_of("quadrotor"), options_of("attitude=[3,0,4,0]", "mass_matrix"))["values"][0];
  const std::vector<double> q = record["q"];
  CHECK(std::count(q.begin(), q.end(), 0.6) == 1);
  CHECK(std::count(q.begin(), q.end(), 0.8) == 1);
}

TEST_CASE("constraints move what is not named, unless the state is to stay as it is") {
  const SceneOptions options = options_of("x=0.3", "constraint_residual");
  const Json moved = evaluated(file_of("pendulum_xy"), options)["values"][0];
  CHECK(std::abs(moved["value"][0].get<double>()) < 1e-50);
  CHECK(moved["q"][0] == 0.3);
  const Json stays = evaluated(file_of("pendulum_xy"), options, {.projects = false})["values"][0];
  CHECK(std::abs(stays["value"][0].get<double>()) > 1e-3);
}

TEST_CASE("an output without a value is an error beside the values of the others") {
  const std::string text = block + "[[output]]\nname = \"y\"\nvalue = \"1/(x - 2*m/m)\"\n";
  const CheckedModel checked = checked_model(text, options_of("", "kinetic_energy,y"));
  const Result<ValueTable> values = state_values(checked, {});
  REQUIRE(values);
  CHECK(values->records.size() == 1);
  REQUIRE(values.diagnostics.size() == 1);
  CHECK(values.diagnostics[0].code == Code::E521);
  CHECK(values.diagnostics[0].message == "`y` has no value at this state");
}

/// The message of the one output without a value.
std::string refused(const std::string& text, const std::string& state, const std::string& output) {
  const CheckedModel checked = checked_model(text, options_of(state, output));
  const Result<ValueTable> values = state_values(checked, {});
  REQUIRE(values.diagnostics.size() == 1);
  return values.diagnostics[0].message;
}

TEST_CASE("an output that no digits tell is an error of its own words") {
  const std::string text = block + "[[output]]\nname = \"y\"\nvalue = \"1 - cos(x^4)\"\n";
  CHECK(evaluated(text, options_of("x=1e-25", "y"))["values"][0]["value"][0] ==
        Approx(5e-201).epsilon(1e-15));
  CHECK(refused(text, "x=1e-300", "y") ==
        "`y` cannot be told at this state: 2000 digits do not tell its values from 0, or a number "
        "in them is too large");
}

TEST_CASE("a spring of length 0 has no force at its anchor, and vectors leave the state out") {
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

TEST_CASE("what cancels in 1e100 is seen, and the rest is 0") {
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

TEST_CASE("states are the start, then at rest, moving, and with other parameters") {
  const Vectors vectors(block, {.samples = 7}, "kinetic_energy,forward_dynamics");
  REQUIRE(vectors.table);
  const Json values = Json::parse(to_json(*vectors.table))["values"];
  REQUIRE(values.size() == 14);
  const std::vector<std::string> places{"start", "rest",   "moving",    "parameters",
                                        "rest",  "moving", "parameters"};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Json& record = values[7 + i];
    INFO(record);
    CHECK(record["function"] == "forward_dynamics");
    CHECK(record["state"] == places[i]);
    const double m = record["p"]["m"];
    const double u = record["u"][0];
    CHECK((m == 4) == (places[i] != "parameters"));
    CHECK((u == 0) == (places[i] == "start" || places[i] == "rest"));
    CHECK((record["v"][0] == 0.0) == (places[i] == "rest"));
    CHECK(record["value"][0] == Approx(u / m).epsilon(1e-15));
    CHECK(record["digits"][0].get<int>() >= (u == 0 ? 0 : 15));
  }
}

TEST_CASE("states of vectors are on the constraints, but where values tell how far off they are") {
  const Vectors vectors(file_of("pendulum_xy"), {.samples = 7},
                        "gravity,forward_dynamics,constraint_residual");
  REQUIRE(vectors.table);
  const Json table = Json::parse(to_json(*vectors.table));
  CHECK(table["off_constraints"] == 0);
  std::size_t residuals = 0;
  for (const Json& record : table["values"]) {
    INFO(record);
    const double x = record["q"][0];
    const double y = record["q"][1];
    const double l = record["p"]["l"];
    // Coordinates are rounded once, and so are squares and sums.
    const bool is_on_rod = std::abs(x * x + y * y - l * l) <= 1e-15 * (1 + l * l);
    const bool is_residual = record["function"] == "constraint_residual";
    if (record["state"] != "start") CHECK(is_on_rod != is_residual);
    residuals += is_residual ? 1 : 0;
    if (record["function"] != "forward_dynamics") continue;
    const double vx = record["v"][0];
    const double vy = record["v"][1];
    CHECK(std::abs(x * vx + y * vy) <= 1e-15 * (1 + std::abs(x * vx)));
  }
  CHECK(residuals == 7);
  CHECK(table["values"].size() == 21);
  CHECK_FALSE(mentions(to_header(*vectors.table), "left out"));
  CHECK_FALSE(mentions(to_json(*Vectors(block, {.samples = 1}).table), "off_constraints"));
}

TEST_CASE("states of vectors that no step of Newton puts on the constraints are counted") {
  const std::string wall = model_text("wall", R"toml(
[[coordinate]]
name = "x"
start = { value = 0.6, rate = 0 }
[[coordinate]]
name = "y"
[parameters]
d = { value = 1 }
l = { value = 1.05 }
[energy]
T = "1/2*(dot(x)^2 + dot(y)^2)"
[[constraint]]
name = "wall"
equation = "x^2 + d^2 = l^2"
)toml");
  const Vectors vectors(wall, {.samples = 7}, "forward_dynamics");
  REQUIRE(vectors.table);
  REQUIRE(vectors.table->unmet.value_or(0) > 0);
  CHECK(vectors.table->records.size() + *vectors.table->unmet == 7);
  CHECK(mentions(to_header(*vectors.table),
                 " left out: no step of Newton puts them on the constraints."));
}

TEST_CASE("vectors are the same for a seed, and others for another") {
  const auto text = [](std::uint64_t seed) {
    return to_json(*Vectors(block, {.samples = 4, .seed = seed}, "kinetic_energy").table);
  };
  CHECK(text(1) == text(1));
  CHECK(text(1) != text(2));
}

TEST_CASE("fewer digits are kept where terms cancel, and all of what is exact") {
  const std::string text = model_text("sums", R"(
[[coordinate]]
name = "q"
start = { value = 0.0001, rate = 0 }
[energy]
T = "1/2*dot(q)^2"
[[output]]
name = "tiny"
value = "exp(q) - 1 - q"
[[output]]
name = "exact"
value = "q"
)");
  const Vectors vectors(text, {.samples = 1}, "tiny,exact");
  REQUIRE(vectors.table);
  CHECK(vectors.table->records[0].digits[0] < 14);
  CHECK(vectors.table->records[1].digits[0] == 17);
}

TEST_CASE("every kind of model has as many values as fields, and digits") {
  for (const std::string name : {"cart_pole", "pendulum_xy", "quadrotor", "kepler_polar"}) {
    INFO(name);
    const Vectors vectors(file_of(name), {.samples = 2});
    REQUIRE(vectors.table);
    const ValueTable& table = *vectors.table;
    std::set<std::size_t> functions;
    for (const ValueRecord& record : table.records) {
      functions.insert(record.function);
      std::size_t size = 0;
      for (const ValueField& field : table.functions[record.function].fields) {
        size += field.rows.size() * field.columns.size();
      }
      CHECK(record.values.size() == size);
      CHECK(record.digits.size() == size);
    }
    CHECK(functions.size() == table.functions.size());
    const std::string csv = to_csv(table);
    const std::string head = csv.substr(0, csv.find('\n'));
    CHECK(count(csv, ",") == count(csv, "\n") * count(head, ","));
  }
}

TEST_CASE("vectors of an output that reads a function left open are refused by its name") {
  const std::string text = block + "[[function]]\nname = \"V\"\nof = [\"x\"]\nsample = \"x\"\n";
  const std::string open = text.substr(0, text.find("[energy]")) + "[energy]\nV = \"V\"\n" +
                           text.substr(text.find("[energy]") + std::string("[energy]\n").size());
  const Vectors refused(open, {}, "gravity,bias,mass_matrix");
  CHECK_FALSE(refused.table);
  REQUIRE(refused.table.diagnostics.size() == 1);
  CHECK(refused.table.diagnostics[0].code == Code::E633);
  CHECK(refused.table.diagnostics[0].message ==
        "`V` is left open, and vectors of `bias`, `gravity` need its values");
  CHECK(Vectors(open, {}, "mass_matrix").table);
}
