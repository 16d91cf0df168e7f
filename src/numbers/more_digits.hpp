// More digits: raises the precision of exact arithmetic (Real and the oracle) during a computation.
// Two results of one exact value may differ because digits cancelled; with more digits the results
// agree. Results that still differ belong to different exact values.
//
// The count belongs to the thread and is not an argument. Numbers become floats deep below
// templates over all scalars (ScalarTraits<Scalar>::from_real, the functions of functions.def), and
// Real is the only scalar with a variable precision. As an argument, the count would have to go
// through every template in between.
#pragma once

namespace elgen {

/// The extra digits of arithmetic. Computations request extra digits by with_digits() and
/// with_enough_digits().
class ExtraDigits {
 public:
  /// The sum of all digits that the running computations of this thread requested.
  [[nodiscard]] static unsigned requested_digits();

  /// Reports that an angle loses `digits` digits: the number of digits before its decimal point.
  static void report_lost(unsigned digits);

  /// Reports an exponential that may hide other terms of a sum: terms that are smaller by `digits`
  /// digits may vanish.
  static void report_hidden(unsigned digits);

  /// The largest argument of report_hidden() since the last call of this function.
  [[nodiscard]] static unsigned take_hidden();

 private:
  template <class Computation>
  friend auto with_digits(unsigned digits, const Computation& computation);
  template <class Computation>
  friend auto with_enough_digits(const Computation& computation);

  explicit ExtraDigits(unsigned digits);
  ~ExtraDigits();
  ExtraDigits(const ExtraDigits&) = delete;
  ExtraDigits& operator=(const ExtraDigits&) = delete;

  /// If arithmetic lost more digits than the extra and the spare digits, requests as many extra
  /// digits as were lost and returns true.
  [[nodiscard]] bool request_lost_digits();

  unsigned digits_;
};

/// Runs a computation with `digits` more digits.
template <class Computation>
auto with_digits(unsigned digits, const Computation& computation) {
  const ExtraDigits more(digits);
  return computation();
}

/// The value of a computation. The computation is repeated with more digits until arithmetic loses
/// no more than the extra and the spare digits. Example: at 64 digits an irrational angle of 1e100
/// has no digits after its decimal point, so its sine has no correct digits.
template <class Computation>
auto with_enough_digits(const Computation& computation) {
  ExtraDigits digits(0);
  auto value = computation();
  while (digits.request_lost_digits()) value = computation();
  return value;
}

}  // namespace elgen
