// The report of what was dropped.
#include <catch2/catch.hpp>

#include "elgen/drop.hpp"
#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;
using cln::cl_RA;

namespace {

Model slider() {
  return checked_model(model_text("slider", R"toml([[coordinate]]
name = "x"
unit = "m"
[parameters]
m = { value = 1, unit = "kg" }
[energy]
T = "1/2*m*dot(x)^2"
)toml"))
      .model;
}

Program reduced() {
  Program program;
  program.reduction =
      Reduction{cl_RA(1) / 100,
                {{OutputKind::mass_matrix, 0, 0, "m*cos(x)", cl_RA(1) / 3000}},
                {{OutputKind::mass_matrix, 1, {{cl_RA(1) / 3000, {}, cl_RA(2)}}},
                 {OutputKind::inverse_dynamics, 1, {{cl_RA(1999) / 1000, {cl_RA(1) / 3000}, {}}}},
                 {OutputKind::kinetic_energy, 1, {{0, {}, {}}}}}};
  return program;
}

}  // namespace

TEST_CASE("every term, and what entries are off by, rounded up") {
  CHECK(dropped_page(slider(), reduced()) ==
        "Approximate: 1 term below 0.01 of the largest of their entry left out. Within the "
        "declared ranges an entry is off by at most 0.000167 of what its largest term can be, and "
        "inverse_dynamics by shares of the accelerations as well.\n"
        "\n"
        "entry             dropped term  at most\n"
        "mass_matrix[1,1]  m*cos(x)      0.000334 kg\n"
        "\n"
        "entry                off by at most\n"
        "mass_matrix[1,1]     0.000334 kg, 0.000167 of its largest term's bound\n"
        "inverse_dynamics[1]  2 N + 0.000334 kg |a[1]|\n");
}

TEST_CASE("an exact program says nothing") {
  CHECK(dropped_summary({}).empty());
  CHECK(dropped_page(slider(), {}) == "nothing is dropped: no `drop_below` in a scene\n");
  Program program;
  program.reduction = Reduction{cl_RA(1) / 100, {}, {}};
  CHECK(dropped_page(slider(), program) == "No term is below 0.01 of its entry.\n");
}
