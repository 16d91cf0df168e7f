// by_turns: rounds in which all are measured once.
#include <chrono>

#include "elgen/tradeoff.hpp"

namespace elgen {

void by_turns(std::vector<std::vector<double>>& figures, const Rounds& rounds,
              const std::function<double(std::size_t)>& figure) {
  using Clock = std::chrono::steady_clock;
  if (figures.empty()) return;
  const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                   std::chrono::duration<double>(rounds.seconds));
  for (std::size_t round = figures.front().size(); round < rounds.most; ++round) {
    if (round >= rounds.fewest && Clock::now() >= end) break;
    for (std::size_t i = 0; i < figures.size(); ++i) figures[i].push_back(figure(i));
  }
}

}  // namespace elgen
