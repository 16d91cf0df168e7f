// Functions of jets: see the header. The derivatives are those of functions.def and nothing else.
#include "oracle/jet_functions.hpp"

#include <cln/integer.h>

#include <bit>

namespace elgen::oracle {
namespace {

using cln::cl_I;
using cln::cl_RA;

/// x ^ n for n >= 1, by squaring.
Jet whole_power(const Jet& x, const cl_I& n) {
  if (n == 1) return x;
  const Jet root = whole_power(x, cln::floor1(n, 2));
  return cln::oddp(n) ? root * root * x : root * root;
}

/// 0 ^ exponent, without generators.
Jet power_of_zero(const cl_RA& exponent) {
  if (exponent <= 0) throw OutsideDomain("zero to a power of zero or less");
  return {};
}

/// Generators from here on stand for powers of s while a function is evaluated.
constexpr unsigned first_power_generator = 16;

/// f(x, y) for jets in s alone.
template <class Function>
Jet composed(const Jet& x, const Jet& y, const Function& f) {
  Generators lowest = x.lowest_grade();
  const Generators of_y = y.lowest_grade();
  if (lowest == 0 || (of_y != 0 && of_y < lowest)) lowest = of_y;
  const unsigned degree = 255 / (lowest >> first_grade_bit);
  Jet e;
  for (unsigned j = 0; j < degree; ++j) e = e + Jet(generator(first_power_generator + j), 1);
  const Jet x0 = x.real();
  const Jet y0 = y.real();
  const Jet value = f(x0 + (x - x0) * e, y0 + (y - y0) * e);
  Jet sum = value.real();
  Generators all = 0;
  cl_I factorial = 1;
  for (unsigned j = 0; j < degree; ++j) {
    all |= generator(first_power_generator + j);
    factorial = factorial * (j + 1);
    sum = sum + value.part(all) * Jet(cl_RA(1) / factorial);
  }
  return sum;
}

bool is_graded(const Jet& x) { return x.lowest_grade() != 0; }

}  // namespace

Jet JetFunctions::value(FunctionId function, const Jet& x, const Jet& y) {
  const Generators support = x.support() | y.support();
  if (support == 0 && (is_graded(x) || is_graded(y))) {
    return composed(x, y,
                    [&](const Jet& at_x, const Jet& at_y) { return value(function, at_x, at_y); });
  }
  if (support == 0) return real_.value(function, x.real(), y.real());
  const Generators top = std::bit_floor(support);
  const Jet x0 = x.without(top);
  const Jet y0 = y.without(top);
  const Jet f = value(function, x0, y0);
  const Gradient slope = gradient(function, x0, y0, f);
  return f + (slope.x * x.tangent(top) + slope.y * y.tangent(top)) * Jet(top, 1);
}

JetFunctions::Gradient JetFunctions::gradient(FunctionId function, const Jet& x, const Jet& y,
                                              const Jet& f) {
  const Jet one = 1;
  const auto sin = [this](const Jet& z) { return value(FunctionId::sin, z); };
  const auto cos = [this](const Jet& z) { return value(FunctionId::cos, z); };
  const auto sinh = [this](const Jet& z) { return value(FunctionId::sinh, z); };
  const auto cosh = [this](const Jet& z) { return value(FunctionId::cosh, z); };
  const auto sqrt = [this](const Jet& z) { return power(z, cl_RA(1) / 2); };
  switch (function) {
#define ELGEN_FUNCTION(name, arity, use, parity, smoothness, first, second) \
  case FunctionId::name:                                                    \
    return {first, second};
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
  }
  throw OutsideDomain("function without a derivative");
}

Jet JetFunctions::power(const Jet& x, const cl_RA& exponent) {
  const Generators support = x.support();
  if (cln::denominator(exponent) == 1) {
    const cl_I n = cln::numerator(exponent);
    if (n > 0) return whole_power(x, n);
    if (cln::zerop(x.real())) throw OutsideDomain("zero to a power of zero or less");
    return n == 0 ? Jet(1) : Jet(1) / whole_power(x, -n);
  }
  if (support == 0 && is_graded(x)) {
    return composed(x, Jet(), [&](const Jet& at, const Jet&) { return power(at, exponent); });
  }
  if (support == 0) {
    return cln::zerop(x.real()) ? power_of_zero(exponent) : Jet(real_power(x.real(), exponent));
  }
  const Generators top = std::bit_floor(support);
  const Jet x0 = x.without(top);
  const Jet slope = Jet(exponent) * power(x0, exponent - 1);
  return power(x0, exponent) + slope * x.tangent(top) * Jet(top, 1);
}

}  // namespace elgen::oracle
