// Random: the SplitMix64 generator. The standard distributions differ between libraries, but a seed
// must give the same states everywhere.
#pragma once

#include <cln/rational.h>

#include <cstdint>

namespace elgen {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  [[nodiscard]] std::uint64_t next();
  /// A number in [low, high).
  [[nodiscard]] double uniform(double low, double high);
  /// ±m 2^k with m uniform in [1, 2) and k uniform in [low_exponent, high_exponent].
  [[nodiscard]] double log_uniform(int low_exponent, int high_exponent);
  /// k / 997 in [-1, 1], k not 0. Small integers keep exact arithmetic fast, and 997 shares no
  /// divisor with the decimals of models.
  [[nodiscard]] cln::cl_RA rational();

 private:
  std::uint64_t state_;
};

}  // namespace elgen
