// points: random numbers, vectors and points, for functions of any model. Exact points show which
// values vanish; rounded points show which values lose digits.
#pragma once

#include <cln/real.h>

#include <cstdint>
#include <vector>

#include "elgen/domain.hpp"
#include "elgen/leaf_names.hpp"
#include "numbers/random.hpp"

namespace elgen {

/// The parameters of an exact point that are positive.
enum class Positive : std::uint8_t {
  parameters,  ///< all, as most masses and lengths must be
  assumed,     ///< only parameters that the model assumes to be positive
};

/// Places of angles at which sums of their sines and cosines cancel.
enum class AnglePlace : std::uint8_t {
  right,     ///< 1e-8 from odd multiples of a right angle: its square is lost next to 1
  straight,  ///< 1e-8 from even multiples
  equal,     ///< 1e-3 from one another
  tiny,      ///< 1e-8 from 0
};
inline constexpr AnglePlace angle_places[]{AnglePlace::right, AnglePlace::straight,
                                           AnglePlace::equal, AnglePlace::tiny};

/// Draws all random numbers: the same for a seed on every machine. A copy draws the same numbers as
/// the original.
class Sampler {
 public:
  explicit Sampler(std::uint64_t seed) : random_(seed) {}

  /// Exact, in [-1, 1] without 0 (numbers/random.hpp).
  [[nodiscard]] cln::cl_RA number() { return random_.rational(); }
  /// `size` numbers.
  [[nodiscard]] std::vector<cln::cl_R> vector(std::size_t size);
  /// A number for every leaf that has a name.
  [[nodiscard]] LeafValues<cln::cl_RA> point(const LeafNames& leaves,
                                             Positive positive = Positive::parameters);

  [[nodiscard]] double within(const Range& range) { return random_.uniform(range.low, range.high); }
  /// In [1/2, 1).
  [[nodiscard]] double share() { return random_.uniform(0.5, 1); }
  /// 1 or -1.
  [[nodiscard]] double side() { return random_.uniform(-1, 1) < 0 ? -1 : 1; }
  /// A number of either sign and a magnitude in [2^low, 2^(high + 1)).
  [[nodiscard]] double scaled(int low, int high) { return random_.log_uniform(low, high); }
  /// A scaled number for every leaf that has a name; parameters are positive.
  [[nodiscard]] LeafValues<double> scaled_point(const LeafNames& leaves, int low, int high);
  /// Moves the coordinates that are angles to a place.
  void set_angles(AnglePlace place, const std::vector<bool>& is_angle, std::vector<double>& q);

 private:
  Random random_;
};

using Points = std::vector<LeafValues<double>>;

/// Points at which rewritings of one value are compared by their rounding errors:
///
///     2*a*(x + y) + b*z - a*(2*x + y)     has two more terms that cancel,   2 a x: if they are
///     a*y + b*z                           large, no digit of the first form is right
///
/// A cancelling term shows only if it outweighs all others. So every leaf has its own magnitude:
/// ordinary at a quarter of the points, otherwise from 2^-26 to 2^26, the range in which programs
/// are checked.
[[nodiscard]] Points mixed_points(const LeafNames& leaves);

}  // namespace elgen
