// WorstFigures: the largest of many figures, whatever the order they come in.
#pragma once

#include <vector>

#include "elgen/screening.hpp"

namespace elgen {

/// The larger figure; of equal ones that of the earlier state.
[[nodiscard]] bool is_worse(const ScreenedFigure& x, const ScreenedFigure& y);

class WorstFigures {
 public:
  /// Keeps `most`. Cost: log `most` of a figure that is among the worst so far, else 1.
  explicit WorstFigures(std::size_t most) : most_(most) {}

  void add(const ScreenedFigure& figure);

  /// Worst first.
  [[nodiscard]] std::vector<ScreenedFigure> sorted() const;

 private:
  std::size_t most_;
  std::vector<ScreenedFigure> heap_ = {};  ///< the least of them first
};

}  // namespace elgen
