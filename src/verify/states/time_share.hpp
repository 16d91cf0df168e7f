// TimeShare: how many states a check may visit in its share of the time.
#pragma once

#include <cstddef>

namespace elgen {

class TimeShare {
 public:
  explicit TimeShare(double seconds) : share_(seconds) {}

  /// One more state was visited; `now` in seconds since the check began.
  void add_state(double now);

  /// Whether to visit one more state after `compared` ones that had something to compare. The first
  /// is needed in any case, the second where the first left time over, so that the check takes
  /// twice its share, or one state if that is longer. Others are visited where they fit in, judged
  /// by the slowest so far.
  [[nodiscard]] bool fits_another(std::size_t compared) const;

 private:
  double share_;
  double now_ = 0;
  double slowest_ = 0;
};

}  // namespace elgen
