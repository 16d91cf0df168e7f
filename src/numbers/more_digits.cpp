// More digits: the counters of each thread.
#include "numbers/more_digits.hpp"

#include <algorithm>
#include <utility>

namespace elgen {
namespace {

/// The digits that computations in this thread requested, and the digits that arithmetic reported
/// as lost and as hidden.
struct DigitsOfThread {
  unsigned requested = 0;
  unsigned lost = 0;
  unsigned hidden = 0;
};

DigitsOfThread& digits_of_thread() {
  thread_local DigitsOfThread digits;
  return digits;
}

/// A computation may lose this many digits without being repeated. Checks need 50 of Real's 64
/// digits, and the oracle guarantees 60 of its 95.
constexpr unsigned spare_digits = 10;

}  // namespace

MoreDigits::MoreDigits(unsigned digits) : digits_(digits) {
  digits_of_thread().requested += digits;
  digits_of_thread().lost = 0;
}

MoreDigits::~MoreDigits() { digits_of_thread().requested -= digits_; }

bool MoreDigits::grow() {
  const unsigned lost = std::exchange(digits_of_thread().lost, 0U);
  if (lost <= digits_ + spare_digits) return false;
  digits_of_thread().requested += lost - digits_;
  digits_ = lost;
  return true;
}

unsigned MoreDigits::count() { return digits_of_thread().requested; }

void MoreDigits::report_lost(unsigned digits) {
  unsigned& lost = digits_of_thread().lost;
  lost = std::max(lost, digits);
}

void MoreDigits::report_hidden(unsigned digits) {
  unsigned& hidden = digits_of_thread().hidden;
  hidden = std::max(hidden, digits);
}

unsigned MoreDigits::hidden() { return std::exchange(digits_of_thread().hidden, 0U); }

}  // namespace elgen
