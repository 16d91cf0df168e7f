// Kernels of batches compiled as plain functions. All threads of a grid run in turn, with more and
// with fewer states than threads, with the default stride and a longer one. Every state must have
// the values of the function of one state.
#include <cstdio>
#include <vector>

#define __CUDACC__
#define __host__
#define __device__
#define __global__

struct Dimensions {
  unsigned x;
};
constexpr Dimensions gridDim{3}, blockDim{2};
static Dimensions blockIdx{0}, threadIdx{0};

#include "cart_pole_sampling/cart_pole_sampling_batch.hpp"
#include "panda7_rollouts/panda7_rollouts_batch.hpp"

template <class Kernel>
void launch(const Kernel& kernel) {
  for (blockIdx.x = 0; blockIdx.x < gridDim.x; ++blockIdx.x) {
    for (threadIdx.x = 0; threadIdx.x < blockDim.x; ++threadIdx.x) kernel();
  }
}

template <class T>
std::vector<T> numbers(std::size_t count, T first) {
  std::vector<T> result(count);
  for (std::size_t i = 0; i < count; ++i) result[i] = first + T(i) / 7;
  return result;
}

template <class Array, class T>
Array state_of(const std::vector<T>& from, std::size_t i, std::size_t stride) {
  Array result;
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = from[k * stride + i];
  return result;
}

/// `stride`: the argument of the kernel; 0 is its default.
template <class T>
bool has_torques(std::size_t count, std::size_t stride) {
  namespace arm = panda7_rollouts;
  const arm::Parameters<T> p{};
  const std::size_t row = stride == 0 ? count : stride;
  const std::vector<T> q = numbers<T>(7 * row, T(-1)), v = numbers<T>(7 * row, T(0.3));
  std::vector<T> torques(7 * row);
  launch([&] {
    arm::kernel::inverse_dynamics(p, count, q.data(), v.data(), q.data(), torques.data(), stride);
  });
  bool is_right = true;
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = state_of<arm::Coordinates<T>>(q, i, row);
    const auto expected =
        arm::inverse_dynamics<T>(p, at, state_of<arm::Velocities<T>>(v, i, row), at);
    is_right = is_right && state_of<arm::Forces<T>>(torques, i, row) == expected;
  }
  return is_right;
}

bool has_accelerations(std::size_t count) {
  namespace cart = cart_pole_sampling;
  const cart::Parameters<double> p{};
  const std::vector<double> q = numbers(2 * count, 0.2), u = numbers(count, 1.0);
  std::vector<double> result(4 * count);
  launch([&] {
    cart::kernel::forward_dynamics(p, count, q.data(), q.data(), u.data(), result.data());
  });
  bool is_right = true;
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = state_of<cart::Coordinates<double>>(q, i, count);
    const auto expected = cart::forward_dynamics<double>(p, at, at, {u[i]});
    const auto all = state_of<std::array<double, 4>>(result, i, count);
    is_right = is_right && all[0] == expected.acceleration[0] &&
               all[1] == expected.acceleration[1] && all[2] == expected.relative_pivots[0] &&
               all[3] == expected.relative_pivots[1];
  }
  return is_right;
}

int main() {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{17}}) {
    if (has_torques<double>(count, 0) && has_torques<float>(count, count + 5) &&
        has_accelerations(count))
      continue;
    std::printf("%zu states have other values\n", count);
    return 1;
  }
}
