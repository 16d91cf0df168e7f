// JSON that says something else than what was derived is refused.
#include <catch2/catch.hpp>

#include "changes.hpp"

namespace elgen {

using test::Change;
using test::cpp;
using test::expect_refused;

TEST_CASE("a sidecar that says something else is refused") {
  const std::string json = ".equations.json";
  for (const Change& change : std::vector<Change>{
           {cpp(), json, "\"mass_matrix\"", "\"m*l^2\"", "\"m*l\"", "`mass_matrix`: `m*l`"},
           {cpp(), json, "\"mass_matrix\"", "\"M + m\"", "\"M - m\"", "`M - m`"},
           {cpp(), json, "\"mass_matrix\"", "\"M + m\", ", "", "a list of 4"},
           {cpp(), json, "\"mass_matrix\"", "\"M + m\"", "\"M + mm\"", "no name of the model"},
           {cpp(), json, "\"mass_matrix\"", "\"M + m\"", "\"M + m)\"", "`mass_matrix`"},
           {cpp(), json, "\"coriolis_matrix\"", "[2, 2]", "[2, 3]", "[2,3] instead of [2,2]"},
           {cpp(), json, "\"gravity\"", "\"mul\": 3", "\"mul\": 4", "4 instead of 3"},
           {cpp(), json, "\"name\": \"g\"", "9.81", "9.82", "`9.82` is not 9.81"},
           {cpp(), json, "\"name\": \"g\"", "m/s^2", "m/s", "instead of"},
           {cpp(), json, "\"name\": \"theta\"", "theta", "phi", "instead of"},
           {cpp(), json, "\"gravity\"", "\"gravity\"", "\"weight\"", "`gravity` is missing"},
           {cpp(), json, "\"format\"", ": 1", ": 2", "2 instead of 1"},
           {cpp(), json, "\"format\"", ": 1,", ": 1", "no JSON"}}) {
    expect_refused(change);
  }
}

TEST_CASE("a sidecar that leaves out something else is refused") {
  const test::Written all = test::written(
      "format = 1\n[model]\nname = \"slider\"\n[[coordinate]]\nname = \"x\"\n"
      "[energy]\nT = \"dot(x)^2\"\n[[force]]\non = \"x\"\nvalue = \"-sign(dot(x))\"\n");
  const std::string json = ".equations.json";
  for (const Change& change : std::vector<Change>{
           {all, json, "\"left_out\"", "\"left_out\"", "\"missing\"", "`left_out` is missing"},
           {all, json, "\"left_out\"", "kinked force", "too many entries", "instead of"},
           {all, json, "\"left_out\"", "\"linearization\"", "\"bias\"", "is missing"}}) {
    expect_refused(change);
  }
}

}  // namespace elgen
