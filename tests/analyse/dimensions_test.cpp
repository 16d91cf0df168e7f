// The number of independent symmetries is as expected, and closed forms and samples give the same
// number.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "analyse/symmetries_testing.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

struct Dimension {
  const char* model;
  std::size_t count = 0;
  std::vector<std::string> fixed = {};
};

/// Each model with its number of symmetries: counted by hand, and computed by an independent
/// program as the dimension of the null space of the symmetry conditions.
std::vector<Dimension> dimensions() {
  return {
      {"line", 3},
      {"space", 10},
      {"falling", 5},
      {"kepler_plane", 2},
      {"spring_in_space", 13},
      {"gravity_in_space", 13},
      {"magnetic_symmetric_gauge", 4},
      {"magnetic_landau_gauge", 4},
      {"foucault_whole_omega", 1},
      {"foucault_whole_omega", 2, {"latitude=pi/2"}},
      {"foucault_whole_omega", 2, {"Omega=0"}},
      {"foucault_whole_omega_frames", 1},
      {"travelling_wave", 1},
      {"travelling_wave_numbers", 1},
      {"growing_mass", 2},
      {"shaken_lift", 0},
      {"accelerated_lift", 1},
      {"free_body_abc", 11},
      {"free_body_aac", 12},
      {"free_body_aaa", 14},
      {"open_central", 2},
      {"open_space", 1},
      {"open_distance_in_x_y_z", 4},
      {"growing_oscillator", 1},
      {"accelerated_wave", 1},
      {"turning_trough", 1},
      {"helix_in_cylinder", 2},
      {"two_equal_springs", 2},
      {"two_unequal_masses", 2},
      {"unequal_at_special_values", 1},
      {"free_in_polar", 2},
      {"free_in_plane", 6},
      {"pushed_by_time", 2},
      {"gauge_of_time", 3},
      {"fading_push", 2},
  };
}

std::vector<Dimension> dimensions_of_models() {
  return {
      {"atwood", 3},
      {"body_on_springs", 1},
      {"cart_pole", 3},
      {"cart_pole", 3, {"g=0"}},
      {"central_force_open", 2},
      {"chain", 1},
      {"charged_particle", 6},
      {"double_pendulum", 1},
      {"double_pendulum", 2, {"g=0"}},
      {"foucault_pendulum", 2},
      {"free_body", 11},
      {"free_body", 12, {"A=0.02", "B=0.02"}},
      {"free_body", 14, {"A=0.02", "B=0.02", "C=0.02"}},
      {"free_particle", 10},
      {"furuta_pendulum", 2},
      {"heavy_top", 3},
      {"kepler_cartesian", 4},
      {"kepler_polar", 2},
      {"motor_pendulum", 1},
      {"panda7", 2},
      {"particle_in_potential", 1},
      {"particle_on_cone", 2},
      {"pendulum_in_lift", 1},
      {"quadrotor", 12},
      {"relativistic_particle", 2},
      {"rotating_hoop", 1},
      {"spherical_pendulum", 2},
      {"triatomic_molecule", 3},
      {"two_body", 3},
      {"two_body_plane", 7},
      {"two_mass_damper", 1},
      {"two_particles", 13},
  };
}

std::string name_of_row(const Dimension& row) {
  return fmt::format("{} {}", row.model, fmt::join(row.fixed, " "));
}

/// A line for each row whose number of symmetries is not `count`, and a line for each row with an
/// unproved symmetry. panda7 has no closed forms: its row gets a line if all symmetries are proved.
std::string differing_rows(const std::vector<Dimension>& rows) {
  std::string lines;
  for (const Dimension& row : rows) {
    const FoundSymmetries found(symmetric_model(row.model), row.fixed);
    if (found.all().size() != row.count) {
      lines +=
          fmt::format("{}: {} instead of {}\n", name_of_row(row), found.all().size(), row.count);
    }
    const bool are_proved = std::ranges::all_of(found.all(), &Symmetry::is_proved);
    if (are_proved == (std::string(row.model) == "panda7")) {
      lines += fmt::format("{}: proved is {}\n", name_of_row(row), are_proved);
    }
  }
  return lines;
}

}  // namespace

TEST_CASE("textbook systems have the expected number of symmetries, all proved") {
  CHECK(differing_rows(dimensions()) == "");
}

TEST_CASE("models have the expected number of symmetries, all proved if there are closed forms") {
  CHECK(differing_rows(dimensions_of_models()) == "");
}

TEST_CASE("closed forms and samples find the same number of symmetries") {
  std::vector<std::filesystem::path> paths = model_paths();
  const auto more = files_in(ELGEN_SOURCE_DIR "/tests/analyse/symmetries", ".toml");
  paths.insert(paths.end(), more.begin(), more.end());
  std::string lines;
  std::size_t exact = 0;
  for (const std::filesystem::path& path : paths) {
    const std::string name = path.stem();
    if (mentions(symmetric_model(name), "[[constraint]]")) continue;  // refused with E539
    const FoundSymmetries of_model(symmetric_model(name));
    const Symmetries& found = of_model.found();
    exact += found.is_exact ? 1 : 0;
    // ur5 and unequal_at_special_values have an additional symmetry at the values of their
    // parameters; in ur5 the wrist has equal inertias.
    const std::size_t special = name == "ur5" || name == "unequal_at_special_values" ? 1 : 0;
    if (found.states > 0 && found.sampled == found.symmetries.size() + special) continue;
    lines += fmt::format("{}: {}, {} of {} states\n", name, found.symmetries.size(), found.sampled,
                         found.states);
  }
  CHECK(lines == "");
  CHECK(exact >= 60);
}

TEST_CASE("a symmetry at special values of the parameters is counted, but not listed") {
  const FoundSymmetries special(symmetric_model("unequal_at_special_values"));
  CHECK(special.found().is_exact);
  CHECK(special.found().is_complete);
  CHECK(special.all().size() == 1);
  CHECK(special.all()[0].kind == SymmetryKind::time);
  CHECK(special.found().sampled == 2);
  const FoundSymmetries equal(symmetric_model("unequal_at_special_values"), {"kx=5", "ky=5"});
  CHECK(equal.all().size() == 2);
  CHECK(equal.found().sampled == 2);
}

TEST_CASE("a class with too many unknowns is refused") {
  const Products products = run_pipeline(
      inputs_of(model_file("chain")),
      {.scene = {.sizes = {make_source("--size", "n=31")}}, .goals = {Goal::symmetries}});
  CHECK_FALSE(products.symmetries);
  REQUIRE(has_errors(products.diagnostics));
  CHECK(products.diagnostics.back().code == Code::E910);
  CHECK(products.diagnostics.back().message ==
        "symmetries of 31 velocities have 1024 unknowns, more than 500");
}
