// MoreDigits: one sum per thread.
#include "base/more_digits.hpp"

namespace elgen {
namespace {

thread_local unsigned all_digits = 0;

}  // namespace

MoreDigits::MoreDigits(unsigned digits) : digits_(digits) { all_digits += digits; }

MoreDigits::~MoreDigits() { all_digits -= digits_; }

unsigned MoreDigits::count() { return all_digits; }

}  // namespace elgen
