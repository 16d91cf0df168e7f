// points: see points.hpp. Functions of libm are not called, because their rounding depends on the
// machine.
#include "sample/points.hpp"

#include <cmath>

namespace elgen {
namespace {

constexpr double right_angle = 1.5707963267948966;

/// Of three terms with equal distributions, each is the largest at a third of all points. The
/// probability that a term is the largest at none of the 12 points with wide magnitudes is 1/130.
constexpr std::size_t mixed_count = 16;

/// Wide magnitudes are in [2^-26, 2^27), ordinary magnitudes in [2^-3, 2).
constexpr int wide_exponent = 26;
constexpr int ordinary_exponent = 3;

}  // namespace

std::vector<cln::cl_R> Sampler::vector(std::size_t size) {
  std::vector<cln::cl_R> numbers;
  for (std::size_t i = 0; i < size; ++i) numbers.emplace_back(number());
  return numbers;
}

std::vector<bool> unbounded_coordinates(const Model& model) {
  std::vector<bool> result;
  for (const Coordinate& coordinate : model.coordinates) {
    result.push_back(!coordinate.range && !coordinate.rotation && !is_angle(coordinate));
  }
  return result;
}

LeafValues<cln::cl_RA> Sampler::point(const LeafNames& leaves, PositiveParameters positive) {
  LeafValues<cln::cl_RA> result = sample_leaves(leaves, [this] { return number(); });
  for (std::uint32_t i = 0; i < result.parameters.size(); ++i) {
    const bool is_assumed = assumption_of(leaves, i) != Assumption::none;
    cln::cl_RA& parameter = result.parameters[i];
    if (positive == PositiveParameters::parameters || is_assumed) parameter = cln::abs(parameter);
  }
  return result;
}

LeafValues<double> Sampler::log_uniform_point(const LeafNames& leaves, int low, int high) {
  LeafValues<double> result = sample_leaves(leaves, [&] { return log_uniform(low, high); });
  for (double& parameter : result.parameters) parameter = std::abs(parameter);
  return result;
}

void Sampler::set_angles(CancellingAngles place, const std::vector<bool>& is_angle,
                         std::vector<double>& q) {
  const double common = uniform({-2 * right_angle, 2 * right_angle});
  for (std::size_t i = 0; i < q.size(); ++i) {
    const double sign = random_sign();
    const double away = sign * random_fraction();
    const double half_turns = std::floor(uniform({-1, 2}));
    if (!is_angle[i]) continue;
    q[i] = away * 1e-8;
    if (place == CancellingAngles::right) q[i] += (2 * half_turns + 1) * right_angle;
    if (place == CancellingAngles::straight) q[i] += 2 * half_turns * right_angle;
    if (place == CancellingAngles::equal) q[i] = common + away * 1e-3;
  }
}

void Sampler::set_remote(double value, const std::vector<bool>& is_chosen, std::vector<double>& q) {
  double turn = 1;
  for (std::size_t i = 0; i < is_chosen.size(); ++i) {
    if (!is_chosen[i]) continue;
    q[i] = turn * value * random_fraction();
    turn = random_sign();
  }
}

Points mixed_magnitude_points(const LeafNames& leaves) {
  Sampler draw(1);
  Points points;
  for (std::size_t i = 0; i < mixed_count; ++i) {
    const bool is_ordinary = i % 4 == 0;
    points.push_back(is_ordinary ? draw.log_uniform_point(leaves, -ordinary_exponent, 0)
                                 : draw.log_uniform_point(leaves, -wide_exponent, wide_exponent));
  }
  return points;
}

}  // namespace elgen
