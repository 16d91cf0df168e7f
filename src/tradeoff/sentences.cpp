// Sentences compare all pairs of rows that differ in one dimension alone.
#include "tradeoff/sentences.hpp"

#include <fmt/format.h>

#include <cmath>

namespace elgen {
namespace {

/// What differs by less is alike.
constexpr double least_ratio = 1.05;

/// What two values of a dimension differ by most: `more` has `ratio` times what `less` has.
struct LargestRatio {
  double ratio = 1;
  std::string more = {};
  std::string less = {};

  void see(double x, const std::string& of_x, double y, const std::string& of_y) {
    if (!(x > 0 && y > 0 && std::isfinite(x) && std::isfinite(y))) return;
    if (x > y && x / y > ratio) *this = {x / y, of_x, of_y};
    if (y > x && y / x > ratio) *this = {y / x, of_y, of_x};
  }
};

bool overlap(const Spread& x, const Spread& y) { return x.low <= y.high && y.low <= x.high; }

/// Whether the rows differ in this dimension and in no other.
bool differ_in(const TradeoffRow& x, const TradeoffRow& y, std::size_t dimension) {
  for (std::size_t i = 0; i < x.values.size(); ++i) {
    if ((x.values[i] != y.values[i]) != (i == dimension)) return false;
  }
  return true;
}

std::string sentence_of(const TradeoffTable& table, std::size_t dimension) {
  LargestRatio cost;
  LargestRatio error;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const TradeoffRow& x = table.rows[j];
      const TradeoffRow& y = table.rows[i];
      const bool is_pair = x.failure.empty() && y.failure.empty() && differ_in(x, y, dimension);
      if (!is_pair) continue;
      const std::string& of_x = x.values[dimension];
      const std::string& of_y = y.values[dimension];
      if (!overlap(x.cost, y.cost)) cost.see(x.cost.median, of_x, y.cost.median, of_y);
      error.see(x.error.worst, of_x, y.error.worst, of_y);
    }
  }
  const std::string speed =
      cost.ratio < least_ratio
          ? "what it does to speed is noise"
          : fmt::format("{} is up to {:.2g} times as fast as {}", cost.less, cost.ratio, cost.more);
  const std::string errors = error.ratio < least_ratio
                                 ? "errors stay"
                                 : fmt::format("{} has up to {:.2g} times the error of {}",
                                               error.more, error.ratio, error.less);
  return fmt::format("{}: {}; {}", table.dimensions[dimension], speed, errors);
}

}  // namespace

std::vector<std::string> sentences_of(const TradeoffTable& table) {
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < table.dimensions.size(); ++i) {
    sentences.push_back(sentence_of(table, i));
  }
  return sentences;
}

}  // namespace elgen
