// exact_places: see points.hpp.
#include <cln/integer.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "choose/points.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

constexpr std::size_t most_places = 4;  ///< per minimum; each is tried for every entry
constexpr std::size_t most_values = 2;  ///< per coordinate of a minimum
/// Denominators of numbers, such as 0.25, and of factors of parameters and pi.
constexpr int most_parts = 100;
constexpr int most_parts_of_factor = 2;

/// Larger numbers, such as radii in metres, equal some fraction by chance.
constexpr double largest_numerator = 10'000;

/// Minima are accurate to a rounding. Two unrelated values of a model seldom agree to this number.
constexpr double equality = 0x1p-44;

bool are_equal(double x, double y) { return std::abs(x - y) <= equality * std::abs(y); }

/// The fraction that equals x, with the least denominator up to `most` and a small numerator; none
/// for 0.
std::optional<cln::cl_RA> simple_fraction(double x, int most) {
  for (int denominator = 1; denominator <= most; ++denominator) {
    const double numerator = std::nearbyint(x * denominator);
    const bool is_small = 0 < std::abs(numerator) && std::abs(numerator) <= largest_numerator;
    if (!is_small || !are_equal(numerator / denominator, x)) continue;
    return exact_value(numerator) / denominator;
  }
  return std::nullopt;
}

/// The exact values of a coordinate with the value `x` in double, in the order of preference.
std::vector<ExactValue> exact_values(const Domain& domain, std::size_t coordinate, double x) {
  if (x == 0) return {ExactValue{}};
  const Model& model = domain.model;
  const std::vector<double>& all = domain.states.front().parameters;
  std::vector<std::uint32_t> like;  // in the unit of the coordinate, larger parameters first
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    const std::optional<Unit>& unit = model.parameters[i].unit;
    if (unit && unit == model.coordinates[coordinate].unit) like.push_back(i);
  }
  std::ranges::stable_sort(like, std::ranges::greater{},
                           [&](std::uint32_t i) { return std::abs(all[i]); });
  std::vector<ExactValue> values;
  for (const std::uint32_t i : like) {
    const auto scale = simple_fraction(x / all[i], most_parts_of_factor);
    const bool is_simple = scale && cln::abs(cln::numerator(*scale)) <= most_parts_of_factor;
    if (is_simple) values.push_back({.parameters = {{i, *scale}}});
  }
  for (std::size_t i = 0; i < like.size() && values.empty(); ++i) {
    for (std::size_t k = i + 1; k < like.size(); ++k) {
      for (const auto& [first, second] : {std::pair{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
        const bool is_sum = are_equal(first * all[like[i]] + second * all[like[k]], x);
        if (is_sum) values.push_back({.parameters = {{like[i], first}, {like[k], second}}});
      }
    }
  }
  if (const auto half_turns = simple_fraction(x / std::numbers::pi, most_parts_of_factor))
    values.push_back({.half_turns = *half_turns});
  if (const auto number = simple_fraction(x, most_parts)) values.push_back({.number = *number});
  if (values.size() > most_values) values.resize(most_values);
  return values;
}

/// The places that differ from `place` in one coordinate, which has one of the values.
std::vector<ExactPlace> places_with(const ExactPlace& place, std::size_t coordinate,
                                    const std::vector<ExactValue>& values) {
  std::vector<ExactPlace> places(std::max<std::size_t>(values.size(), 1), place);
  for (std::size_t i = 0; i < values.size(); ++i) places[i][coordinate] = values[i];
  return places;
}

/// All combinations of the exact values of the coordinates of a minimum, at most most_places.
std::vector<ExactPlace> exact_places_of(const Domain& domain, const std::vector<double>& minimum) {
  std::vector<ExactPlace> places{ExactPlace(minimum.size())};
  for (std::size_t i = 0; i < minimum.size(); ++i) {
    if (domain.model.coordinates[i].rotation) continue;
    const std::vector<ExactValue> values = exact_values(domain, i, minimum[i]);
    for (const ExactPlace& place : std::exchange(places, {}))
      std::ranges::move(places_with(place, i, values), std::back_inserter(places));
    if (places.size() > most_places) places.resize(most_places);
  }
  return places;
}

}  // namespace

std::vector<ExactPlace> exact_places(const Domain& domain) {
  std::vector<ExactPlace> places;
  for (const std::vector<double>& minimum : domain.minima)
    std::ranges::move(exact_places_of(domain, minimum), std::back_inserter(places));
  return places;
}

}  // namespace elgen
