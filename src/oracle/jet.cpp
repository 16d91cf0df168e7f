// Jets: sums merge terms, products multiply terms with disjoint generators. Quotients and functions
// use the chain rule; derivatives of functions come from the table only.
#include "oracle/jet.hpp"

#include <cln/integer.h>

#include <algorithm>
#include <bit>
#include <optional>

#include "numbers/exact_number.hpp"

namespace elgen::oracle {

namespace {

using cln::cl_R;

bool is_exact_zero(const cl_R& x) { return is_rational(x) && cln::zerop(x); }

/// The generators of a product of terms: disjoint sets add to their union, and grades add. Empty if
/// a generator repeats or the grade exceeds its 8 bits, because the product vanishes.
std::optional<Generators> multiply_generators(Generators x, Generators y) {
  const std::uint64_t product = std::uint64_t{x} + y;
  if ((x & y & all_generators) != 0 || product >> 32 != 0) return std::nullopt;
  return static_cast<Generators>(product);
}

/// 1 / y by Newton's r <- r (2 - y r), which doubles the number of correct powers of s.
Jet graded_reciprocal(const Jet& y) {
  Jet r = quotient(1, y.real());
  if (y.lowest_grade() == 0) return r;
  for (unsigned right = 1; right < 256; right *= 2) r = r * (Jet(2) - y * r);
  return r;
}

/// 1 / y, one generator e after another: 1 / (y0 + y1 e) = r - r^2 y1 e with r = 1 / y0.
Jet reciprocal(const Jet& y) {
  const Generators support = y.support();
  Jet result;
  if (support == 0) {
    result = graded_reciprocal(y);
  } else {
    const Generators top = std::bit_floor(support);
    const Jet r = reciprocal(y.without(top));
    result = r - r * r * y.tangent(top) * Jet(top, 1);
  }
  result.depend_on(y, Jet());
  return result;
}

using cln::cl_I;
using cln::cl_RA;

/// x ^ n for n >= 1, by repeated squaring.
Jet integer_power(const Jet& x, const cl_I& n) {
  if (n == 1) return x;
  const Jet root = integer_power(x, cln::floor1(n, 2));
  return cln::oddp(n) ? root * root * x : root * root;
}

/// 0 ^ exponent for a base without generators.
Jet power_of_zero(const cl_RA& exponent) {
  if (exponent <= 0) throw OutsideDomain("zero to a power of zero or less");
  return {};
}

/// While a function is evaluated, this generator and the following ones represent the powers of s.
constexpr unsigned first_power_generator = 16;

/// f(x, y) for jets whose only symbol is s.
template <class Function>
Jet compose_graded(const Jet& x, const Jet& y, const Function& f) {
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

/// How many calls are memoised. The sine and cosine of an angle are each other's derivatives, and
/// other calls come between their uses.
constexpr std::size_t max_memoised_calls = 32;

bool is_graded(const Jet& x) { return x.lowest_grade() != 0; }

/// The power p with f(x + d) - f(x) ~ |d|^p at a point where f has no derivative: acos(1 - d) is
/// sqrt(2 d) to lowest order, p = 1/2. Empty at every other point.
std::optional<cl_RA> kink_order(FunctionId function, const Jet& x, const Jet& y) {
  const bool is_arc = function == FunctionId::asin || function == FunctionId::acos;
  if (is_arc && cln::abs(x.real()) == 1) return cl_RA(1) / 2;
  const bool is_origin = cln::zerop(x.real()) && cln::zerop(y.real());
  if (function == FunctionId::hypot && is_origin) return cl_RA(1);
  return std::nullopt;
}

}  // namespace

bool is_same(const Jet& x, const Jet& y) {
  const auto is_same_term = [](const Jet::Term& a, const Jet::Term& b) {
    return a.first == b.first && is_rational(a.second) == is_rational(b.second) &&
           a.second == b.second;
  };
  return x.dependencies_ == y.dependencies_ && x.order_ == y.order_ &&
         x.unknown_coefficients_ == y.unknown_coefficients_ &&
         std::ranges::equal(x.terms_, y.terms_, is_same_term);
}

Jet::Jet(const cl_R& real) : Jet(0, real) {}

Jet::Jet(Generators generators, const cl_R& coefficient) {
  if (is_exact_zero(coefficient)) return;
  terms_.emplace_back(generators, coefficient);
  dependencies_ = generators & all_generators;
  if (dependencies_ != 0) order_ = static_cast<unsigned>(std::popcount(dependencies_));
}

Jet Jet::with_kink(const cl_R& real, Generators moving, const cl_RA& order) {
  if (order < 1) throw OutsideDomain("an infinite derivative");
  Jet result(real);
  result.dependencies_ = moving;
  result.order_ = cln::cl_I_to_uint(cln::floor1(order));
  const int first_unknown = cln::cl_I_to_int(cln::ceiling1(order));
  for (Generators some = moving; some != 0; some = (some - 1) & moving) {
    if (std::popcount(some) >= first_unknown) result.unknown_coefficients_.push_back(some);
  }
  std::ranges::reverse(result.unknown_coefficients_);
  return result;
}

void Jet::depend_on(const Jet& x, const Jet& y) {
  dependencies_ = x.dependencies_ | y.dependencies_;
  order_ = std::min(x.order_, y.order_);
}

/// 2 if `order_` is 1 and neither a term nor an unknown coefficient is of first order; otherwise
/// `order_`.
unsigned Jet::deviation_order() const {
  const auto is_first = [](Generators g) { return std::has_single_bit(g & all_generators); };
  if (order_ != 1 || std::ranges::any_of(unknown_coefficients_, is_first)) return order_;
  return std::ranges::any_of(terms_, is_first, &Term::first) ? 1 : 2;
}

void Jet::add_term(Generators generators, const cl_R& coefficient) {
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
  if (std::ranges::binary_search(unknown_coefficients_, generators)) {
    throw OutsideDomain("a derivative that does not exist");
  }
  for (const auto& [present, value] : terms_) {
    if (present == generators) return value;
  }
  return 0;
}

Generators Jet::support() const {
  Generators all = 0;
  for (const auto& [present, value] : terms_) all |= present & all_generators;
  for (const Generators present : unknown_coefficients_) all |= present & all_generators;
  return all;
}

void Jet::add_unknown_coefficient(Generators generators) {
  const auto at = std::ranges::lower_bound(unknown_coefficients_, generators);
  if (at == unknown_coefficients_.end() || *at != generators)
    unknown_coefficients_.insert(at, generators);
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
  for (const Generators present : unknown_coefficients_) {
    if ((present & of) == exactly) result.unknown_coefficients_.push_back(present & ~exactly);
  }
  result.dependencies_ = dependencies_ & ~of;
  const auto removed = static_cast<unsigned>(std::popcount(exactly & all_generators));
  if (result.dependencies_ != 0) result.order_ = order_ > removed ? order_ - removed : 1;
  return result;
}

Jet Jet::sum_grades() const {
  Jet result;
  for (const auto& [present, value] : terms_) result.add_term(present & all_generators, value);
  for (const Generators present : unknown_coefficients_)
    result.add_unknown_coefficient(present & all_generators);
  result.depend_on(*this, Jet());
  return result;
}

Jet Jet::nilpotent_part() const {
  Jet result = *this;
  std::erase_if(result.terms_, [](const Term& t) { return t.first == 0 || cln::zerop(t.second); });
  std::erase(result.unknown_coefficients_, Generators{0});
  return result;
}

Jet Jet::absolute_coefficients() const {
  Jet result = *this;
  for (auto& [present, value] : result.terms_) value = cln::abs(value);
  return result;
}

void Jet::shorten() {
  for (auto& [present, value] : terms_) value = shorten_rationals(value);
}

Jet operator+(const Jet& x, const Jet& y) {
  Jet result;
  result.terms_.reserve(x.terms_.size() + y.terms_.size());
  result.terms_ = x.terms_;
  for (const auto& [present, value] : y.terms_) result.add_term(present, value);
  result.unknown_coefficients_ = x.unknown_coefficients_;
  for (const Generators present : y.unknown_coefficients_) result.add_unknown_coefficient(present);
  result.depend_on(x, y);
  return result;
}

Jet operator-(const Jet& x) {
  Jet result = x;
  for (auto& [present, value] : result.terms_) value = -value;
  return result;
}

/// x y - x0 y0 = x0 (y - y0) + (x - x0) y0 + (x - x0) (y - y0)
void Jet::depend_on_factors(const Jet& x, const Jet& y) {
  const auto is_still = [](Generators g) { return (g & all_generators) == 0; };
  const auto has_real = [&](const Jet& z) {
    return std::ranges::any_of(z.terms_, is_still, &Term::first) ||
           std::ranges::any_of(z.unknown_coefficients_, is_still);
  };
  const unsigned of_x = x.deviation_order();
  const unsigned of_y = y.deviation_order();
  order_ = std::min(constant_order, of_x + of_y);
  if (has_real(x)) order_ = std::min(order_, of_y);
  if (has_real(y)) order_ = std::min(order_, of_x);
  dependencies_ = order_ == constant_order ? 0 : x.dependencies_ | y.dependencies_;
}

Jet operator*(const Jet& x, const Jet& y) {
  Jet result;
  result.terms_.reserve(x.terms_.size() * y.terms_.size());
  for (const auto& [in_x, x_value] : x.terms_) {
    for (const auto& [in_y, y_value] : y.terms_) {
      if (const auto both = multiply_generators(in_x, in_y))
        result.add_term(*both, x_value * y_value);
    }
  }
  const auto add_unknown = [&result](Generators one, Generators other) {
    if (const auto both = multiply_generators(one, other)) result.add_unknown_coefficient(*both);
  };
  for (const Generators in_x : x.unknown_coefficients_) {
    for (const auto& [in_y, y_value] : y.terms_) add_unknown(in_x, in_y);
    for (const Generators in_y : y.unknown_coefficients_) add_unknown(in_x, in_y);
  }
  for (const Generators in_y : y.unknown_coefficients_) {
    for (const auto& [in_x, x_value] : x.terms_) add_unknown(in_x, in_y);
  }
  result.depend_on_factors(x, y);
  return result;
}

Jet operator-(const Jet& x, const Jet& y) { return x + (-y); }

Jet operator/(const Jet& x, const Jet& y) {
  if (y.dependencies_ != 0 || y.lowest_grade() != 0) return x * reciprocal(y);
  const cl_R divisor = y.real();
  if (x.terms_.empty()) (void)quotient(0, divisor);
  Jet result = x;
  for (auto& [present, value] : result.terms_) value = quotient(value, divisor);
  return result;
}

Jet JetFunctions::value(FunctionId function, const Jet& x, const Jet& y) {
  const Generators support = x.support() | y.support();
  if (support == 0 && (is_graded(x) || is_graded(y))) {
    return compose_graded(
        x, y, [&](const Jet& at_x, const Jet& at_y) { return value(function, at_x, at_y); });
  }
  const std::optional<cl_RA> bend = kink_order(function, x, y);
  const Generators moving = x.dependencies() | y.dependencies();
  if (bend && moving != 0) {
    const cl_RA order = *bend * std::min(x.deviation_order(), y.deviation_order());
    return Jet::with_kink(real_.value(function, x.real(), y.real()), moving, order);
  }
  if (support == 0) {
    Jet result = real_.value(function, x.real(), y.real());
    if (!is_kinked(function)) result.depend_on(x, y);
    return result;
  }
  const auto known = std::ranges::find_if(memoised_calls_, [&](const Call& call) {
    return call.function == function && is_same(call.x, x) && is_same(call.y, y);
  });
  if (known != memoised_calls_.end()) return known->value;
  const Generators top = std::bit_floor(support);
  const Jet x0 = x.without(top);
  const Jet y0 = y.without(top);
  const Jet f = value(function, x0, y0);
  const Gradient slope = gradient(function, x0, y0, f);
  Jet result = f + (slope.x * x.tangent(top) + slope.y * y.tangent(top)) * Jet(top, 1);
  if (!is_kinked(function)) result.depend_on(x, y);
  memoised_calls_.push_front({function, x, y, result});
  if (memoised_calls_.size() > max_memoised_calls) memoised_calls_.pop_back();
  return result;
}

JetFunctions::Gradient JetFunctions::gradient(FunctionId function, const Jet& x, const Jet& y,
                                              const Jet& f) {
  const Jet one = 1;
  // NOLINTBEGIN(bugprone-macro-parentheses): the macros declare the name.
#define ELGEN_CALL_1(name) \
  [[maybe_unused]] const auto name = [this](const Jet& of) { return value(FunctionId::name, of); };
#define ELGEN_CALL_2(name)                                                  \
  [[maybe_unused]] const auto name = [this](const Jet& of, const Jet& by) { \
    return value(FunctionId::name, of, by);                                 \
  };
  // NOLINTEND(bugprone-macro-parentheses)
#define ELGEN_FUNCTION(name, arity) ELGEN_CALL_##arity(name)
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
#undef ELGEN_CALL_1
#undef ELGEN_CALL_2
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
    if (n > 0) return integer_power(x, n);
    if (cln::zerop(x.real())) throw OutsideDomain("zero to a power of zero or less");
    return n == 0 ? Jet(1) : Jet(1) / integer_power(x, -n);
  }
  if (support == 0 && is_graded(x)) {
    return compose_graded(x, Jet(), [&](const Jet& at, const Jet&) { return power(at, exponent); });
  }
  const bool is_zero = cln::zerop(x.real());
  if (is_zero && exponent > 0 && x.dependencies() != 0 && !is_graded(x)) {
    return Jet::with_kink(0, x.dependencies(), exponent * x.deviation_order());
  }
  Jet result;
  if (support == 0) {
    result = is_zero ? power_of_zero(exponent) : Jet(real_power(x.real(), exponent));
  } else {
    const Generators top = std::bit_floor(support);
    const Jet x0 = x.without(top);
    const Jet slope = Jet(exponent) * power(x0, exponent - 1);
    result = power(x0, exponent) + slope * x.tangent(top) * Jet(top, 1);
  }
  result.depend_on(x, Jet());
  return result;
}

}  // namespace elgen::oracle
