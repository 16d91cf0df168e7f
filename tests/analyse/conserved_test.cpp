// A page of symmetries ends with [[expect]] lines. Pasted into the model, these lines are proved;
// lines with the sign of the gauge function F reversed are refused. A run conserves the integrals.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "analyse/symmetries_testing.hpp"
#include "elgen/simulate.hpp"
#include "verify/structure/expectations.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string with_pasted_integrals(const FoundSymmetries& found) {
  const std::string page = found.page();
  const std::size_t end = page.find("[[expect]]");
  INFO(page);
  REQUIRE(end != std::string::npos);
  return ending(found.text(), page.substr(end));
}

/// The report on the [[expect]] tables of the model `text`, as `elgen verify` computes it.
ExpectationReport expectations_of(const std::string& text) {
  Products products = derived(inputs_of(text), "forward_dynamics,momentum,energy_function");
  REQUIRE(products.closed_forms);
  const auto& [model, scene] = *products.checked;
  return check_expectations({model, scene, *products.program}, &*products.closed_forms, 1);
}

/// A line for each model whose page lists too few integrals, and for each unproved integral.
std::string unproved_integrals(const std::vector<std::string>& models) {
  std::string lines;
  for (const std::string& model : models) {
    const FoundSymmetries found(symmetric_model(model));
    const ExpectationReport report = expectations_of(with_pasted_integrals(found));
    if (report.rows.size() != found.all().size()) {
      lines += fmt::format("{}: {} of {}\n", model, report.rows.size(), found.all().size());
    }
    for (const CertificateRow& row : report.rows) {
      if (row.evidence != Evidence::proof) lines += fmt::format("{}: {}\n", model, row.formula);
    }
  }
  return lines;
}

bool all_are_proved(const ExpectationReport& report) {
  return std::ranges::all_of(report.rows, [](const CertificateRow& row) {
    return row.evidence == Evidence::proof && row.verdict == Verdict::holds;
  });
}

/// For each symmetry with F != 0: `integral` + F, which is not conserved (I = `integral` - F is).
std::vector<std::string> negated_integrals(const FoundSymmetries& found) {
  std::vector<std::string> result;
  const nlohmann::json page = found.json();
  for (const nlohmann::json& row : page.at("symmetries")) {
    const std::string total = row.at("F").get<std::string>();
    if (total == "0") continue;
    result.push_back(row.at("integral").get<std::string>() + " + (" + total + ")");
  }
  return result;
}

std::string expecting_conserved(const std::vector<std::string>& entries) {
  return fmt::format("[[expect]]\nconserved = [\"{}\"]\n", fmt::join(entries, "\", \""));
}

Trajectory run_of(const std::string& text, const Model& model) {
  const Products products = derived(inputs_of(text), outputs_for_run(model));
  const Result<Trajectory> run =
      simulate(*products.checked, *products.program, nullptr, {.duration = 5, .tolerance = 1e-11});
  INFO(format(run.diagnostics));
  REQUIRE(run);
  return *run;
}

}  // namespace

TEST_CASE("integrals on the pages of textbook systems are proved after pasting") {
  CHECK(unproved_integrals({"line",
                            "space",
                            "falling",
                            "kepler_plane",
                            "spring_in_space",
                            "gravity_in_space",
                            "magnetic_symmetric_gauge",
                            "magnetic_landau_gauge",
                            "foucault_whole_omega",
                            "foucault_whole_omega_frames",
                            "travelling_wave",
                            "travelling_wave_numbers",
                            "growing_mass",
                            "accelerated_lift",
                            "open_central",
                            "open_space",
                            "open_distance_in_x_y_z",
                            "growing_oscillator",
                            "accelerated_wave",
                            "turning_trough",
                            "helix_in_cylinder",
                            "two_equal_springs",
                            "two_unequal_masses",
                            "unequal_at_special_values",
                            "free_in_polar",
                            "free_in_plane",
                            "pushed_by_time",
                            "gauge_of_time",
                            "fading_push"}) == "");
}

