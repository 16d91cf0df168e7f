// Sixty systems whose equilibria were counted by an independent search or by hand. The number found
// and the completeness claimed must not change. The limits are counts, so that the result does not
// depend on the speed of the machine.
#include <array>
#include <string_view>

#include "analyse/found.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

struct ExpectedCount {
  std::string_view system;  ///< name of a model, or V of a point mass of 1 kg
  std::size_t count = 0;
  Completeness completeness = Completeness::proved;
};

constexpr auto models = std::to_array<ExpectedCount>({
    {"acrobot", 4},          {"arm_with_sensor", 1},
    {"atwood", 0},           {"bead_on_circle", 2},
    {"cart_pole", 2},        {"chain", 32},
    {"charged_particle", 0}, {"double_pendulum", 4},
    {"elastic_pendulum", 2}, {"foucault_pendulum", 1},
    {"free_body", 0},        {"free_particle", 1},
    {"furuta_pendulum", 2},  {"heavy_top", 0},
    {"kepler_polar", 0},     {"motor_pendulum", 2},
    {"particle_on_cone", 0}, {"pendulum_in_lift", 2},
    {"quadrotor", 0},        {"relativistic_particle", 0},
    {"rotary_link", 2},      {"rotating_hoop", 4},
    {"simple_pendulum", 2},  {"spherical_pendulum", 0},
    {"swinging_atwood", 0},  {"triatomic_molecule", 1},
    {"triple_pendulum", 8},  {"two_link_arm", 4},
    {"two_mass_damper", 1},
});

/// The letters of `kinds` are the kinds of x, y and z: L is a length in [-2, 2], A is an angle.
struct PotentialRow {
  std::string_view kinds;
  ExpectedCount counted;
};

constexpr auto potentials = std::to_array<PotentialRow>({
    {"L", {"x^2", 1}},
    {"L", {"x^4 - x^2", 3}},
    {"L", {"x^3", 1}},
    {"L", {"x^6 - 3*x^4 + 2*x^2", 5}},
    {"L", {"exp(x) - x", 1}},
    {"L", {"sqrt(x^2 + 1) - x/2", 1}},
    {"L", {"x^5/5 - x", 2}},
    {"L", {"1/(x^2 + 1) + x^2/4", 3}},
    {"L", {"tanh(3*x) - x", 2}},
    {"L", {"x^2*exp(-x^2)", 3}},
    {"A", {"cos(x)", 2}},
    {"A", {"cos(2*x) + cos(x)/2", 4}},
    {"A", {"cos(3*x) + 0.3*sin(x)", 6}},
    {"A", {"sin(x)^4", 4}},
    {"A", {"exp(cos(2*x))", 4}},
    {"A", {"atan(2*sin(x))", 2}},
    {"A", {"(1 + sin(x))^2", 2}},
    {"LL", {"(x^2 - 1)^2 + (y^2 - 1)^2 + x*y/4", 9}},
    {"LL", {"x^2 + y^2", 1}},
    {"LL", {"(x^2 + y - 1)^2 + (x + y^2 - 1)^2", 7}},
    {"LL", {"x^3 - 3*x*y^2 + (x^2 + y^2)^2/4", 1, Completeness::undecided}},
    {"LL", {"(x - y)^2 + cos(3*x) + cos(3*y)", 9}},
    {"LL", {"-1/sqrt((x - 1)^2 + y^2 + 0.04) - 1/sqrt((x + 1)^2 + y^2 + 0.04) + (x^2 + y^2)/5", 3}},
    {"AA", {"cos(x) + cos(y) + cos(x - y)/3", 4}},
    {"AA", {"cos(x) + 2*cos(y)", 4}},
    {"AA", {"cos(x)*cos(y) + sin(x)/4", 8}},
    {"AL", {"y^4 - y^2 + y*cos(x)", 4}},
    {"AL", {"(y - 1)^2 + y*cos(x)", 2}},
    {"LLL",
     {"(x - y)^2 + (y - z)^2 + x^4 - x^2 + y^4 - y^2 + z^4 - z^2", 3, Completeness::undecided}},
    {"AAA", {"cos(x) + cos(y) + cos(z) + cos(x - y)/4 + cos(y - z)/4", 8}},
});

std::string model_of(const PotentialRow& potential) {
  std::string coordinates;
  for (std::size_t i = 0; i < potential.kinds.size(); ++i) {
    coordinates += coordinate(std::string(1, "xyz"[i]), potential.kinds[i] == 'L' ? "[-2, 2]" : "");
  }
  return potential_model(coordinates, std::string(potential.counted.system));
}

void expect(const std::string& text, const ExpectedCount& counted) {
  INFO(counted.system);
  const Equilibria found = analyse_model(text).equilibria;
  CHECK(found.points.size() == counted.count);
  CHECK(found.completeness == counted.completeness);
  CHECK(found.limit.empty());
}

/// A bob on a spring over magnets at 0, 120 and 240 degrees. Newton's method from 1681 starts on a
/// grid finds 7 equilibria.
const std::string three_magnets = R"toml(format = 1
[model]
name = "magnets"
[[coordinate]]
name = "x"
range = [-2, 2]
[[coordinate]]
name = "y"
range = [-2, 2]
[parameters]
k = { value = 0.4, assume = "positive" }
c = { value = 0.9, assume = "positive" }
d = { value = 0.2, assume = "positive" }
R = { value = 1, assume = "positive" }
[[point]]
name = "bob"
at = ["x", "y"]
mass = 1
[[point]]
name = "a"
at = ["R", "0"]
[[point]]
name = "b"
at = ["-R/2", "R*sqrt(3)/2"]
[[point]]
name = "e"
at = ["-R/2", "-R*sqrt(3)/2"]
[energy]
V = "1/2*k*(x^2 + y^2) - c/sqrt(dist2(bob, a) + d^2) - c/sqrt(dist2(bob, b) + d^2) - c/sqrt(dist2(bob, e) + d^2)"
)toml";

static_assert(models.size() + potentials.size() + 1 == 60);

}  // namespace

TEST_CASE("all equilibria of models are found") {
  for (const ExpectedCount& model : models) expect(model_file(std::string(model.system)), model);
}

TEST_CASE("all equilibria of potentials are found") {
  for (const PotentialRow& potential : potentials) expect(model_of(potential), potential.counted);
}

TEST_CASE("all seven equilibria over three magnets are found and proved") {
  expect(three_magnets, {"three magnets", 7});
}
