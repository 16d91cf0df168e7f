// sine_polynomials: the table, and the least degree that will do.
#include "evaluate/sine_polynomials.hpp"

#include <algorithm>

#include "base/exact_number.hpp"

namespace elgen {
namespace {

constexpr AngleReduction in_float{ScalarKind::single_precision,
                                  1e3,
                                  0x1.9218p+0,
                                  0x1.ed511p-14,
                                  0x1.45f306p-1,
                                  0x1.8p+23,
                                  0x1p-24};
constexpr AngleReduction in_double{
    ScalarKind::double_precision, 1e5,       0x1.921fb5444p+0, 0x1.68c234c4c6629p-39,
    0x1.45f306dc9c883p-1,         0x1.8p+52, 0x1p-53};

}  // namespace

const std::vector<SinePolynomial>& sine_polynomials() {
  static const std::vector<SinePolynomial> all{
#define ELGEN_SINE(degree, error, ...) {degree, error, {__VA_ARGS__}},
#define ELGEN_COSINE(degree, error, ...)
#include "evaluate/sine_polynomials.def"
  };
  return all;
}

const std::vector<SinePolynomial>& cosine_polynomials() {
  static const std::vector<SinePolynomial> all{
#define ELGEN_SINE(degree, error, ...)
#define ELGEN_COSINE(degree, error, ...) {degree, error, {__VA_ARGS__}},
#include "evaluate/sine_polynomials.def"
  };
  return all;
}

const AngleReduction& angle_reduction(ScalarKind scalar) {
  return scalar == ScalarKind::single_precision ? in_float : in_double;
}

const SinePolynomial& cheapest(const std::vector<SinePolynomial>& all, const cln::cl_RA& max_error,
                               ScalarKind scalar) {
  const cln::cl_RA rounding = exact_value(angle_reduction(scalar).rounding);
  const auto found = std::find_if(all.begin(), all.end(), [&](const SinePolynomial& polynomial) {
    return exact_value(polynomial.error) + rounding <= max_error;
  });
  return found == all.end() ? all.back() : *found;
}

}  // namespace elgen
