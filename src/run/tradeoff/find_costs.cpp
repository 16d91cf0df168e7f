// measure_costs: times every work once per round. Each timing repeats the work until the cost of
// reading the clock is negligible.
#include <algorithm>
#include <chrono>

#include "elgen/tradeoff.hpp"

namespace elgen {
namespace {

using Clock = std::chrono::steady_clock;
using Work = std::function<void()>;

constexpr double min_timing_ns = 2e4;  ///< of one timing, in ns; reading the clock takes 30 ns
constexpr std::size_t fewest_rounds = 9;
constexpr std::size_t most_rounds = 1001;

/// The mean duration of a call in ns, measured over `calls` calls.
double mean_duration(const Work& work, std::size_t calls) {
  const Clock::time_point start = Clock::now();
  for (std::size_t call = 0; call < calls; ++call) work();
  const std::chrono::duration<double, std::nano> elapsed = Clock::now() - start;
  return elapsed.count() / static_cast<double>(calls);
}

/// The number of calls in one timing. The second call is measured, because caches are cold at the
/// first call.
std::size_t calls_per_timing(const Work& work) {
  work();
  const double once = std::max(mean_duration(work, 1), 1.0);
  return 1 + static_cast<std::size_t>(min_timing_ns / once);
}

/// Median, lower and upper quartile. `numbers` must not be empty.
Quartiles quartiles_of(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return {numbers[numbers.size() / 2], numbers[numbers.size() / 4],
          numbers[3 * numbers.size() / 4]};
}

}  // namespace

void measure_costs(const std::vector<TimedWork>& works, double seconds) {
  if (works.empty()) return;
  std::vector<std::size_t> calls;
  for (const TimedWork& work : works) calls.push_back(calls_per_timing(work.run));
  std::vector<std::vector<double>> times(works.size());
  const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                   std::chrono::duration<double>(seconds));
  for (std::size_t round = 0; round < most_rounds; ++round) {
    if (round >= fewest_rounds && Clock::now() >= end) break;
    for (std::size_t i = 0; i < works.size(); ++i) {
      times[i].push_back(mean_duration(works[i].run, calls[i]) /
                         static_cast<double>(works[i].parts));
    }
  }
  for (std::size_t i = 0; i < works.size(); ++i) *works[i].cost = quartiles_of(std::move(times[i]));
}

}  // namespace elgen
