// MoreDigits: while it lives, exact arithmetic has so many decimal digits more than by itself: Real
// and the oracle alike. Where two exact values differ because their digits cancelled, they do not
// with more of them; what differs still is different.
#pragma once

namespace elgen {

class MoreDigits {
 public:
  explicit MoreDigits(unsigned digits);
  ~MoreDigits();
  MoreDigits(const MoreDigits&) = delete;
  MoreDigits& operator=(const MoreDigits&) = delete;

  /// Of all that live in this thread.
  [[nodiscard]] static unsigned count();

 private:
  unsigned digits_;
};

}  // namespace elgen
