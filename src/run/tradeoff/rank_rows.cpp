// rank_rows: ranks and sorts the rows, and marks the Pareto front. Also finds the picked row.
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "elgen/tradeoff.hpp"

namespace elgen {
namespace {

/// True if `cost` exceeds `than` by more than the noise of `than`.
bool is_more_expensive(const MeasuredCost& cost, const MeasuredCost& than) {
  return cost.least > std::max(equality_factor, 1 + than.noise) * than.least;
}

/// Ranks the rows that have not failed, by cost.
void assign_ranks(std::vector<TradeoffRow>& rows) {
  std::vector<TradeoffRow*> by_cost;
  for (TradeoffRow& row : rows) {
    if (row.failure.empty()) by_cost.push_back(&row);
  }
  std::ranges::stable_sort(by_cost, {}, [](const TradeoffRow* row) { return row->cost.least; });
  const TradeoffRow* cheapest = nullptr;
  for (TradeoffRow* const row : by_cost) {
    const bool is_next = cheapest == nullptr || is_more_expensive(row->cost, cheapest->cost);
    row->rank = (cheapest == nullptr ? 0 : cheapest->rank) + (is_next ? 1 : 0);
    if (is_next) cheapest = row;
  }
}

}  // namespace

TradeoffTable rank_rows(TradeoffTable table) {
  assign_ranks(table.rows);
  std::ranges::stable_sort(table.rows, {}, [](const TradeoffRow& row) {
    return std::tuple(!row.failure.empty(), row.rank, row.error.worst);
  });
  // If the relative error exceeds 1, no digit is correct.
  constexpr double largest_error = 1;
  double least = std::numeric_limits<double>::infinity();
  for (TradeoffRow& row : table.rows) {
    if (!row.failure.empty()) break;
    const double error = row.error.worst;
    row.is_on_pareto_front = error <= largest_error && equality_factor * error < least;
    if (row.is_on_pareto_front) least = std::min(least, row.error.least);
  }
  return table;
}

std::string name_of(const TradeoffRow& row) {
  return fmt::format("{}", fmt::join(row.values, ", "));
}

const TradeoffRow* cheapest_accurate_row(const TradeoffTable& table, double max_error) {
  const auto found = std::ranges::find_if(table.rows, [max_error](const TradeoffRow& row) {
    return row.failure.empty() && row.error.worst <= max_error;
  });
  return found == table.rows.end() ? nullptr : &*found;
}

const TradeoffRow* picked_row(const TradeoffTable& table) {
  return table.max_error ? cheapest_accurate_row(table, *table.max_error) : nullptr;
}

const TradeoffRow* most_accurate_row(const TradeoffTable& table) {
  const TradeoffRow* best = nullptr;
  for (const TradeoffRow& row : table.rows) {
    const bool is_best = best == nullptr || row.error.worst < best->error.worst;
    if (row.failure.empty() && is_best) best = &row;
  }
  return best;
}

}  // namespace elgen
