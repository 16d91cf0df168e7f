// Sidecars as versions: what they say, and what is none.
#include <catch2/catch.hpp>

#include "diff/versions.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// The sidecar that is written of a model.
std::string sidecar_of(const std::string& text, const std::string& scene = {}) {
  const Lowered version = lowered(text, scene, "emit");
  for (const auto& [path, content] : version.products.files->files) {
    if (path.ends_with(".equations.json")) return content;
  }
  return {};
}

SystemChange compared_sidecars(const std::string& before, const std::string& after) {
  static std::vector<SourcePointer> sources;
  sources.push_back(make_source("old.equations.json", before));
  const Result<SidecarVersion> old = parse_sidecar(sources.back());
  sources.push_back(make_source("new.equations.json", after));
  const Result<SidecarVersion> now = parse_sidecar(sources.back());
  INFO(format(old.diagnostics) + format(now.diagnostics));
  REQUIRE((old && now));
  return compare(old->version(), now->version());
}

std::string problem(const std::string& text) {
  return parse_sidecar(make_source("x.equations.json", text)).diagnostics.at(0).message;
}

}  // namespace

TEST_CASE("the sidecar of every model reads back, and is what it was") {
  for (const char* const name : {"cart_pole", "double_pendulum", "chain", "free_body", "heavy_top",
                                 "rotating_hoop", "motor_pendulum", "atwood"}) {
    INFO(name);
    const std::string sidecar = sidecar_of(model_of(name));
    CHECK(compared_sidecars(sidecar, sidecar).impact == Impact::none);
    const SystemChange hashes =
        compared_sidecars(sidecar, edited(sidecar, "\"body\": \"", "\"body\": \"0"));
    CHECK(hashes.impact == Impact::text);
  }
}

TEST_CASE("what a sidecar says of a change is what the models say") {
  const std::string turned = edited(cart, "\"-g\"", "\"g\"");
  const SystemChange models = compared(cart, turned);
  const SystemChange sidecars = compared_sidecars(sidecar_of(cart), sidecar_of(turned));
  CHECK(sidecars.impact == Impact::different);
  CHECK(sidecars.keys.empty());
  CHECK(entries_of(sidecars, "gravity").size() == entries_of(models, "gravity").size());
  CHECK(entries_of(sidecars, "gravity").at(0).difference == "2*m*l*g*sin(theta)");
  REQUIRE(sidecars.operations);
  CHECK(sidecars.operations->empty());
}

TEST_CASE("values, units, names and functions of sidecars are compared") {
  const auto impact = [](const std::string& before, const std::string& after) {
    return compared_sidecars(sidecar_of(before), sidecar_of(after)).impact;
  };
  CHECK(impact(spring(), edited(spring(), "k = 3", "k = 4")) == Impact::values);
  CHECK(impact(spring("k*x"), spring("k*x*exp(x)*exp(-x)")) == Impact::equal);
  CHECK(impact(spring(), edited(spring(), "name = \"x\"", "name = \"x\"\nunit = \"1\"")) ==
        Impact::misleading);
  CHECK(impact(spring(), edited(spring("1/2*k*x^2 + c*x^4"), "k = 3", "k = 3\nc = 0")) ==
        Impact::extended);
  CHECK(compared_sidecars(sidecar_of(spring()), sidecar_of(spring(), "[outputs]\ngravity = true\n"))
            .impact == Impact::incompatible);
}

TEST_CASE("a renamed function is the output that it is") {
  const std::string scene = "[outputs]\nmass_matrix = { rename = \"M\" }\n";
  const std::string sidecar = sidecar_of(spring(), scene);
  CHECK(mentions(sidecar, "\"output\": \"mass_matrix\""));
  CHECK(compared_sidecars(sidecar, sidecar).impact == Impact::none);
}

TEST_CASE("rows that stand for nothing known are matched by their numbers") {
  const std::string locked =
      sidecar_of(model_of("two_link_arm"),
                 "[outputs]\nbias = true\n[lock]\nq1 = { value = 0, reaction = true }\n");
  CHECK(compared_sidecars(locked, edited(locked, "\"body\": \"", "\"body\": \"0")).impact ==
        Impact::text);
  const std::string wide =
      edited(sidecar_of(spring()), "\"shape\": [1, 1],\n      \"entries\": [\"m\"]",
             "\"shape\": [1, 2], \"entries\": [\"m\", \"m\"]");
  CHECK(compared_sidecars(wide, edited(wide, "\"body\": \"", "\"body\": \"0")).impact ==
        Impact::text);
}

TEST_CASE("what is no sidecar is told") {
  const std::string lead = "`x.equations.json` is no sidecar of equations: ";
  CHECK(problem("{") == lead + "the text is no JSON");
  CHECK(problem("[]") == lead + "`name` is missing");
  const std::string sidecar = sidecar_of(spring());
  CHECK(problem(edited(sidecar, "\"coordinates\"", "\"coordinate\"")) ==
        lead + "`coordinates` is missing");
  CHECK(problem(edited(sidecar, "\"k*x\"", "\"k*y\"")) == lead + "`y` is not defined");
  CHECK(mentions(problem(edited(sidecar, "\"k*x\"", "\"k*\"")), lead + "`k*`: "));
  CHECK(problem(edited(sidecar, "\"k*x\"", "\"k*x\", \"0\"")) ==
        lead + "`gravity` of 1 x 1 has 2 entries");
}
