// points: random numbers, vectors and points, for functions of any model. Exact points show which
// values are 0; points in double show which values lose digits.
#pragma once

#include <cln/real.h>

#include <cstdint>
#include <vector>

#include "elgen/domain.hpp"
#include "elgen/leaf_names.hpp"
#include "numbers/random.hpp"

namespace elgen {

/// The parameters that an exact point sets to positive values.
enum class PositiveParameters : std::uint8_t {
  parameters,  ///< all, because most masses and lengths must be positive
  assumed,     ///< only parameters that the model assumes to be positive
};

/// Values of angles at which sums of their sines and cosines cancel.
enum class CancellingAngles : std::uint8_t {
  right,     ///< about 1e-8 from odd multiples of a right angle; (1e-8)^2 is lost next to 1
  straight,  ///< about 1e-8 from even multiples of a right angle
  equal,     ///< all angles are equal to about 1e-3
  tiny,      ///< about 1e-8 from 0
};
inline constexpr CancellingAngles all_cancelling_angles[]{
    CancellingAngles::right, CancellingAngles::straight, CancellingAngles::equal,
    CancellingAngles::tiny};

/// The largest magnitudes of coordinates without a range at remote states, with both signs. Up to
/// 16, exp(x) covers a few decades; up to 1e3, most of the range of double. 1 + x^2 is x^2 at 1e8.
inline constexpr double remote_magnitudes[]{1, 4, 16, 64, 1e3, 1e8};

/// For each coordinate: true if it has no declared range, and is no angle and no component of a
/// quaternion, so that its values may be remote.
[[nodiscard]] std::vector<bool> unbounded_coordinates(const Model& model);

/// A generator of random numbers, which are the same for a seed on every machine. A copy returns
/// the same numbers as the original.
class Sampler {
 public:
  explicit Sampler(std::uint64_t seed) : random_(seed) {}

  /// A rational number in [-1, 1], never 0 (numbers/random.hpp).
  [[nodiscard]] cln::cl_RA number() { return random_.rational(); }
  /// A list of `size` results of number().
  [[nodiscard]] std::vector<cln::cl_R> vector(std::size_t size);
  /// number() for every leaf that has a name.
  [[nodiscard]] LeafValues<cln::cl_RA> point(
      const LeafNames& leaves, PositiveParameters positive = PositiveParameters::parameters);

  [[nodiscard]] double uniform(const Range& range) {
    return random_.uniform(range.low, range.high);
  }
  /// A number in [1/2, 1).
  [[nodiscard]] double random_fraction() { return random_.uniform(0.5, 1); }
  /// 1 or -1.
  [[nodiscard]] double random_sign() { return random_.uniform(-1, 1) < 0 ? -1 : 1; }
  /// A number with a random sign and a magnitude in [2^low, 2^(high + 1)).
  [[nodiscard]] double log_uniform(int low, int high) { return random_.log_uniform(low, high); }
  /// log_uniform() for every leaf that has a name; parameters are positive.
  [[nodiscard]] LeafValues<double> log_uniform_point(const LeafNames& leaves, int low, int high);
  /// Sets the coordinates that are angles to values of the kind `place`.
  void set_angles(CancellingAngles place, const std::vector<bool>& is_angle,
                  std::vector<double>& q);
  /// Sets the chosen coordinates to 1/2 to 1 times `value`: the first with its sign, all others
  /// with any sign. They grow together, so that products and quotients of them become large, too.
  void set_remote(double value, const std::vector<bool>& is_chosen, std::vector<double>& q);

 private:
  Random random_;
};

using Points = std::vector<LeafValues<double>>;

/// Points at which the rounding errors of equal forms of a value are compared:
///
///     2*a*(x + y) + b*z - a*(2*x + y)     the terms 2 a x and -2 a x cancel: if they are large, no
///     a*y + b*z                           digit of the first form is right
///
/// Cancelling terms cause an error only if they are larger than all other terms. Therefore each
/// leaf has a random magnitude: from 2^-26 to 2^27, about the range in which programs are checked;
/// at a quarter of the points from 2^-3 to 2.
[[nodiscard]] Points mixed_magnitude_points(const LeafNames& leaves);

}  // namespace elgen
