// Test vectors: their states, seeds, digits, and records.
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "numbers/exact_number.hpp"
#include "run/values/values_testing.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("states are the start, then rest, motion, and changed parameters in turn") {
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

TEST_CASE("states of vectors are on the constraints, except for constraint residuals") {
  const Vectors vectors(model_file("pendulum_xy"), {.samples = 7},
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
    // Coordinates, squares and sums are rounded once each.
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

TEST_CASE("states that Newton steps cannot move onto the constraints are counted") {
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
  REQUIRE(vectors.table->skipped_states.value_or(0) > 0);
  CHECK(vectors.table->records.size() + *vectors.table->skipped_states == 7);
  CHECK(mentions(to_header(*vectors.table), " omitted: not projected onto the constraints."));
}

TEST_CASE("a seed determines the vectors") {
  const auto text = [](std::uint64_t seed) {
    return to_json(*Vectors(block, {.samples = 4, .seed = seed}, "kinetic_energy").table);
  };
  CHECK(text(1) == text(1));
  CHECK(text(1) != text(2));
}

TEST_CASE("cancelling terms have fewer correct digits, exact values have all") {
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

TEST_CASE("every kind of model has as many values and digits as entries") {
  for (const std::string name : {"cart_pole", "pendulum_xy", "quadrotor", "kepler_polar"}) {
    INFO(name);
    const Vectors vectors(model_file(name), {.samples = 2});
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

TEST_CASE("vectors of outputs with an open function are refused with its name") {
  const std::string text = block + "[[function]]\nname = \"V\"\nof = [\"x\"]\nsample = \"x\"\n";
  const std::string open = text.substr(0, text.find("[energy]")) + "[energy]\nV = \"V\"\n" +
                           text.substr(text.find("[energy]") + std::string("[energy]\n").size());
  const Vectors refused(open, {}, "gravity,bias,mass_matrix");
  CHECK_FALSE(refused.table);
  REQUIRE(refused.table.diagnostics.size() == 1);
  CHECK(refused.table.diagnostics[0].code == Code::E633);
  CHECK(refused.table.diagnostics[0].message ==
        "`V` is left open, but vectors of `bias`, `gravity` need its values");
  CHECK(Vectors(open, {}, "mass_matrix").table);
}

TEST_CASE("values of vectors are the oracle's, and each is announced") {
  std::vector<std::string> steps;
  const Vectors vectors(
      model_file("double_pendulum"),
      {.samples = 2, .on_step = [&](const std::string& step) { steps.push_back(step); }},
      "gravity,linearization");
  REQUIRE(vectors.table);
  CHECK(steps == std::vector<std::string>{"gravity, state 1 of 2", "gravity, state 2 of 2",
                                          "linearization, state 1 of 2",
                                          "linearization, state 2 of 2"});
  for (const ValueRecord& record : vectors.table->records) {
    const ValueTable& table = *vectors.table;
    const StableValues expected =
        stable_values(table.model, table.functions[record.function].output, record.state);
    REQUIRE(expected.values);
    REQUIRE(record.values.size() == expected.values->size());
    for (std::size_t i = 0; i < record.values.size(); ++i) {
      CHECK(cln::abs(record.values[i] - (*expected.values)[i]) <=
            cln::abs(record.values[i]) * power_of_ten(-20));
    }
  }
}
