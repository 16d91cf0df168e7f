// Jets: sums merge terms, products multiply terms of disjoint generators, quotients go by the chain
// rule.
#include "oracle/jet.hpp"

#include <algorithm>
#include <bit>

#include "base/exact_number.hpp"
#include "oracle/real_functions.hpp"

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
  Jet result = x;
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
  for (const auto& [in_x, x_value] : x.terms_) {
    for (const auto& [in_y, y_value] : y.terms_) {
      // Of disjoint sets the sum is the union, and grades carry over where they vanish.
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

}  // namespace elgen::oracle
