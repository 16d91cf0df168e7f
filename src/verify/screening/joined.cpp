// What shards and processes found, joined, and what is visited of it.
#include <algorithm>
#include <set>

#include "elgen/screening.hpp"
#include "verify/screening/worst_figures.hpp"

namespace elgen {
namespace {

/// Of every region and large enough for the checks of structure, which look at ordinary states.
constexpr std::uint64_t first_states = 64;

void join(ScreenedStates& all, const ScreenedStates& part) {
  all.states += part.states;
  for (std::size_t i = 0; i < part.worst.size(); ++i) {
    WorstFigures worst(visits_after_screening);
    for (const ScreenedFigure& figure : all.worst[i]) worst.add(figure);
    for (const ScreenedFigure& figure : part.worst[i]) worst.add(figure);
    all.worst[i] = worst.sorted();
  }
}

}  // namespace

Screening joined(const std::vector<Screening>& shards) {
  Screening all = shards.front();
  for (std::size_t i = 1; i < shards.size(); ++i) {
    for (std::size_t scalar = 0; scalar < all.size(); ++scalar) {
      join(all[scalar], shards[i][scalar]);
    }
  }
  return all;
}

std::vector<std::uint64_t> states_to_visit(const ScreenedStates& screened) {
  std::set<std::uint64_t> chosen;
  for (std::uint64_t i = 0; i < std::min(first_states, screened.states); ++i) chosen.insert(i);
  for (std::size_t rank = 0; rank < visits_after_screening; ++rank) {
    for (const std::vector<ScreenedFigure>& worst : screened.worst) {
      if (chosen.size() == visits_after_screening) return {chosen.begin(), chosen.end()};
      if (rank < worst.size()) chosen.insert(worst[rank].state);
    }
  }
  return {chosen.begin(), chosen.end()};
}

}  // namespace elgen
