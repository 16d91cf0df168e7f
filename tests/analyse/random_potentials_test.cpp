// Random potentials of one or two angles and lengths. If the analysis claims completeness, a dense
// search in doubles, which shares no code with the program, must find the same number of
// equilibria.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "analyse/found.hpp"
#include "numbers/random.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

using Place = std::array<double, 2>;

/// V as text, and its gradient derived by hand; `is_angle[i]`: coordinate i is an angle.
struct Potential {
  std::size_t size = 1;
  std::array<bool, 2> is_angle{};
  std::string text = "0";
  std::vector<std::function<Place(const Place&)>> gradients = {};

  [[nodiscard]] Place gradient(const Place& at) const {
    Place sum{};
    for (const auto& term : gradients) {
      const Place part = term(at);
      sum[0] += part[0];
      sum[1] += part[1];
    }
    return sum;
  }
};

constexpr double longest = 2;  ///< lengths are in [-2, 2]

/// Adds c cos(k x + l y) or c sin(k x + l y).
void add_wave(Potential& v, double c, int k, int l, bool is_sine) {
  v.text += fmt::format(" + ({})*{}({}*x + {}*y)", c, is_sine ? "sin" : "cos", k, l);
  v.gradients.push_back([=](const Place& at) {
    const double angle = k * at[0] + l * at[1];
    const double slope = is_sine ? c * std::cos(angle) : -c * std::sin(angle);
    return Place{k * slope, l * slope};
  });
}

/// Adds c x^n or c y^n.
void add_power(Potential& v, double c, int n, std::size_t which) {
  v.text += fmt::format(" + ({})*{}^{}", c, which == 0 ? "x" : "y", n);
  v.gradients.push_back([=](const Place& at) {
    Place slope{};
    slope[which] = c * n * std::pow(at[which], n - 1);
    return slope;
  });
}

/// Adds c y cos(k x).
void add_mixed(Potential& v, double c, int k) {
  v.text += fmt::format(" + ({})*y*cos({}*x)", c, k);
  v.gradients.push_back([=](const Place& at) {
    return Place{-c * k * at[1] * std::sin(k * at[0]), c * std::cos(k * at[0])};
  });
}

double coefficient(Random& random) {
  return static_cast<double>(static_cast<int>(random.next() % 41) - 20) / 8;
}

Potential random_potential(Random& random) {
  Potential v;
  const std::uint64_t kind = random.next() % 4;
  v.is_angle = {kind != 1, kind == 2};
  v.size = kind < 2 ? 1 : 2;
  if (kind == 1) {
    for (int n = 1; n <= 4; ++n) add_power(v, coefficient(random), n, 0);
    return v;
  }
  for (int k = 1; k <= (kind == 0 ? 3 : 1); ++k) {
    add_wave(v, coefficient(random), k, 0, false);
    add_wave(v, coefficient(random), k, 0, true);
  }
  if (kind == 2) {
    add_wave(v, coefficient(random), 0, 1, false);
    add_wave(v, coefficient(random), 1, 1, random.next() % 2 == 0);
    add_wave(v, coefficient(random), 1, -1, false);
  }
  if (kind == 3) {
    add_power(v, 1 + std::abs(coefficient(random)), 4, 1);
    add_power(v, coefficient(random), 2, 1);
    add_mixed(v, coefficient(random), 1);
  }
  return v;
}

std::string model_of(const Potential& v) {
  const std::string range = fmt::format("[-{0}, {0}]", longest);
  std::string coordinates = coordinate("x", v.is_angle[0] ? "" : range);
  if (v.size == 2) coordinates += coordinate("y", v.is_angle[1] ? "" : range);
  std::string text = v.text;
  if (v.size == 1) {
    for (std::size_t at; (at = text.find(" + 0*y")) != std::string::npos;) text.erase(at, 6);
  }
  return potential_model(coordinates, text);
}

/// The number of sign changes of V' on a fine grid.
std::size_t dense_count_of_one(const Potential& v) {
  const double low = v.is_angle[0] ? -std::numbers::pi + 0.1234 : -longest;
  const double high = v.is_angle[0] ? low + 2 * std::numbers::pi : longest;
  constexpr int steps = 40'000;
  std::size_t count = 0;
  double before = v.gradient({low, 0})[0];
  for (int i = 1; i <= steps; ++i) {
    const double here = v.gradient({low + (high - low) * i / steps, 0})[0];
    if (before * here < 0 || here == 0) ++count;
    before = here;
  }
  return count;
}

