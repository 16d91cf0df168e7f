// "did you mean": the candidate at the smallest optimal-string-alignment distance, if it is near
// enough.
#include <algorithm>
#include <array>

#include "elgen/diagnostic.hpp"

namespace elgen {

namespace {

/// Insertions, deletions, substitutions and transpositions of neighbours that turn `a` into `b`.
std::size_t distance(std::string_view a, std::string_view b) {
  std::array<std::vector<std::size_t>, 3> rows;
  for (auto& row : rows) row.assign(b.size() + 1, 0);
  for (std::size_t j = 0; j <= b.size(); ++j) rows[1][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    auto& [before, above, here] = rows;
    here[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitution = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      here[j] = std::min({above[j] + 1, here[j - 1] + 1, substitution});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) here[j] = std::min(here[j], before[j - 2] + 1);
    }
    std::rotate(rows.begin(), rows.begin() + 1, rows.end());
  }
  return rows[1][b.size()];
}

}  // namespace

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t longest_word = 64;  // beyond, nobody means a near miss
  if (word.empty() || word.size() > longest_word) return {};
  // One slip in a short word, one in three letters of a long one.
  const std::size_t allowed = std::max<std::size_t>(1, word.size() / 3);
  std::size_t best = allowed + 1;
  std::string result;
  for (const std::string& candidate : candidates) {
    if (candidate.size() > longest_word) continue;
    const std::size_t steps = distance(word, candidate);
    const bool replaces_all = steps >= std::max(word.size(), candidate.size());
    if (steps < best && !replaces_all) {
      best = steps;
      result = candidate;
    }
  }
  return result;
}

}  // namespace elgen