TEST_CASE("integrals on the pages of models are proved after pasting") {
  CHECK(unproved_integrals({"atwood", "cart_pole", "central_force_open", "charged_particle",
                            "foucault_pendulum", "heavy_top", "kepler_cartesian", "kepler_polar",
                            "particle_on_cone", "pendulum_in_lift", "relativistic_particle",
                            "rotating_hoop", "triatomic_molecule", "two_body_plane", "two_link_arm",
                            "two_particles"}) == "");
}

TEST_CASE("the page of a rotating body lists only integrals that the model language can express") {
  // Rotations about axes of the world have integrals in components of the quaternion, and the model
  // language has no names for these components.
  for (const auto& [model, listed] : {std::pair{"free_body_abc", 8}, std::pair{"free_body_aac", 9},
                                      std::pair{"free_body_aaa", 11}}) {
    INFO(model);
    const ExpectationReport report =
        expectations_of(with_pasted_integrals(FoundSymmetries(symmetric_model(model))));
    CHECK(report.rows.size() == static_cast<std::size_t>(listed));
    CHECK(all_are_proved(report));
  }
}

TEST_CASE("a page lists no integral that needs special values of the parameters") {
  const FoundSymmetries found(replaced(symmetric_model("free_body_abc"), "0.03,", "0.02,"));
  CHECK(found.all().size() == 12);
  const ExpectationReport report = expectations_of(with_pasted_integrals(found));
  CHECK(report.rows.size() == 8);
  CHECK(report.diagnostics.empty());
  CHECK(all_are_proved(report));
}

TEST_CASE("if a model declares a name E, the page calls the energy energy_function") {
  const FoundSymmetries beam(model_text("beam", R"toml([[coordinate]]
name = "x"
[parameters]
m = { value = 2, assume = "positive" }
E = { value = 5, assume = "positive" }
[energy]
T = "1/2*m*dot(x)^2"
V = "1/2*E*x^2"
)toml"));
  CHECK(beam.json().at("conserved") == nlohmann::json::array({"energy_function"}));
  CHECK(mentions(beam.page(), "\n  conserved = [\"energy_function\"]\n"));
  const ExpectationReport report = expectations_of(with_pasted_integrals(beam));
  CHECK(report.rows.size() == 1);
  CHECK(all_are_proved(report));
}

TEST_CASE("an integral with the wrong sign of F is refused") {
  for (const char* const model :
       {"falling", "cart_pole", "magnetic_symmetric_gauge", "magnetic_landau_gauge",
        "accelerated_lift", "accelerated_wave", "charged_particle", "gauge_of_time",
        "pushed_by_time", "two_body"}) {
    const FoundSymmetries found(symmetric_model(model));
    const std::vector<std::string> entries = negated_integrals(found);
    INFO(model << ": " << fmt::format("{}", fmt::join(entries, ", ")));
    REQUIRE_FALSE(entries.empty());
    const ExpectationReport report =
        expectations_of(ending(found.text(), expecting_conserved(entries)));
    CHECK(report.diagnostics.size() == entries.size());
    for (const Diagnostic& diagnostic : report.diagnostics) CHECK(diagnostic.code == Code::E510);
  }
}

TEST_CASE("a run conserves every integral to its tolerance") {
  for (const char* const model :
       {"cart_pole", "charged_particle", "two_body_plane", "falling", "accelerated_lift",
        "growing_mass", "magnetic_landau_gauge", "heavy_top", "turning_trough", "fading_push"}) {
    INFO(model);
    const FoundSymmetries found(symmetric_model(model));
    const Trajectory run = run_of(with_pasted_integrals(found), found.checked().model);
    CHECK(run.conserved.size() == found.all().size());
    for (const ConservedDrift& kept : run.conserved) {
      INFO(kept.text);
      CHECK(kept.drift <= 1e-9 * (1 + std::abs(kept.start)));
    }
  }
}

TEST_CASE("a run does not conserve an integral without its F or with the wrong sign of F") {
  const FoundSymmetries found(symmetric_model("falling"));
  std::vector<std::string> entries = negated_integrals(found);
  entries.emplace_back("p(z)");
  const Trajectory run =
      run_of(ending(found.text(), expecting_conserved(entries)), found.checked().model);
  REQUIRE(run.conserved.size() == entries.size());
  for (const ConservedDrift& lost : run.conserved) {
    INFO(lost.text);
    CHECK(lost.drift > 1);
  }
}
