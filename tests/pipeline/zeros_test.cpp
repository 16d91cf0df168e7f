// Entries that are identically zero are emitted as 0. Zeros that are sampled but not proved are
// reported.
#include <catch2/catch.hpp>
#include <regex>

#include "pipeline/pipeline_testing.hpp"

namespace elgen::test {
namespace {

/// Prints the largest |x| of entries that are zero on paper.
constexpr const char* furuta = R"cpp(
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "furuta_pendulum/furuta_pendulum.hpp"

  int main() {
    const furuta_pendulum::Parameters<double> p;
    double largest = 0;
    for (int i = 0; i < 100; ++i) {
      const double x = 0.1 * i;
      // Nothing depends on the angle of the arm: columns 1 of A, and of da/dq.
      const auto f = furuta_pendulum::linearization(p, {x, 3 - x}, {2 * x, 5 - x}, {x});
      const auto d =
          furuta_pendulum::forward_dynamics_derivatives(p, {x, 3 - x}, {2 * x, 5 - x}, {x});
      largest = std::max({largest, std::abs(f.A[8]), std::abs(f.A[12]), std::abs(d.by_position[0]),
                          std::abs(d.by_position[2])});
    }
    std::printf("%g", largest);
  }
)cpp";

/// Prints the largest diagonal entry of C, which is 0 on paper, and an entry that is not 0.
constexpr const char* chain = R"cpp(
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "chain/chain.hpp"

  int main() {
    double largest = 0;
    const auto c = chain::coriolis_matrix(chain::Parameters<double>{}, {0.1, 0.7, -2, 1.5, 3},
                                          {1, -2, 3, 5, 7});
    for (int i = 0; i < 5; ++i) largest = std::max(largest, std::abs(c[6 * i]));
    std::printf("%g %g", largest, c[1]);
  }
)cpp";

/// M is constant, so C v = 0. The v^2 terms cancel only through cos(0.7), cos(0.5) and sqrt(2)/2.
constexpr const char* tilted = R"toml(format = 1
[model]
name = "tilted"
[[coordinate]]
name = "q"
[parameters]
p4 = 0.3
m = 0.25
[[frame]]
name = "mount"
parent = "world"
rpy = ["-0.7", "0.5", "0.5"]
[[frame]]
name = "link"
parent = "mount"
rotate = [[["1", "1", "0"], "q"]]
[[body]]
name = "stone"
frame = "link"
mass = "m"
inertia = ["0.01", "0.02", "0.03"]
com = ["-0.43", "p4", "0.25"]
[gravity]
vector = ["0", "0", "-9.81"]
)toml";

/// Prints C v and C at a rate with 1e-17 v^2 = 10.
constexpr const char* fast = R"cpp(
#include <cstdio>

#include "out/tilted/tilted.hpp"

  int main() {
    const tilted::Parameters<double> p;
    std::printf("%g %g", tilted::velocity_force(p, {0.4}, {1e9})[0],
                tilted::coriolis_matrix(p, {0.4}, {1e9})[0]);
  }
)cpp";

/// Prints for each model and state 1 if M is regular, and 0 if a diagonal entry of M vanishes.
constexpr const char* regular = R"cpp(
#include <cstdio>

#include "cart_pole/cart_pole.hpp"
#include "kepler_polar/kepler_polar.hpp"

  bool cart(double l) {
    cart_pole::Parameters<double> p;
    p.l = l;
    return cart_pole::is_regular(
        cart_pole::forward_dynamics(p, {0, 0.3}, {0, 0}, {1}).relative_pivots);
  }

  bool orbit(float r) {
    return kepler_polar::is_regular(
        kepler_polar::forward_dynamics<float>({}, {r, 1}, {0, 1}, {}).relative_pivots);
  }

  int main() { std::printf("%d%d%d %d%d", cart(1), cart(1e-100), cart(0), orbit(2), orbit(0)); }
)cpp";

/// Multiplies the parameter c2 of an arm by 10^k, k = 0 ... 9. For each k prints at how many of
/// 2000 states digits_left > 0 and accelerations have a relative error above 20 * 10^-digits_left.
/// For k = 8 prints whether more than 1600 regular states have an error above 1 %, and whether
/// digits_left < 2 at all states with this error. Then prints digits_left for the pivots (1, NaN),
/// (1, 0) and (1, 200 epsilon).
constexpr const char* digits = R"cpp(
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "two_link_arm/two_link_arm.hpp"

  namespace arm = two_link_arm;

  double drawn(double largest) {
    static std::uint64_t state = 1;
    state = state * 6364136223846793005U + 1442695040888963407U;
    return largest * (static_cast<double>(state >> 11) / 4503599627370496.0 - 1);
  }

  /// Twice the digits of a double, or more.
  arm::Parameters<long double> widened(const arm::Parameters<double>& p) {
    return {p.m1, p.m2, p.l1, p.c1, p.c2, p.I1, p.I2, p.g};
  }

  int main() {
    arm::Parameters<double> p;
    int wrong = 0;
    double most = 0;
    for (int k = 0; k < 10; ++k, p.c2 *= 10) {
      int beyond = 0;
      for (int i = 0; i < 2000; ++i) {
        const double q[] = {drawn(3), drawn(3)}, v[] = {drawn(8), drawn(8)};
        const auto fast = arm::forward_dynamics(p, {q[0], q[1]}, {v[0], v[1]}, {0, 0});
        const auto slow =
            arm::forward_dynamics<long double>(widened(p), {q[0], q[1]}, {v[0], v[1]}, {0, 0});
        long double error = 0, size = 0;
        for (int j = 0; j < 2; ++j) {
          error = std::max(error, std::abs(fast.acceleration[j] - slow.acceleration[j]));
          size = std::max(size, std::abs(slow.acceleration[j]));
        }
        const double left = arm::digits_left(fast.relative_pivots);
        beyond += left > 0 && error > 20 * std::pow(10, -left) * size;
        if (k == 8 && arm::is_regular(fast.relative_pivots) && error > 0.01 * size) {
          ++wrong;
          most = std::max(most, left);
        }
      }
      std::printf("%d ", beyond);
    }
    std::printf("%d %d", wrong > 1600, most < 2);
    std::printf(" %g %g %.0f", arm::digits_left<double>({1, NAN}), arm::digits_left<double>({1, 0}),
                arm::digits_left<double>({1, 200 * 2.220446049250313e-16}));
  }
)cpp";

