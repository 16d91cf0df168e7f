// Kernels that call emitted functions in both precisions: of a small model, of a model with
// quaternions, and of a model with functions in parts; also the kernels of batches. Without
// NVIDIA's headers the program itself declares the variables and functions that clang++ needs.
#if defined(__clang__)
#define __CUDACC__
#define __host__ __attribute__((host))
#define __device__ __attribute__((device))
#define __global__ __attribute__((global))
struct Dimensions {
  unsigned x;
};
extern __device__ const Dimensions gridDim, blockDim, blockIdx, threadIdx;
extern "C" {
__device__ void* memcpy(void*, const void*, unsigned long);
__device__ double cos(double);
__device__ double sin(double);
__device__ double sqrt(double);
__device__ float cosf(float);
__device__ float sinf(float);
__device__ float sqrtf(float);
__device__ void sincos(double, double*, double*);
__device__ void sincosf(float, float*, float*);
}
#endif

#include "cart_pole/cart_pole.hpp"
#include "cart_pole_sampling/cart_pole_sampling_batch.hpp"
#include "free_body/free_body.hpp"
#include "panda7/panda7.hpp"
#include "panda7_rollouts/panda7_rollouts_batch.hpp"

template <class Array, class T>
__device__ Array numbers(const T* from) {
  Array result;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = from[i];
  return result;
}

template <class T>
__device__ void evaluate(const T* from, T* to) {
  const cart_pole::Parameters<T> cart{};
  const auto q = numbers<cart_pole::Coordinates<T>>(from);
  const auto v = numbers<cart_pole::Velocities<T>>(from);
  const auto motion = cart_pole::forward_dynamics(cart, q, v, {from[0]});
  to[0] = motion.acceleration[1];
  to[1] = cart_pole::is_regular<T>(motion.relative_pivots) ? T(1) : T(0);

  const free_body::Parameters<T> body{};
  to[2] = free_body::mass_matrix(body, numbers<free_body::Coordinates<T>>(from))[0];

  const panda7::Parameters<T> arm{};
  const auto rates = numbers<panda7::Velocities<T>>(from);
  const auto forces =
      panda7::inverse_dynamics(arm, numbers<panda7::Coordinates<T>>(from), rates, rates);
  for (std::size_t i = 0; i < forces.size(); ++i) to[3 + i] = forces[i];
}

__global__ void in_double(const double* from, double* to) { evaluate(from, to); }
__global__ void in_float(const float* from, float* to) { evaluate(from, to); }

namespace cart_pole_sampling::kernel {

template __global__ void forward_dynamics(Parameters<double>, std::size_t, const double*,
                                          const double*, const double*, double*, std::size_t);

}  // namespace cart_pole_sampling::kernel

namespace panda7_rollouts::kernel {

template __global__ void inverse_dynamics(Parameters<double>, std::size_t, const double*,
                                          const double*, const double*, double*, std::size_t);
template __global__ void inverse_dynamics(Parameters<float>, std::size_t, const float*,
                                          const float*, const float*, float*, std::size_t);

}  // namespace panda7_rollouts::kernel
