// Interval arithmetic without changing the rounding mode. The sign of the rounding error of a sum,
// product, quotient or root can be computed. This sign decides which bound must move outwards.
#include "numbers/enclosure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi_below = 0x1.921fb54442d18p1;  // pi - pi_below is 1.2e-16
constexpr Enclosure no_value{infinity, -infinity, Definedness::nowhere};

double next_below(double x) { return std::nextafter(x, -infinity); }
double next_above(double x) { return std::nextafter(x, infinity); }

/// A result rounded to nearest, and `error`, a number with the sign of exact - rounded; NaN if the
/// sign is unknown.
struct RoundedResult {
  double value;
  double error;
};

double round_down(const RoundedResult& x) {
  return x.error < 0 || std::isnan(x.error) ? next_below(x.value) : x.value;
}
double round_up(const RoundedResult& x) {
  return x.error > 0 || std::isnan(x.error) ? next_above(x.value) : x.value;
}

/// Knuth's two-sum: the error is exact unless the sum overflows.
RoundedResult rounded_sum(double x, double y) {
  const double sum = x + y;
  if (!std::isfinite(sum)) return {sum, std::isinf(x) || std::isinf(y) ? 0 : NAN};
  const double back = sum - x;
  return {sum, (x - (sum - back)) + (y - back)};
}

/// The rounding error of a product or quotient smaller than this may underflow.
constexpr double smallest_product = 0x1p-960;

/// 0 if a factor is 0, even if the other is infinite: infinite bounds enclose finite numbers only.
RoundedResult rounded_product(double x, double y) {
  if (x == 0 || y == 0) return {0, 0};
  const double product = x * y;
  if (!std::isfinite(product)) return {product, std::isinf(x) || std::isinf(y) ? 0 : NAN};
  if (std::abs(product) < smallest_product) return {product, NAN};
  return {product, std::fma(x, y, -product)};
}

RoundedResult rounded_quotient(double x, double y) {
  if (x == 0) return {0, 0};
  const double quotient = x / y;
  const bool is_exact_at_infinity = std::isinf(x) && !std::isinf(y);
  if (!std::isfinite(quotient)) return {quotient, is_exact_at_infinity ? 0 : NAN};
  if (std::abs(x) < smallest_product || std::abs(quotient) < smallest_product) {
    return {quotient, NAN};
  }
  const double rest = std::fma(-quotient, y, x);
  return {quotient, y < 0 ? -rest : rest};
}

RoundedResult rounded_root(double x) {
  const double root = std::sqrt(x);
  if (!std::isfinite(root)) return {root, 0};
  if (x != 0 && x < smallest_product) return {root, NAN};
  return {root, std::fma(-root, root, x)};
}

/// The enclosed numbers are finite, so a lower bound of +infinity is replaced by the largest
/// double, and an upper bound of -infinity by the lowest.
double finite_lower_bound(double x) {
  return x == infinity ? std::numeric_limits<double>::max() : x;
}
double finite_upper_bound(double x) {
  return x == -infinity ? std::numeric_limits<double>::lowest() : x;
}

Enclosure make_enclosure(double low, double high, Definedness defined) {
  return {finite_lower_bound(low), finite_upper_bound(high), defined};
}

/// The enclosure of all four corners.
Enclosure hull(const std::array<RoundedResult, 4>& corners, Definedness defined) {
  double low = infinity;
  double high = -infinity;
  for (const RoundedResult& corner : corners) {
    low = std::min(low, round_down(corner));
    high = std::max(high, round_up(corner));
  }
  return make_enclosure(low, high, defined);
}

Definedness joint_definedness(const Enclosure& x, const Enclosure& y) {
  return std::max(x.definedness, y.definedness);
}

bool is_undefined(const Enclosure& x) { return x.definedness == Definedness::nowhere; }

