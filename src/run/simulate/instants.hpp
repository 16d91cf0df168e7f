// Instants: the times at which a run writes rows or renews inputs.
#pragma once

#include <cstdint>
#include <optional>

namespace elgen {

/// Equidistant instants after `begin`, up to `end`; without a period only `end`.
class Instants {
 public:
  Instants(double begin, double end, std::optional<double> period)
      : begin_(begin), end_(end), period_(period.value_or(end - begin)) {}

  /// The first instant after the last pass(). An instant that differs from the end only by rounding
  /// is replaced by the end.
  [[nodiscard]] double next() const {
    const double instant = begin_ + static_cast<double>(passed_ + 1) * period_;
    return instant > end_ - 1e-9 * period_ ? end_ : instant;
  }
  void pass() { ++passed_; }

 private:
  double begin_;
  double end_;
  double period_;
  std::uint64_t passed_ = 0;
};

}  // namespace elgen