/// Prints how the speed of the cart changes the accelerations of an expanded cart and pole.
constexpr const char* expanded = R"cpp(
#include <cstdio>

#include "out/cart_pole_near/cart_pole_near.hpp"

  int main() {
    const cart_pole_near::Parameters<double> p;
    const auto slow = cart_pole_near::forward_dynamics(p, {0, 0.3}, {0, 1}, {1}).acceleration;
    const auto fast = cart_pole_near::forward_dynamics(p, {0, 0.3}, {1e10, 1}, {1}).acceleration;
    std::printf("%g %g", slow[0] - fast[0], slow[1] - fast[1]);
  }
)cpp";

}  // namespace

TEST_CASE("derivatives by a cyclic coordinate are 0 in emitted code") {
  const Workspace folder;
  CHECK(printed(folder, furuta) == "0");
}

TEST_CASE("vanishing entries of C are 0 in emitted code") {
  const Workspace folder;
  const std::string output = printed(folder, chain);
  CAPTURE(output);
  CHECK(starts_with(output, "0 "));
  CHECK(output != "0 0");
}

TEST_CASE("M with a vanishing diagonal entry is singular") {
  const Workspace folder;
  CHECK(printed(folder, regular) == "110 10");
}

TEST_CASE("digits_left bounds the digits of accelerations if is_regular is true") {
  const Workspace folder;
  // Up to k = 2, cancelling forces lose more digits than M at a few states.
  CHECK_THAT(printed(folder, digits), Catch::Matches("[0-3] [0-3] [0-3] 0 0 0 0 0 0 0 1 1 0 0 2"));
}

TEST_CASE("terms that cancel only through irrational constants leave no noise") {
  const Workspace folder;
  folder.write("tilted.toml", tilted);
  const Outcome generated = folder.run("elgen generate -o out --fix m tilted.toml");
  CAPTURE(generated.errors);
  REQUIRE(generated.status == 0);
  CHECK(printed(folder, fast) == "0 0");
  const Outcome shown = folder.run("elgen show --fix m --what velocity_force,bias tilted.toml");
  CHECK(mentions(shown.output, "velocity_force = 0\n"));
  CHECK_FALSE(mentions(shown.output, "dot(q)^2"));
  CHECK(folder.run("elgen verify --build written --samples 16 tilted.toml").status == 0);
}

TEST_CASE("a term that cancels in a neighbouring sum leaves no rounding error") {
  const Workspace folder;
  const std::string model = std::string(ELGEN_SOURCE_DIR) + "/models/cart_pole.toml";
  folder.write("near.scene.toml", "format = 1\nmodel = '" + model +
                                      "'\nname = 'near'\n[outputs]\nforward_dynamics = true\n"
                                      "[approximate]\norder = 3\nabout = { x = 0, theta = 0 }\n");
  REQUIRE(folder.run("elgen generate -o out near.scene.toml").status == 0);
  CHECK(printed(folder, expanded) == "0 0");
  // Far from the expansion point the expanded M is indefinite, with pivots of 1e29.
  CHECK(folder.run("elgen verify --quick --samples 64 near.scene.toml").status == 0);
}

TEST_CASE("generate and verify report zeros that are sampled and not proved") {
  const Workspace folder;
  const std::string model = std::string(ELGEN_SOURCE_DIR) + "/models/furuta_pendulum.toml";
  const Outcome generated = folder.run("elgen generate -o out '" + model + "'");
  CHECK(generated.status == 0);
  CHECK(mentions(generated.errors, " rely on zeros sampled at 64 points, not proved"));
  const Outcome verified = folder.run("elgen verify --quick '" + model + "'");
  CHECK(verified.status == 0);
  CHECK(std::regex_search(verified.output,
                          std::regex("holds    linearization .*, relies on unproved zeros\n")));
  CHECK(std::regex_search(folder.run("elgen verify -v --quick '" + model + "'").output,
                          std::regex("in entries [0-9, ]+")));
}

}  // namespace elgen::test