/// Error bound for a value of a C library: 8 ulp.
double library_error(double value) { return std::abs(value) * 0x1p-49 + 0x1p-1070; }
double library_lower_bound(double value) {
  return std::isfinite(value) ? value - library_error(value) : value;
}
double library_upper_bound(double value) {
  return std::isfinite(value) ? value + library_error(value) : value;
}

/// f(x) for an increasing function f with values in [least, greatest].
template <class F>
Enclosure increasing_function(const F& f, const Enclosure& x, double least = -infinity,
                              double greatest = infinity) {
  if (is_undefined(x)) return x;
  return make_enclosure(std::max(library_lower_bound(f(x.low)), least),
                        std::min(library_upper_bound(f(x.high)), greatest), x.definedness);
}

/// The part of x inside the domain [least, greatest] of a function.
Enclosure clip_to_domain(const Enclosure& x, double least, double greatest) {
  if (is_undefined(x) || x.high < least || x.low > greatest) return no_value;
  const bool is_inside = x.low >= least && x.high <= greatest;
  return {std::max(x.low, least), std::min(x.high, greatest),
          is_inside ? x.definedness : Definedness::somewhere};
}

/// True if x may contain first + k period for an integer k. The slack covers the rounding error of
/// the period, half an ulp per turn.
bool may_contain_multiple(const Enclosure& x, double first, double period) {
  const auto turns = [&](double at) { return (at - first) / period; };
  const double slack = 0x1p-49 * (1 + std::abs(turns(x.low)) + std::abs(turns(x.high)));
  return std::floor(turns(x.high) + slack) >= turns(x.low) - slack;
}

/// The position of a larger angle within one period is too uncertain.
constexpr double largest_angle = 1e9;

/// Sine or cosine, with its maxima at top + 2 k pi.
template <class F>
Enclosure sinusoid(const F& f, const Enclosure& x, double top) {
  if (is_undefined(x)) return x;
  if (magnitude(x) > largest_angle) return {-1, 1, x.definedness};
  const double first = f(x.low);
  const double last = f(x.high);
  const double high = may_contain_multiple(x, top, 2 * pi_below)
                          ? 1
                          : std::min(library_upper_bound(std::max(first, last)), 1.0);
  const double low = may_contain_multiple(x, top + pi_below, 2 * pi_below)
                         ? -1
                         : std::max(library_lower_bound(std::min(first, last)), -1.0);
  return {low, high, x.definedness};
}

Enclosure square(const Enclosure& x) {
  if (is_undefined(x)) return x;
  const double largest = magnitude(x);
  const bool holds_zero = x.low <= 0 && x.high >= 0;
  const double least = holds_zero ? 0 : std::min(std::abs(x.low), std::abs(x.high));
  return make_enclosure(std::max(round_down(rounded_product(least, least)), 0.0),
                        round_up(rounded_product(largest, largest)), x.definedness);
}

}  // namespace

bool may_contain(const Enclosure& enclosure, double x) {
  return !is_undefined(enclosure) && enclosure.low <= x && x <= enclosure.high;
}

double magnitude(const Enclosure& x) { return std::max(std::abs(x.low), std::abs(x.high)); }

Enclosure ScalarTraits<Enclosure>::from_real(const cln::cl_R& value) {
  const double nearest = to_double(value);
  if (!std::isfinite(nearest)) return make_enclosure(nearest, nearest, Definedness::everywhere);
  const cln::cl_R exact = exact_value(nearest);
  return {exact > value ? next_below(nearest) : nearest,
          exact < value ? next_above(nearest) : nearest};
}

Enclosure operator-(const Enclosure& x) {
  return is_undefined(x) ? x : Enclosure{-x.high, -x.low, x.definedness};
}

Enclosure operator+(const Enclosure& x, const Enclosure& y) {
  if (is_undefined(x) || is_undefined(y)) return no_value;
  return make_enclosure(round_down(rounded_sum(x.low, y.low)),
                        round_up(rounded_sum(x.high, y.high)), joint_definedness(x, y));
}

