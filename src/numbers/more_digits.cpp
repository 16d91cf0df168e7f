// More digits: one sum per thread.
#include "numbers/more_digits.hpp"

#include <algorithm>
#include <utility>

namespace elgen {
namespace {

thread_local unsigned all_digits = 0;
thread_local unsigned lost_digits = 0;
thread_local unsigned hidden_digits = 0;

/// Real agrees to 50 digits of 64 with a bound that knows the slope of a sine, and the oracle
/// promises 60 of 95: so many may go.
constexpr unsigned spare_digits = 10;

}  // namespace

MoreDigits::MoreDigits(unsigned digits) : digits_(digits) {
  all_digits += digits;
  lost_digits = 0;
}

MoreDigits::~MoreDigits() { all_digits -= digits_; }

bool MoreDigits::grow() {
  const unsigned lost = std::exchange(lost_digits, 0);
  if (lost <= digits_ + spare_digits) return false;
  all_digits += lost - digits_;
  digits_ = lost;
  return true;
}

unsigned MoreDigits::count() { return all_digits; }

void MoreDigits::lose(unsigned digits) { lost_digits = std::max(lost_digits, digits); }

void MoreDigits::hide(unsigned digits) { hidden_digits = std::max(hidden_digits, digits); }

unsigned MoreDigits::hidden() { return std::exchange(hidden_digits, 0U); }

}  // namespace elgen
