// More digits: the counters of each thread.
#include "numbers/more_digits.hpp"

#include <algorithm>
#include <utility>

namespace elgen {
namespace {

/// The digits that computations in this thread requested, and the digits that arithmetic reported
/// as lost and as hidden.
struct ThreadDigits {
  unsigned requested = 0;
  unsigned lost = 0;
  unsigned hidden = 0;
};

ThreadDigits& thread_digits() {
  thread_local ThreadDigits digits;
  return digits;
}

/// A computation may lose this many digits without being repeated. Checks need 50 of Real's 64
/// digits, and the oracle guarantees 60 of its 95.
constexpr unsigned spare_digits = 10;

}  // namespace

ExtraDigits::ExtraDigits(unsigned digits) : digits_(digits) {
  thread_digits().requested += digits;
  thread_digits().lost = 0;
}

ExtraDigits::~ExtraDigits() { thread_digits().requested -= digits_; }

bool ExtraDigits::request_lost_digits() {
  const unsigned lost = std::exchange(thread_digits().lost, 0U);
  if (lost <= digits_ + spare_digits) return false;
  thread_digits().requested += lost - digits_;
  digits_ = lost;
  return true;
}

unsigned ExtraDigits::requested_digits() { return thread_digits().requested; }

void ExtraDigits::report_lost(unsigned digits) {
  unsigned& lost = thread_digits().lost;
  lost = std::max(lost, digits);
}

void ExtraDigits::report_hidden(unsigned digits) {
  unsigned& hidden = thread_digits().hidden;
  hidden = std::max(hidden, digits);
}

unsigned ExtraDigits::take_hidden() { return std::exchange(thread_digits().hidden, 0U); }

}  // namespace elgen