Enclosure operator-(const Enclosure& x, const Enclosure& y) { return x + (-y); }

Enclosure operator*(const Enclosure& x, const Enclosure& y) {
  if (is_undefined(x) || is_undefined(y)) return no_value;
  if (&x == &y) return square(x);
  const std::array products{rounded_product(x.low, y.low), rounded_product(x.low, y.high),
                            rounded_product(x.high, y.low), rounded_product(x.high, y.high)};
  return hull(products, joint_definedness(x, y));
}

Enclosure operator*(const Enclosure& x, int factor) {
  return x * point_enclosure(static_cast<double>(factor));
}

Enclosure operator/(const Enclosure& x, const Enclosure& y) {
  if (is_undefined(x) || is_undefined(y) || (y.low == 0 && y.high == 0)) return no_value;
  if (may_contain(y, 0)) return {-infinity, infinity, Definedness::somewhere};
  const std::array quotients{rounded_quotient(x.low, y.low), rounded_quotient(x.low, y.high),
                             rounded_quotient(x.high, y.low), rounded_quotient(x.high, y.high)};
  return hull(quotients, joint_definedness(x, y));
}

Enclosure sqrt(const Enclosure& x) {
  const Enclosure radicand = clip_to_domain(x, 0, infinity);
  if (is_undefined(radicand)) return radicand;
  return make_enclosure(std::max(round_down(rounded_root(radicand.low)), 0.0),
                        round_up(rounded_root(radicand.high)), radicand.definedness);
}

Enclosure sin(const Enclosure& x) {
  return sinusoid([](double angle) { return std::sin(angle); }, x, pi_below / 2);
}

Enclosure cos(const Enclosure& x) {
  return sinusoid([](double angle) { return std::cos(angle); }, x, 0);
}

Enclosure tan(const Enclosure& x) {
  if (is_undefined(x)) return x;
  if (magnitude(x) > largest_angle || may_contain_multiple(x, pi_below / 2, pi_below)) {
    return {-infinity, infinity, Definedness::somewhere};
  }
  return increasing_function([](double angle) { return std::tan(angle); }, x);
}

#define ELGEN_RISING(name, ...)                                                       \
  Enclosure name(const Enclosure& x) {                                                \
    return increasing_function([](double at) { return std::name(at); }, __VA_ARGS__); \
  }
ELGEN_RISING(asin, clip_to_domain(x, -1, 1))
ELGEN_RISING(atan, x)
ELGEN_RISING(sinh, x)
ELGEN_RISING(tanh, x, -1, 1)
ELGEN_RISING(asinh, x)
ELGEN_RISING(exp, x, 0)
ELGEN_RISING(expm1, x, -1)
#undef ELGEN_RISING

Enclosure acos(const Enclosure& x) {
  return -increasing_function([](double cosine) { return -std::acos(cosine); },
                              clip_to_domain(x, -1, 1));
}

/// The angle whose tangent is x / y. If the box has no point with x = 0 and y <= 0, the angle is
/// monotone along every edge, so the angles at the corners bound the angle.
Enclosure atan2(const Enclosure& x, const Enclosure& y) {
  if (is_undefined(x) || is_undefined(y)) return no_value;
  if (y.low <= 0 && may_contain(x, 0)) {
    return {library_lower_bound(-pi_below), library_upper_bound(pi_below), Definedness::somewhere};
  }
  const std::array angles{std::atan2(x.low, y.low), std::atan2(x.low, y.high),
                          std::atan2(x.high, y.low), std::atan2(x.high, y.high)};
  return {library_lower_bound(*std::ranges::min_element(angles)),
          library_upper_bound(*std::ranges::max_element(angles)), joint_definedness(x, y)};
}

Enclosure cosh(const Enclosure& x) {
  if (is_undefined(x)) return x;
  const Enclosure size = abs(x);
  return increasing_function([](double value) { return std::cosh(value); }, size, 1);
}

