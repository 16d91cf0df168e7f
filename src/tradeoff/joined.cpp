// joined: parts of a table.
#include <algorithm>
#include <set>

#include "elgen/tradeoff.hpp"

namespace elgen {

TradeoffTable joined(const std::vector<TradeoffTable>& parts) {
  TradeoffTable all = parts.front();
  std::set<std::string> sentences;
  all.rows.clear();
  for (const TradeoffTable& part : parts) {
    all.rows.insert(all.rows.end(), part.rows.begin(), part.rows.end());
    sentences.insert(part.sentences.begin(), part.sentences.end());
  }
  std::ranges::sort(all.rows, {}, &TradeoffRow::number);
  all.sentences.assign(sentences.begin(), sentences.end());
  return all;
}

}  // namespace elgen
