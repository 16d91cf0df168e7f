// Calls unmodified emitted functions with packs of numbers. Every lane must have the value of the
// function of one number, except for the rounding errors of sines: packs compute sines by their own
// functions or by the library.
#include <cstdio>
#include <experimental/simd>

#include "lanes.hpp"
#include "two_link_arm/two_link_arm.hpp"

namespace {

constexpr std::size_t most_lanes = 64;

double angle(std::size_t lane, std::size_t joint) {
  return 0.37 * static_cast<double>(lane) + 0.81 * static_cast<double>(joint) - 1.5;
}

template <class Scalar>
auto torques(const std::array<Scalar, 2>& q) {
  const two_link_arm::Parameters<Scalar> p{};
  const std::array<Scalar, 2> v{Scalar(0.5F), Scalar(-2.0F)};
  const std::array<Scalar, 2> a{Scalar(3.0F), Scalar(1.25F)};
  return two_link_arm::inverse_dynamics<Scalar>(p, q, v, a);
}

/// The number of torques, over all lanes, that differ from torques computed in `Element` by more
/// than `tolerance` times the larger torque.
template <class Pack, class Element>
int differences(const char* type, std::size_t lanes, Element tolerance) {
  std::array<Pack, 2> q;
  for (std::size_t joint = 0; joint < 2; ++joint) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      q[joint][lane] = static_cast<Element>(angle(lane, joint));
    }
  }
  const auto packed = torques<Pack>(q);
  int count = 0;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const auto single = torques<Element>(
        {static_cast<Element>(angle(lane, 0)), static_cast<Element>(angle(lane, 1))});
    const Element largest = std::max(std::abs(single[0]), std::abs(single[1]));
    for (std::size_t joint = 0; joint < 2; ++joint) {
      const Element found = packed[joint][lane];
      if (std::abs(found - single[joint]) <= tolerance * largest) continue;
      ++count;
      std::printf("%s, lane %zu: %.17g instead of %.17g\n", type, lane, static_cast<double>(found),
                  static_cast<double>(single[joint]));
    }
  }
  return count;
}

template <class Element>
int all_differences(Element tolerance) {
  using Simd = std::experimental::native_simd<Element>;
  using Fixed = std::experimental::fixed_size_simd<Element, 3>;
  static_assert(Simd::size() <= most_lanes);
  return differences<Simd, Element>("simd", Simd::size(), tolerance) +
         differences<Fixed, Element>("fixed_size_simd", 3, tolerance) +
         differences<compiled::Lanes<Element, 4>, Element>("vector extension", 4, tolerance) +
         differences<compiled::Lanes<Element, 16>, Element>("long vector extension", 16, tolerance);
}

}  // namespace

int main() { return all_differences<float>(1e-6F) + all_differences<double>(2e-15) == 0 ? 0 : 1; }
