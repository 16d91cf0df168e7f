// MoreDigits: while it lives, exact arithmetic has so many decimal digits more than by itself: Real
// and the oracle alike. Where two exact values differ because their digits cancelled, they do not
// with more of them; what differs still is different.
#pragma once

namespace elgen {

class MoreDigits {
 public:
  explicit MoreDigits(unsigned digits = 0);
  ~MoreDigits();
  MoreDigits(const MoreDigits&) = delete;
  MoreDigits& operator=(const MoreDigits&) = delete;

  /// Grows by what arithmetic has lost since then, where that is more than it can spare: an angle
  /// of 1e100 that is no rational leaves none of 64 behind the point, for sines to be made of.
  ///
  ///     MoreDigits digits;
  ///     do { computation } while (digits.grow());
  [[nodiscard]] bool grow();

  /// Of all that live in this thread.
  [[nodiscard]] static unsigned count();

  /// Arithmetic tells of an angle with so many digits before its point.
  static void lose(unsigned digits);

 private:
  unsigned digits_;
};

}  // namespace elgen
