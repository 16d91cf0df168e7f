// Jets: sums merge terms, products multiply terms of disjoint generators, quotients go by the chain
// rule, and so do functions: their derivatives are those of the table and nothing else.
#include "oracle/jet.hpp"

#include <cln/integer.h>

#include <algorithm>
#include <bit>

#include "numbers/exact_number.hpp"

namespace elgen::oracle {

namespace {

using cln::cl_R;

bool is_exact_zero(const cl_R& x) { return is_rational(x) && cln::zerop(x); }

/// Newton's r <- r (2 - y r) doubles the number of powers of s that are right.
Jet graded_reciprocal(const Jet& y) {
  Jet r = quotient(1, y.real());
  if (y.lowest_grade() == 0) return r;
  for (unsigned right = 1; right < 256; right *= 2) r = r * (Jet(2) - y * r);
  return r;
}

/// 1 / (y0 + y1 e) = r - r^2 y1 e with r = 1 / y0.
Jet reciprocal(const Jet& y) {
  const Generators support = y.support();
  if (support == 0) return graded_reciprocal(y);
  const Generators top = std::bit_floor(support);
  const Jet r = reciprocal(y.without(top));
  return r - r * r * y.tangent(top) * Jet(top, 1);
}

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

/// A sine and a cosine of one angle are each other's derivatives, and so are their parts with fewer
/// generators; a few angles may be between them.
constexpr std::size_t remembered_calls = 32;

/// As numbers, and exact alike.
bool is_same(const Jet& x, const Jet& y) {
  return std::ranges::equal(x.terms(), y.terms(), [](const Jet::Term& a, const Jet::Term& b) {
    return a.first == b.first && is_rational(a.second) == is_rational(b.second) &&
           a.second == b.second;
  });
}

bool is_graded(const Jet& x) { return x.lowest_grade() != 0; }

}  // namespace

Jet::Jet(const cl_R& real) : Jet(0, real) {}

Jet::Jet(Generators generators, const cl_R& coefficient) {
  if (!is_exact_zero(coefficient)) terms_.emplace_back(generators, coefficient);
}

void Jet::add(Generators generators, const cl_R& coefficient) {
  const auto at = std::lower_bound(terms_.begin(), terms_.end(), generators,
                                   [](const Term& t, Generators g) { return t.first < g; });
  if (at == terms_.end() || at->first != generators) {
    if (!is_exact_zero(coefficient)) terms_.insert(at, Term(generators, coefficient));
    return;
  }
  at->second = at->second + coefficient;
  if (is_exact_zero(at->second)) terms_.erase(at);
}

cl_R Jet::coefficient(Generators generators) const {
  for (const auto& [present, value] : terms_) {
    if (present == generators) return value;
  }
  return 0;
}

Generators Jet::support() const {
  Generators all = 0;
  for (const auto& [present, value] : terms_) all |= present & all_generators;
  return all;
}

Generators Jet::lowest_grade() const {
  Generators lowest = 0;
  for (const auto& [present, value] : terms_) {
    const Generators grade = present & ~all_generators;
    if (grade != 0 && (lowest == 0 || grade < lowest)) lowest = grade;
  }
  return lowest;
}

Jet Jet::part(Generators of, Generators exactly) const {
  Jet result;
  for (const auto& [present, value] : terms_) {
    if ((present & of) == exactly) result.terms_.emplace_back(present & ~exactly, value);
  }
  return result;
}

Jet Jet::ungraded() const {
  Jet result;
  for (const auto& [present, value] : terms_) result.add(present & all_generators, value);
  return result;
}

Jet Jet::magnitudes() const {
  Jet result = *this;
  for (auto& [present, value] : result.terms_) value = cln::abs(value);
  return result;
}

void Jet::shorten() {
  for (auto& [present, value] : terms_) value = shortened(value);
}

Jet operator+(const Jet& x, const Jet& y) {
  Jet result;
  result.terms_.reserve(x.terms_.size() + y.terms_.size());
  result.terms_ = x.terms_;
  for (const auto& [present, value] : y.terms_) result.add(present, value);
  return result;
}

Jet operator-(const Jet& x) {
  Jet result = x;
  for (auto& [present, value] : result.terms_) value = -value;
  return result;
}

Jet operator*(const Jet& x, const Jet& y) {
  Jet result;
  result.terms_.reserve(x.terms_.size() * y.terms_.size());
  for (const auto& [in_x, x_value] : x.terms_) {
    for (const auto& [in_y, y_value] : y.terms_) {
      // The sum of disjoint sets is their union; grades that vanish carry over.
      const std::uint64_t product = std::uint64_t{in_x} + in_y;
      const bool vanishes = (in_x & in_y & all_generators) != 0 || product >> 32 != 0;
      if (!vanishes) result.add(static_cast<Generators>(product), x_value * y_value);
    }
  }
  return result;
}

Jet operator-(const Jet& x, const Jet& y) { return x + (-y); }

Jet operator/(const Jet& x, const Jet& y) {
  if (y.support() != 0 || y.lowest_grade() != 0) return x * reciprocal(y);
  Jet result;
  for (const auto& [present, value] : x.terms()) {
    result = result + Jet(present, quotient(value, y.real()));
  }
  return x.terms().empty() ? Jet(quotient(0, y.real())) : result;
}

Jet JetFunctions::value(FunctionId function, const Jet& x, const Jet& y) {
  const Generators support = x.support() | y.support();
  if (support == 0 && (is_graded(x) || is_graded(y))) {
    return composed(x, y,
                    [&](const Jet& at_x, const Jet& at_y) { return value(function, at_x, at_y); });
  }
  if (support == 0) return real_.value(function, x.real(), y.real());
  const auto known = std::ranges::find_if(known_, [&](const Call& call) {
    return call.function == function && is_same(call.x, x) && is_same(call.y, y);
  });
  if (known != known_.end()) return known->value;
  const Generators top = std::bit_floor(support);
  const Jet x0 = x.without(top);
  const Jet y0 = y.without(top);
  const Jet f = value(function, x0, y0);
  const Gradient slope = gradient(function, x0, y0, f);
  const Jet result = f + (slope.x * x.tangent(top) + slope.y * y.tangent(top)) * Jet(top, 1);
  known_.push_front({function, x, y, result});
  if (known_.size() > remembered_calls) known_.pop_back();
  return result;
}

JetFunctions::Gradient JetFunctions::gradient(FunctionId function, const Jet& x, const Jet& y,
                                              const Jet& f) {
  const Jet one = 1;
  const auto sin = [this](const Jet& z) { return value(FunctionId::sin, z); };
  const auto cos = [this](const Jet& z) { return value(FunctionId::cos, z); };
  const auto sinh = [this](const Jet& z) { return value(FunctionId::sinh, z); };
  const auto cosh = [this](const Jet& z) { return value(FunctionId::cosh, z); };
  const auto exp = [this](const Jet& z) { return value(FunctionId::exp, z); };
  const auto stumpff = [this](const Jet& z, const Jet& k) {
    return value(FunctionId::stumpff, z, k);
  };
  const auto sqrt = [this](const Jet& z) { return power(z, cl_RA(1) / 2); };
  switch (function) {
#define ELGEN_DERIVATIVES(name, arity, first, second) \
  case FunctionId::name:                              \
    return {first, second};
#include "base/function_derivatives.def"
#undef ELGEN_DERIVATIVES
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
