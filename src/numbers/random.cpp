// SplitMix64 after Steele, Lea, Flood, "Fast splittable pseudorandom number generators" (OOPSLA
// 2014).
#include "numbers/random.hpp"

#include <cmath>

namespace elgen {

std::uint64_t Random::next() {
  state_ += 0x9e3779b97f4a7c15U;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

double Random::uniform(double low, double high) {
  const double unit = std::ldexp(static_cast<double>(next() >> 11U), -53);
  return low + (high - low) * unit;
}

double Random::log_uniform(int low_exponent, int high_exponent) {
  const auto count = static_cast<std::uint64_t>(high_exponent - low_exponent) + 1;
  const int exponent = low_exponent + static_cast<int>(next() % count);
  const double magnitude = std::ldexp(uniform(1, 2), exponent);
  return (next() & 1U) != 0 ? magnitude : -magnitude;
}

cln::cl_RA Random::rational() {
  constexpr long denominator = 997;  // prime: no sample is a special angle or value
  const long numerator = 1 + static_cast<long>(next() % denominator);
  return cln::cl_RA((next() & 1U) != 0 ? numerator : -numerator) / denominator;
}

}  // namespace elgen
