// readable: finds the simplest fraction near x in exact arithmetic.
#include "inspect/readable.hpp"

#include <cln/float.h>
#include <fmt/format.h>

#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

using cln::cl_R;

constexpr int largest_denominator = 999;  // fractions with larger denominators are hard to read

}  // namespace

std::string readable_number(const cl_R& x) {
  // Smaller numbers are rounding errors of 60-digit terms of magnitude 1 that have cancelled.
  if (cln::abs(x) < power_of_ten(-40)) return "0";
  // The tolerance 1e-9 checks four digits more than are printed. With a probability below 0.001, a
  // random number between 0 and 1 is within it of a fraction with a denominator up to 999.
  const auto fraction = simple_fraction(x, largest_denominator, power_of_ten(-9));
  if (fraction) return number_text(*fraction);
  return fmt::format("{:.5g}", cln::double_approx(x));
}

std::string exact_number_text(const cl_R& x) {
  constexpr std::size_t longest = 30;
  const std::string exact = is_rational(x) ? exact_text(x) : std::string();
  return exact.empty() || exact.size() > longest ? readable_number(x) : exact;
}

}  // namespace elgen
