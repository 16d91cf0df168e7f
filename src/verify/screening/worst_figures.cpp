// A heap of those that are kept, with the one to give up on top.
#include "verify/screening/worst_figures.hpp"

#include <algorithm>

namespace elgen {

bool is_worse(const ScreenedFigure& x, const ScreenedFigure& y) {
  if (x.figure > y.figure) return true;
  return x.figure >= y.figure && x.state < y.state;
}

void WorstFigures::add(const ScreenedFigure& figure) {
  if (heap_.size() == most_) {
    if (!is_worse(figure, heap_.front())) return;
    std::pop_heap(heap_.begin(), heap_.end(), is_worse);
    heap_.pop_back();
  }
  heap_.push_back(figure);
  std::push_heap(heap_.begin(), heap_.end(), is_worse);
}

std::vector<ScreenedFigure> WorstFigures::sorted() const {
  std::vector<ScreenedFigure> result = heap_;
  std::sort(result.begin(), result.end(), is_worse);
  return result;
}

}  // namespace elgen
