// Two states are a check of their own: what one of them hides, by chance, the other shows.
#include "verify/states/time_share.hpp"

#include <algorithm>

namespace elgen {

void TimeShare::add_state(double now) {
  slowest_ = std::max(slowest_, now - now_);
  now_ = now;
}

bool TimeShare::fits_another(std::size_t compared) const {
  if (compared == 0) return true;
  return compared == 1 ? now_ <= share_ : now_ + slowest_ <= share_;
}

}  // namespace elgen
