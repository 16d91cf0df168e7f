// The simplest fraction near x by continued fractions, in exact arithmetic.
#include "inspect/readable.hpp"

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/rational.h>
#include <fmt/format.h>

#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

using cln::cl_I;
using cln::cl_R;
using cln::cl_RA;

constexpr int largest_denominator = 999;  // what a reader still sees as a number

}  // namespace

std::string readable(const cl_R& x) {
  // The rounding that is left of 64 digits when terms of size 1 cancel.
  if (cln::abs(x) < power_of_ten(-40)) return "0";
  // Convergents h/k of the continued fraction of x, until one is near enough or too long.
  cl_I h = 1, h_before = 0, k = 0, k_before = 1;
  for (cl_R rest = x;;) {
    const cl_I whole = cln::floor1(rest);
    const cl_I next_h = whole * h + h_before;
    const cl_I next_k = whole * k + k_before;
    h_before = h;
    k_before = k;
    h = next_h;
    k = next_k;
    if (k > largest_denominator) break;
    const cl_RA convergent = cl_RA(h) / k;
    // Four digits more than are printed, and far nearer than the 1e-6 at which fractions of such
    // denominators meet any number.
    if (cln::abs(x - convergent) < cln::abs(x) * power_of_ten(-9)) return number_text(convergent);
    rest = 1 / (rest - whole);
  }
  return fmt::format("{:.5g}", cln::double_approx(x));
}

std::string as_typed(const cl_R& x) {
  constexpr std::size_t longest = 30;
  const std::string exact = is_rational(x) ? exact_text(x) : std::string();
  return exact.empty() || exact.size() > longest ? readable(x) : exact;
}

}  // namespace elgen
