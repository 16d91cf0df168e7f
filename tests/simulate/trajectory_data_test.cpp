// A trajectory for programs.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "elgen/simulate.hpp"

using namespace elgen;

namespace {

Trajectory two_columns() {
  Trajectory trajectory;
  trajectory.model = "top";
  trajectory.method = "rk4";
  trajectory.columns = {{"t", "s", ""}, {"phi", "rad", "phi"}};
  trajectory.rows = {{0, 0.1}, {1, 1.0 / 3}};
  trajectory.energy = {"E - E0", "|T| + |V|", 0.5, 0.25, 2};
  trajectory.momenta = {{"phi", "sum |M v|", 0, 0, 3}};
  return trajectory;
}

}  // namespace

TEST_CASE("a table has a line for each row, in digits that read back") {
  CHECK(to_csv(two_columns()) == "t,phi\n0,0.1\n1,0.3333333333333333\n");
}

TEST_CASE("an object has the rows, what they are, and the drifts") {
  const auto object = nlohmann::json::parse(to_json(two_columns()));
  CHECK(object["model"] == "top");
  CHECK(object["columns"][1]["name"] == "phi");
  CHECK(object["columns"][1]["unit"] == "rad");
  CHECK(object["rows"][1][1] == 1.0 / 3);
  CHECK(object["energy"]["worst"] == 0.5);
  CHECK(object["momenta"][0]["name"] == "phi");
}
