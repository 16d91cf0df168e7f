// The benchmark bicycle: its linear equations and eigenvalues against published values.
//
// Meijaard, Papadopoulos, Ruina, Schwab, Proceedings of the Royal Society A 463 (2007), 1955-1982:
//
//     M q'' + v C1 q' + (g K0 + v^2 K2) q = 0,   q = (lean, steer)
//
// with the matrices and eigenvalues of section 5 of the paper.
#include <array>
#include <catch2/catch.hpp>
#include <complex>

#include "pipeline/constrained_testing.hpp"

namespace elgen::test {
namespace {

using Block = std::array<double, 4>;  // 2 x 2, row-major
using Complex = std::complex<double>;

constexpr Block mass{80.81722, 2.31941332208709, 2.31941332208709, 0.29784188199686};
constexpr Block damping{0, 33.86641391492494, -0.85035641456978, 1.68540397397560};
constexpr Block stiffness{-80.95, -2.59951685249872, -2.59951685249872, -0.80329488458618};
constexpr Block centrifugal{0, 76.59734589573222, 0, 2.65431523794604};
constexpr double gravity = 9.81;

/// Indices of velocities, equal to the indices of coordinates.
constexpr std::size_t x = 0;
constexpr std::size_t y = 1;
constexpr std::size_t z = 2;
constexpr std::size_t psi = 3;
constexpr std::size_t phi = 4;
constexpr std::size_t delta = 6;
constexpr std::size_t rear = 7;
constexpr std::size_t front = 8;
constexpr std::size_t count = 9;

Block solved(const Block& m, const Block& b) {
  const double determinant = m[0] * m[3] - m[1] * m[2];
  return {(m[3] * b[0] - m[1] * b[2]) / determinant, (m[3] * b[1] - m[1] * b[3]) / determinant,
          (m[0] * b[2] - m[2] * b[0]) / determinant, (m[0] * b[3] - m[2] * b[1]) / determinant};
}

/// Derivatives of q'' with respect to q and to q', for q = (lean, steer).
struct Linear {
  Block by_position{};
  Block by_rate{};
};

Linear published(double v) {
  Block k{};
  Block c{};
  for (std::size_t i = 0; i < 4; ++i) {
    k[i] = -(gravity * stiffness[i] + v * v * centrifugal[i]);
    c[i] = -v * damping[i];
  }
  return {solved(mass, k), solved(mass, c)};
}

/// The upright bicycle at speed `v` in direction `heading`; `turned` is the angle of both wheels.
State riding(const Constrained& system, double v, double heading, double turned) {
  const auto exact = [](double value) { return cln::cl_R(cln::rational(cln::cl_DF(value))); };
  State state = system.nominal();
  state.q[z] = exact(-0.3);
  state.q[psi] = exact(heading);
  state.q[rear] = state.q[front] = exact(turned);
  state.v[x] = exact(v * std::cos(heading));
  state.v[y] = exact(v * std::sin(heading));
  state.v[rear] = exact(-v / 0.3);
  state.v[front] = exact(-v / 0.35);
  return state;
}

/// The derivatives along perturbations that the wheels allow. The centre of the rear wheel moves
/// sideways with the lean. The yaw rate changes by (v delta + c d(delta)/dt) cos(lambda)/w.
Linear computed(const Constrained& system, double v, double heading, double turned) {
  const State state = riding(system, v, heading, turned);
  const std::vector<double> a = system.double_field(OutputKind::linearization, "A", state);
  const double yawing = std::cos(std::acos(-1.0) / 10) / 1.02;
  const auto response = [&](std::size_t row, std::size_t column, bool is_rate) {
    std::array<double, 2 * count> change{};
    change[is_rate ? count + column : column] = 1;
    const double lean = column == phi ? 0.3 : 0;  // displacement of the centre per rad of lean
    change[(is_rate ? count : 0) + x] = -lean * std::sin(heading);
    change[(is_rate ? count : 0) + y] = lean * std::cos(heading);
    if (column == delta) change[count + psi] = yawing * (is_rate ? 0.08 : v);
    double sum = 0;
    for (std::size_t j = 0; j < 2 * count; ++j) sum += a[(count + row) * 2 * count + j] * change[j];
    return sum;
  };
  Linear result;
  constexpr std::array free{phi, delta};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      result.by_position[2 * i + j] = response(free[i], free[j], false);
      result.by_rate[2 * i + j] = response(free[i], free[j], true);
    }
  }
  return result;
}

void check_same(const Block& found, const Block& expected) {
  const double scale =
      std::abs(*std::max_element(expected.begin(), expected.end(),
                                 [](double a, double b) { return std::abs(a) < std::abs(b); }));
  for (std::size_t i = 0; i < 4; ++i) {
    INFO("entry " << i << ": " << found[i] << " instead of " << expected[i]);
    CHECK(std::abs(found[i] - expected[i]) <= 1e-12 * scale);
  }
}

/// D = det(s^2 I - s C - K) and dD/ds, with C = `by_rate` and K = `by_position`.
std::pair<Complex, Complex> determinant(const Linear& linear, Complex s) {
  const auto& [k, c] = linear;
  const auto entry = [&](std::size_t i) { return (i % 3 == 0 ? s * s : 0.0) - s * c[i] - k[i]; };
  const auto slope = [&](std::size_t i) { return (i % 3 == 0 ? 2.0 * s : 0.0) - c[i]; };
  return {entry(0) * entry(3) - entry(1) * entry(2),
          slope(0) * entry(3) + entry(0) * slope(3) - slope(1) * entry(2) - entry(1) * slope(2)};
}

struct Poles {
  double v = 0;
  std::vector<Complex> values = {};
};

const std::vector<Poles> published_poles{
    {0, {3.13164324790656, -3.13164324790656, 5.53094371765393, -5.53094371765393}},
    {1, {{3.52696170990070, 0.80774027519930}, -3.13423125066578, -7.11008014637442}},
    {3, {{1.70675605663975, 2.31582447384325}, -2.63366137253667, -10.35101467245920}},
    {5, {{-0.77534188219585, 4.46486771378823}, -0.32286642900409, -14.07838969279822}}};

const std::string& bicycle() {
  static const std::string text = model_file("bicycle");
  return text;
}

}  // namespace

TEST_CASE("the bicycle's linear equations are the published equations") {
  const Constrained system(bicycle(), "linearization");
  for (const double v : {0.0, 1.0, 4.6, 10.0}) {
    INFO("v = " << v);
    const Linear expected = published(v);
    const Linear found = computed(system, v, 0, 0);
    check_same(found.by_position, expected.by_position);
    if (v > 0) check_same(found.by_rate, expected.by_rate);
    const Linear elsewhere = computed(system, v, 0.7, 2.5);
    check_same(elsewhere.by_position, expected.by_position);
  }
}

TEST_CASE("the bicycle's eigenvalues are the published eigenvalues") {
  const Constrained system(bicycle(), "linearization");
  for (const auto& [v, poles] : published_poles) {
    const Linear found = computed(system, v, 0, 0);
    for (const Complex& pole : poles) {
      INFO("v = " << v << ", pole " << pole);
      const auto [value, slope] = determinant(found, pole);
      CHECK(std::abs(value / slope) <= 1e-9);  // one step of Newton's method
    }
  }
}

}  // namespace elgen::test
