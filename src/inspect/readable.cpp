// The simplest fraction near x, in exact arithmetic.
#include "inspect/readable.hpp"

#include <cln/float.h>
#include <fmt/format.h>

#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

using cln::cl_R;

constexpr int largest_denominator = 999;  // what a reader still sees as a number

}  // namespace

std::string readable(const cl_R& x) {
  // The rounding that is left of 60 digits when terms of size 1 cancel.
  if (cln::abs(x) < power_of_ten(-40)) return "0";
  // Four digits more than are printed, and far nearer than the 1e-6 at which fractions of such
  // denominators meet any number.
  const auto fraction = simple_fraction(x, largest_denominator, power_of_ten(-9));
  if (fraction) return number_text(*fraction);
  return fmt::format("{:.5g}", cln::double_approx(x));
}

std::string as_typed(const cl_R& x) {
  constexpr std::size_t longest = 30;
  const std::string exact = is_rational(x) ? exact_text(x) : std::string();
  return exact.empty() || exact.size() > longest ? readable(x) : exact;
}

}  // namespace elgen
