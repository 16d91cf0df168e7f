// measured: alternatives by turns. Each turn repeats its alternative so often that reading the
// clock is nothing beside it. by_turns: rounds
// in which all are measured once.
#include <algorithm>
#include <chrono>

#include "elgen/tradeoff.hpp"

namespace elgen {
namespace {

using Clock = std::chrono::steady_clock;
using Work = std::function<void()>;

constexpr double shortest_turn = 2e4;  ///< ns; the clock is read in 30

/// ns of one call, in the mean of `calls`.
double duration(const Work& work, std::size_t calls) {
  const Clock::time_point start = Clock::now();
  for (std::size_t call = 0; call < calls; ++call) work();
  const std::chrono::duration<double, std::nano> elapsed = Clock::now() - start;
  return elapsed.count() / static_cast<double>(calls);
}

/// The first call meets cold caches, so the second one counts.
std::size_t calls_of_turn(const Work& work) {
  work();
  const double once = std::max(duration(work, 1), 1.0);
  return 1 + static_cast<std::size_t>(shortest_turn / once);
}

}  // namespace

void by_turns(std::vector<std::vector<double>>& figures, const Rounds& rounds,
              const std::function<double(std::size_t)>& figure) {
  if (figures.empty()) return;
  const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                   std::chrono::duration<double>(rounds.seconds));
  for (std::size_t round = figures.front().size(); round < rounds.most; ++round) {
    if (round >= rounds.fewest && Clock::now() >= end) break;
    for (std::size_t i = 0; i < figures.size(); ++i) figures[i].push_back(figure(i));
  }
}

Spread spread_of(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return {numbers[numbers.size() / 2], numbers[numbers.size() / 4],
          numbers[3 * numbers.size() / 4]};
}

std::vector<Spread> measured(const std::vector<Work>& alternatives, double seconds) {
  std::vector<std::size_t> calls;
  for (const Work& work : alternatives) calls.push_back(calls_of_turn(work));
  std::vector<std::vector<double>> times(alternatives.size());
  by_turns(times, {.seconds = seconds, .fewest = 9, .most = 1001},
           [&](std::size_t i) { return duration(alternatives[i], calls[i]); });
  std::vector<Spread> spreads;
  for (std::vector<double>& of_one : times) spreads.push_back(spread_of(std::move(of_one)));
  return spreads;
}

}  // namespace elgen
