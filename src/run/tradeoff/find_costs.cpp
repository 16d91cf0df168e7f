// measure_costs: times every work once per round. Each timing repeats the work until the cost of
// reading the clock is negligible.
#include <algorithm>
#include <array>
#include <chrono>
#include <limits>

#include "elgen/tradeoff.hpp"

namespace elgen {
namespace {

using Clock = std::chrono::steady_clock;
using Work = std::function<void()>;

constexpr double min_timing_ns = 2e4;  ///< of one timing, in ns; reading the clock takes 30 ns
constexpr std::size_t fewest_rounds = 10;
constexpr std::size_t most_rounds = 1000;

/// The mean duration of a call in ns, measured over `calls` calls. A call before them is not
/// measured, because other works have filled the caches.
double mean_duration(const Work& work, std::size_t calls) {
  work();
  const Clock::time_point start = Clock::now();
  for (std::size_t call = 0; call < calls; ++call) work();
  const std::chrono::duration<double, std::nano> elapsed = Clock::now() - start;
  return elapsed.count() / static_cast<double>(calls);
}

std::size_t calls_per_timing(const Work& work) {
  const double once = std::max(mean_duration(work, 1), 1.0);
  return 1 + static_cast<std::size_t>(min_timing_ns / once);
}

}  // namespace

void measure_costs(const std::vector<TimedWork>& works, double seconds) {
  if (works.empty()) return;
  std::vector<std::size_t> calls;
  for (const TimedWork& work : works) calls.push_back(calls_per_timing(work.run));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector least(works.size(), std::array{infinity, infinity});  // of even and odd rounds
  const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                   std::chrono::duration<double>(seconds));
  for (std::size_t round = 0; round < most_rounds; ++round) {
    if (round >= fewest_rounds && Clock::now() >= end) break;
    for (std::size_t i = 0; i < works.size(); ++i) {
      const double time =
          mean_duration(works[i].run, calls[i]) / static_cast<double>(works[i].parts);
      least[i][round % 2] = std::min(least[i][round % 2], time);
    }
  }
  for (std::size_t i = 0; i < works.size(); ++i) {
    const auto [low, high] = std::minmax(least[i][0], least[i][1]);
    *works[i].cost = {low, high / low - 1};
  }
}

}  // namespace elgen
