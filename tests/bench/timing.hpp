// Interleaved timing of alternatives in one run, so that they meet the same machine: medians of
// many short repetitions.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <vector>

namespace bench {

/// The compiler has to make `value` and must assume that it changes.
template <class Value>
void keep(const Value& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

/// Median nanoseconds per call of each alternative, `calls` calls a repetition, all in turn.
inline std::vector<double> medians(const std::vector<std::function<void(int)>>& alternatives,
                                   int calls, int repetitions) {
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
  std::vector<double> result;
  for (std::vector<double>& samples : times) {
    const auto middle = samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2);
    std::nth_element(samples.begin(), middle, samples.end());
    result.push_back(*middle);
  }
  return result;
}

}  // namespace bench
