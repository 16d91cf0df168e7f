// Functions that compare numbers, with packs: in batches and in other packs, each state has the
// bits of the function of one state.
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <experimental/simd>
#include <vector>

#include "functions_kinked/functions_kinked_batch.hpp"
#include "lanes.hpp"

namespace {

namespace emitted = functions_kinked;

/// Angles at 0 and on both sides of the ends of all series, so that packs have both.
template <class T>
std::vector<T> angles() {
  std::vector<T> list{T(0), T(30), T(1e-20), T(-7), T(-1e-3)};
  for (int i = -60; i <= 60; ++i) list.push_back(T(0.11) * static_cast<T>(i));
  return list;
}

template <class T>
T rate(std::size_t i) {
  return T(0.0004) * (static_cast<T>(i % 9) - T(4));
}

template <class T>
int difference(const char* what, std::size_t state, T found, T expected) {
  if (std::memcmp(&found, &expected, sizeof(T)) == 0) return 0;
  std::printf("%s, state %zu: %.17g instead of %.17g\n", what, state, static_cast<double>(found),
              static_cast<double>(expected));
  return 1;
}

template <class T>
int differences_in_batch() {
  const std::vector<T> theta = angles<T>();
  const std::size_t count = theta.size();
  std::vector<T> q(count), v, gravity(2 * count), force(2 * count);
  q.insert(q.end(), theta.begin(), theta.end());
  for (std::size_t i = 0; i < count; ++i) v.push_back(rate<T>(i));
  v.resize(2 * count);
  const emitted::Parameters<T> p{};
  emitted::batch::gravity<T>(p, count, q.data(), gravity.data());
  emitted::batch::applied_force<T>(p, count, q.data(), v.data(), force.data());
  int found = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::array<T, 2> place{T(0), theta[i]};
    const std::array<T, 2> rates{v[i], T(0)};
    found +=
        difference("gravity of a batch", i, gravity[count + i], emitted::gravity<T>(p, place)[1]);
    found +=
        difference("force of a batch", i, force[i], emitted::applied_force<T>(p, place, rates)[0]);
  }
  return found;
}

template <class Pack, class T, std::size_t Count>
int differences_in(const char* type) {
  const std::vector<T> theta = angles<T>();
  const emitted::Parameters<T> p{};
  const emitted::Parameters<Pack> in_packs{};
  int found = 0;
  for (std::size_t first = 0; first + Count <= theta.size(); first += Count) {
    std::array<Pack, 2> q{Pack(T(0)), Pack(T(0))};
    std::array<Pack, 2> v{Pack(T(0)), Pack(T(0))};
    for (std::size_t lane = 0; lane < Count; ++lane) {
      q[1][lane] = theta[first + lane];
      v[0][lane] = rate<T>(first + lane);
    }
    const auto gravity = emitted::gravity<Pack>(in_packs, q);
    const auto force = emitted::applied_force<Pack>(in_packs, q, v);
    for (std::size_t lane = 0; lane < Count; ++lane) {
      const std::array<T, 2> place{T(0), theta[first + lane]};
      const std::array<T, 2> rates{rate<T>(first + lane), T(0)};
      const T gravity_here = gravity[1][lane];
      const T force_here = force[0][lane];
      found += difference(type, first + lane, gravity_here, emitted::gravity<T>(p, place)[1]);
      found +=
          difference(type, first + lane, force_here, emitted::applied_force<T>(p, place, rates)[0]);
    }
  }
  return found;
}

template <class T>
int differences() {
  using Simd = std::experimental::native_simd<T>;
  return differences_in_batch<T>() + differences_in<Simd, T, Simd::size()>("simd") +
         differences_in<compiled::Lanes<T, 8>, T, 8>("vector extension");
}

}  // namespace

int main() { return differences<float>() + differences<double>() == 0 ? 0 : 1; }
