// More digits: while a computation runs, exact arithmetic has so many decimal digits more than by
// itself: Real and the oracle alike. Where two exact values differ because their digits cancelled,
// they do not with more of them; what differs still is different.
//
// The count belongs to the thread and is no argument: numbers become floats deep below templates
// over all scalars (ScalarTraits<Scalar>::from_real, the functions of functions.def), and Real is
// the only scalar that has digits to choose. Every template between would have to pass them on.
#pragma once

namespace elgen {

/// Arithmetic asks for its digits here; computations ask for more of them below.
class MoreDigits {
 public:
  /// All that the running computations of this thread asked for.
  [[nodiscard]] static unsigned count();

  /// Arithmetic tells of an angle with so many digits before its point.
  static void lose(unsigned digits);

  /// Arithmetic tells of an exponential: a sum with it may hide terms so many digits smaller.
  static void hide(unsigned digits);

  /// The most digits that were told to hide() since the last call.
  [[nodiscard]] static unsigned hidden();

 private:
  template <class Computation>
  friend auto with_digits(unsigned digits, const Computation& computation);
  template <class Computation>
  friend auto with_enough_digits(const Computation& computation);

  explicit MoreDigits(unsigned digits);
  ~MoreDigits();
  MoreDigits(const MoreDigits&) = delete;
  MoreDigits& operator=(const MoreDigits&) = delete;

  /// Grows by what arithmetic has lost, where that is more than it can spare.
  [[nodiscard]] bool grow();

  unsigned digits_;
};

/// Evaluates a computation with so many digits more.
template <class Computation>
auto with_digits(unsigned digits, const Computation& computation) {
  const MoreDigits more(digits);
  return computation();
}

/// Evaluates a computation again with as many digits more as it lost, until it has enough: an angle
/// of 1e100 that is no rational has none of 64 digits behind the point, so that its sine has none.
template <class Computation>
auto with_enough_digits(const Computation& computation) {
  MoreDigits digits(0);
  auto value = computation();
  while (digits.grow()) value = computation();
  return value;
}

}  // namespace elgen
