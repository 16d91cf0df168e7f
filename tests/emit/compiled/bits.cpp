// Prints a hash of all bits of batches in double and a hash in float; all machines must print the
// same hashes. Functions of the library are not called, because their bits depend on the machine.
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <vector>

#include "panda7_rollouts/panda7_rollouts_batch.hpp"

namespace {

namespace arm = panda7_rollouts;

/// A random integer of 24 bits, which a float holds exactly.
std::uint32_t drawn(std::uint64_t& state) {
  state = state * 6364136223846793005U + 1442695040888963407U;
  return static_cast<std::uint32_t>(state >> 40);
}

template <class T>
std::vector<T> numbers(std::size_t size, std::uint64_t seed, T largest) {
  std::vector<T> result(size);
  for (T& x : result) x = largest * (static_cast<T>(drawn(seed)) / T(0x800000) - T(1));
  return result;
}

/// FNV-1a over the bits of `value` as one number, so that `hash` does not depend on the byte order.
template <class T, class Bits>
void add(T value, std::uint64_t& hash) {
  Bits bits;
  std::memcpy(&bits, &value, sizeof(bits));
  hash = (hash ^ bits) * 1099511628211U;
}

template <class T, class Bits>
std::uint64_t hash_of_bits(T domain) {
  constexpr std::size_t count = 2'000;
  std::uint64_t hash = 14695981039346656037U;
  const std::vector<T> angles = numbers<T>(20 * count, 1, domain);
  for (const T angle : angles) {
    const arm::batch::Pack<T> x(angle);
    add<T, Bits>(sin(x).native[0], hash);
    add<T, Bits>(cos(x).native[0], hash);
  }
  std::vector<T> torques(7 * count);
  const std::vector<T> q = numbers<T>(7 * count, 2, T(4));
  const std::vector<T> v = numbers<T>(7 * count, 3, T(8));
  const std::vector<T> a = numbers<T>(7 * count, 4, T(16));
  arm::batch::inverse_dynamics<T>({}, count, q.data(), v.data(), a.data(), torques.data());
  for (const T torque : torques) add<T, Bits>(torque, hash);
  return hash;
}

}  // namespace

int main() {
  std::printf("%016" PRIx64 " %016" PRIx64 "\n", hash_of_bits<double, std::uint64_t>(1e5),
              hash_of_bits<float, std::uint32_t>(1e3F));
}
