// errors_of: how far a design is off, field by field, relative to the largest value of the field.
#include <algorithm>
#include <cmath>
#include <limits>

#include "elgen/tradeoff.hpp"

namespace elgen {
namespace {

/// The entries of one field at all states.
struct FieldRegion {
  std::size_t begin;
  std::size_t end;
};

double largest_magnitude(const std::vector<ExactNumber>& exact, const FieldRegion& field) {
  double largest = 0;
  for (std::size_t i = field.begin; i < field.end; ++i) {
    largest = std::max(largest, std::abs(exact[i].high));
  }
  return largest;
}

/// Where the field is 0 everywhere, any other value is infinitely wrong.
double relative(double distance, double scale) {
  if (std::isnan(distance)) return std::numeric_limits<double>::infinity();
  return distance == 0 ? 0 : distance / scale;
}

}  // namespace

DesignErrors errors_of(const std::vector<double>& results, const TradeoffStates& states) {
  const std::size_t count = states.states.size();
  std::vector<double> errors(count, 0);
  FieldRegion field{0, 0};
  for (const std::size_t entries : states.field_sizes) {
    field = {field.end, field.end + entries * count};
    const double scale = largest_magnitude(states.exact, field);
    for (std::size_t i = field.begin; i < field.end; ++i) {
      const ExactNumber& exact = states.exact[i];
      const double distance = std::abs(results[i] - exact.high - exact.low);
      double& error = errors[(i - field.begin) % count];
      error = std::max(error, relative(distance, scale));
    }
  }
  std::sort(errors.begin(), errors.end());
  return {errors.back(), errors[count / 2]};
}

}  // namespace elgen
