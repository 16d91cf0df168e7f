// Nanoseconds per state of the inverse dynamics of panda7: one state at a time in double, and in
// batches of 128 states in double and in float. Prints rows of a Markdown table.
#include <cmath>
#include <cstdio>

#include "../../generated/panda7_rollouts/panda7_rollouts_batch.hpp"
#include "timing.hpp"

namespace {

namespace arm = panda7_rollouts;

constexpr std::size_t count = 128;

template <class T>
struct States {
  std::vector<T> q = numbers(3.0), v = numbers(2.0), a = numbers(4.0);
  std::vector<T> torques = std::vector<T>(7 * count);

  static std::vector<T> numbers(double scale) {
    std::vector<T> result(7 * count);
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] = static_cast<T>(scale * std::sin(scale * static_cast<double>(i)));
    }
    return result;
  }
};

std::array<double, 7> state(const std::vector<double>& numbers, std::size_t i) {
  std::array<double, 7> result;
  for (std::size_t k = 0; k < 7; ++k) result[k] = numbers[k * count + i];
  return result;
}

std::function<void(int)> one_by_one() {
  return [states = States<double>()](int calls) mutable {
    for (int call = 0; call < calls; ++call) {
      bench::keep(states);
      for (std::size_t i = 0; i < count; ++i) {
        const auto torques = arm::inverse_dynamics<double>({}, state(states.q, i),
                                                           state(states.v, i), state(states.a, i));
        for (std::size_t k = 0; k < 7; ++k) states.torques[k * count + i] = torques[k];
      }
    }
  };
}

template <class T>
std::function<void(int)> in_batches() {
  return [states = States<T>()](int calls) mutable {
    for (int call = 0; call < calls; ++call) {
      bench::keep(states);
      arm::batch::inverse_dynamics<T>({}, count, states.q.data(), states.v.data(), states.a.data(),
                                      states.torques.data());
    }
  };
}

}  // namespace

int main() {
  const std::vector<double> ns =
      bench::medians({one_by_one(), in_batches<double>(), in_batches<float>()}, 10, 301);
  const char* names[] = {"one state, double", "batch, double", "batch, float"};
  for (std::size_t i = 0; i < ns.size(); ++i) {
    std::printf("| %s | %.1f | 1/%.1f |\n", names[i], ns[i] / count, ns[0] / ns[i]);
  }
}
