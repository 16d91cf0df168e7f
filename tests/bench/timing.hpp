// Times alternatives in turn within one run, so that changes of the machine's speed affect all
// alternatives equally. Reports medians or minima of many short repetitions.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <vector>

namespace bench {

/// Forces the compiler to compute `value` and to assume that `value` changes.
template <class Value>
void keep(const Value& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

/// The number of states through which an alternative cycles if its function takes a state.
inline constexpr int state_count = 16;

/// Nanoseconds per call, indexed [alternative][repetition]. A repetition calls each alternative
/// `calls` times; alternatives take turns.
inline std::vector<std::vector<double>> samples(
    const std::vector<std::function<void(int)>>& alternatives, int calls, int repetitions) {
  using Clock = std::chrono::steady_clock;
  std::vector<std::vector<double>> times(alternatives.size());
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    for (std::size_t i = 0; i < alternatives.size(); ++i) {
      const Clock::time_point start = Clock::now();
      alternatives[i](calls);
      const std::chrono::duration<double, std::nano> elapsed = Clock::now() - start;
      times[i].push_back(elapsed.count() / calls);
    }
  }
  return times;
}

/// The median of the samples of each alternative.
inline std::vector<double> medians(const std::vector<std::function<void(int)>>& alternatives,
                                   int calls, int repetitions) {
  std::vector<double> result;
  for (std::vector<double>& times : samples(alternatives, calls, repetitions)) {
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    result.push_back(*middle);
  }
  return result;
}

/// The minimum of the samples of each alternative.
inline std::vector<double> minima(const std::vector<std::function<void(int)>>& alternatives,
                                  int calls, int repetitions) {
  std::vector<double> result;
  for (const std::vector<double>& times : samples(alternatives, calls, repetitions)) {
    result.push_back(*std::min_element(times.begin(), times.end()));
  }
  return result;
}

}  // namespace bench
