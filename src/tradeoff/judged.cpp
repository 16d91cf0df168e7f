// judged: the order of the rows, the front, and what is chosen from them.
#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "elgen/tradeoff.hpp"

namespace elgen {
namespace {

bool is_better(const TradeoffRow& x, const TradeoffRow& y) {
  const bool is_as_good = x.cost.median <= y.cost.median && x.error.worst <= y.error.worst;
  return is_as_good && (x.cost.median < y.cost.median || x.error.worst < y.error.worst);
}

}  // namespace

TradeoffTable judged(TradeoffTable table) {
  const auto key = [](const TradeoffRow& row) {
    return std::tuple(!row.failure.empty(), row.cost.median);
  };
  std::ranges::stable_sort(table.rows, {}, key);
  for (TradeoffRow& row : table.rows) {
    const auto beats_it = [&row](const TradeoffRow& other) {
      return other.failure.empty() && is_better(other, row);
    };
    row.is_on_front = row.failure.empty() && !row.is_below_reference &&
                      std::ranges::none_of(table.rows, beats_it);
  }
  return table;
}

std::string name_of(const TradeoffRow& row) {
  return fmt::format("{}", fmt::join(row.values, ", "));
}

const TradeoffRow* cheapest_within(const TradeoffTable& table, double max_error) {
  const auto found = std::ranges::find_if(table.rows, [max_error](const TradeoffRow& row) {
    return row.failure.empty() && row.error.worst <= max_error;
  });
  return found == table.rows.end() ? nullptr : &*found;
}

const TradeoffRow* most_accurate(const TradeoffTable& table) {
  const TradeoffRow* best = nullptr;
  for (const TradeoffRow& row : table.rows) {
    const bool is_best = best == nullptr || row.error.worst < best->error.worst;
    if (row.failure.empty() && is_best) best = &row;
  }
  return best;
}

}  // namespace elgen