double reduce_angle(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

/// The zeros of the gradient that Newton's method with numeric derivatives finds from a grid of
/// 3600 starts. Zeros closer than 1e-6 count once.
std::vector<Place> dense_solutions_of_two(const Potential& v) {
  std::vector<Place> found;
  constexpr int steps = 60;
  for (int i = 0; i < steps * steps; ++i) {
    Place at{-std::numbers::pi + 2 * std::numbers::pi * (i % steps + 0.5) / steps,
             -longest + 2 * longest * (i / steps + 0.5) / steps};
    if (v.is_angle[1]) at[1] *= std::numbers::pi / longest;
    for (int n = 0; n < 60; ++n) {
      constexpr double h = 1e-6;
      const Place f = v.gradient(at);
      const Place right = v.gradient({at[0] + h, at[1]});
      const Place left = v.gradient({at[0] - h, at[1]});
      const Place up = v.gradient({at[0], at[1] + h});
      const Place down = v.gradient({at[0], at[1] - h});
      const double a = (right[0] - left[0]) / (2 * h);
      const double b = (up[0] - down[0]) / (2 * h);
      const double c = (right[1] - left[1]) / (2 * h);
      const double d = (up[1] - down[1]) / (2 * h);
      const double det = a * d - b * c;
      if (det == 0) break;
      at[0] -= (d * f[0] - b * f[1]) / det;
      at[1] -= (a * f[1] - c * f[0]) / det;
    }
    const Place rest = v.gradient(at);
    if (!(std::abs(rest[0]) + std::abs(rest[1]) < 1e-9)) continue;
    at[0] = reduce_angle(at[0]);
    if (v.is_angle[1]) at[1] = reduce_angle(at[1]);
    if (!v.is_angle[1] && std::abs(at[1]) > longest) continue;
    const bool is_known = std::ranges::any_of(found, [&](const Place& known) {
      const double dy = at[1] - known[1];
      return std::abs(reduce_angle(at[0] - known[0])) < 1e-6 &&
             std::abs(v.is_angle[1] ? reduce_angle(dy) : dy) < 1e-6;
    });
    if (!is_known) found.push_back(at);
  }
  return found;
}

std::size_t dense_count(const Potential& v) {
  return v.size == 1 ? dense_count_of_one(v) : dense_solutions_of_two(v).size();
}

}  // namespace

TEST_CASE("a dense search finds as many equilibria of random potentials as are claimed") {
  Random random(2026);
  std::size_t proved = 0;
  for (int i = 0; i < 190; ++i) {
    const Potential v = random_potential(random);
    const std::string model = model_of(v);
    INFO(model);
    const Analysed found = analyse_model(model);
    if (found.equilibria.completeness != Completeness::proved) continue;
    const bool is_family = std::ranges::any_of(found.equilibria.points, [](const RestPoint& point) {
      return std::ranges::any_of(point.coordinates, &RestCoordinate::is_arbitrary);
    });
    if (is_family) continue;
    ++proved;
    CHECK(found.equilibria.points.size() == dense_count(v));
  }
  CHECK(proved > 170);
}

TEST_CASE("double and nearly double zeros are counted correctly or reported as undecided") {
  for (int i = 0; i < 10; ++i) {
    // V' = ((x - c)^2 - gap) (x - d); the gap is 0, 1e-14, or wide enough to resolve (1e-4)
    const double c = -1 + 0.3 * (i % 5);
    const double d = 1.25;
    const double gap = i < 4 ? 0 : i < 7 ? 1e-14 : 1e-4;
    const std::string potential = fmt::format(
        "1/4*x^4 - ({0} + 2*({1}))/3*x^3 + (({1})^2 - ({2}) + 2*({0})*({1}))/2*x^2 - "
        "({0})*(({1})^2 - ({2}))*x",
        d, c, gap);
    INFO(potential);
    const Analysed found = analyse_model(potential_model(coordinate("x", "[-2, 2]"), potential));
    const bool is_proved = found.equilibria.completeness == Completeness::proved;
    const std::size_t count = found.equilibria.points.size();
    if (gap == 0) CHECK((!is_proved || count == 2));
    if (gap > 0) CHECK((!is_proved || count == 3));
    if (gap > 1e-5) CHECK(is_proved);
  }
}