Enclosure log(const Enclosure& x) {
  if (is_undefined(x) || x.high <= 0) return no_value;
  Enclosure result = increasing_function([](double value) { return std::log(value); },
                                         clip_to_domain(x, 0, infinity));
  if (x.low <= 0) result.definedness = Definedness::somewhere;
  return result;
}

Enclosure log1p(const Enclosure& x) {
  if (is_undefined(x) || x.high <= -1) return no_value;
  Enclosure result = increasing_function([](double value) { return std::log1p(value); },
                                         clip_to_domain(x, -1, infinity));
  if (x.low <= -1) result.definedness = Definedness::somewhere;
  return result;
}

Enclosure hypot(const Enclosure& x, const Enclosure& y) {
  if (is_undefined(x) || is_undefined(y)) return no_value;
  const Enclosure width = abs(x);
  const Enclosure height = abs(y);
  return make_enclosure(std::max(library_lower_bound(std::hypot(width.low, height.low)), 0.0),
                        library_upper_bound(std::hypot(width.high, height.high)),
                        joint_definedness(x, y));
}

/// c_k(x) with k = y, which must be a single integer. c_k increases with |x| for k < 0 and
/// decreases for k > 2; c_1 decreases up to 4.49. c_2(x) = c_1(x/2)^2/2.
Enclosure stumpff(const Enclosure& x, const Enclosure& y) {
  constexpr double least_sinc = -0.2172337;
  constexpr double far = 1e150;            // x^2 overflows beyond this
  constexpr double more_errors = 0x1p-49;  // the error is up to 17 u, at k = -36
  if (is_undefined(x) || is_undefined(y)) return no_value;
  const Enclosure size = abs(x);
  if (y.low < 0) {
    const auto f = [&](double value) { return interpreter::stumpff(std::min(value, far), y.low); };
    return increasing_function(f, size, 0) * Enclosure{1 - more_errors, 1 + more_errors};
  }
  if (y.low == 2) {
    const Enclosure ratio = stumpff(x / point_enclosure(2), point_enclosure(1));
    return ratio * ratio / point_enclosure(2);
  }
  if (y.low > 2 || size.high < 4) {
    const double greatest = interpreter::stumpff(std::min(size.low, far), y.low);
    const double least = size.high < far ? interpreter::stumpff(size.high, y.low) : 0;
    return {library_lower_bound(least), library_upper_bound(greatest), x.definedness};
  }
  if (size.low == 0) return {least_sinc, 1, x.definedness};
  const Enclosure ratio = sin(size) / size;
  return {std::max(ratio.low, least_sinc), std::min(ratio.high, 1.0), x.definedness};
}

Enclosure abs(const Enclosure& x) {
  if (is_undefined(x)) return x;
  const double least = may_contain(x, 0) ? 0 : std::min(std::abs(x.low), std::abs(x.high));
  return {least, magnitude(x), x.definedness};
}

/// The enclosure of sign(x) = -1, 0 or 1. If the bounds of x have different signs, the definedness
/// is `somewhere`, because sign(x) is not continuous at 0.
Enclosure sign(const Enclosure& x) {
  if (is_undefined(x)) return x;
  const auto of = [](double value) { return value > 0 ? 1.0 : value < 0 ? -1.0 : 0.0; };
  const bool jumps = of(x.low) != of(x.high);
  return {of(x.low), of(x.high), jumps ? Definedness::somewhere : x.definedness};
}

Enclosure min(const Enclosure& x, const Enclosure& y) {
  if (is_undefined(x) || is_undefined(y)) return no_value;
  return {std::min(x.low, y.low), std::min(x.high, y.high), joint_definedness(x, y)};
}

Enclosure max(const Enclosure& x, const Enclosure& y) {
  if (is_undefined(x) || is_undefined(y)) return no_value;
  return {std::max(x.low, y.low), std::max(x.high, y.high), joint_definedness(x, y)};
}

}  // namespace elgen
