// `scalars TYPE` evaluates the functions of one model in the scalar TYPE. Floating-point values are
// compared with values in 50 digits, derivatives with the emitted Jacobian.
#include <Eigen/Core>
#include <array>
#include <boost/math/differentiation/autodiff.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/numeric/interval.hpp>
#include <cmath>
#include <complex>
#include <cstdio>
#include <experimental/simd>
#include <string_view>
#include <unsupported/Eigen/AutoDiff>

#if __has_include(<ceres/jet.h>)
#include <ceres/jet.h>
#endif

// The C++17 library has no functions of __float128, so this file declares functions of libquadmath.
// The declarations must precede the emitted header.
extern "C" {
__float128 sinq(__float128) noexcept;
__float128 cosq(__float128) noexcept;
__float128 sqrtq(__float128) noexcept;
}
namespace std {
inline __float128 sin(__float128 x) { return ::sinq(x); }
inline __float128 cos(__float128 x) { return ::cosq(x); }
inline __float128 sqrt(__float128 x) { return ::sqrtq(x); }
}  // namespace std

#include "swing_fixed/swing_fixed.hpp"

namespace {

namespace emitted = swing_fixed;

using Reference = boost::multiprecision::cpp_bin_float_50;

template <class Scalar>
using Pair = std::array<Scalar, 2>;

constexpr Pair<double> place{0.375, 0.8125};
constexpr Pair<double> rates{0.5, -1.25};

/// Both accelerations and the potential energy.
template <class Scalar>
std::array<Scalar, 3> values(const Pair<Scalar>& q, const Pair<Scalar>& v) {
  const emitted::Parameters<Scalar> p{};
  const auto a = emitted::forward_dynamics<Scalar>(p, q, v, {}).acceleration;
  return {a[0], a[1], emitted::potential_energy<Scalar>(p, q)};
}

template <class Scalar>
std::array<Scalar, 3> values() {
  return values<Scalar>({Scalar(place[0]), Scalar(place[1])}, {Scalar(rates[0]), Scalar(rates[1])});
}

int failures = 0;

void expect(bool is_right, const char* what, double value) {
  if (is_right) return;
  ++failures;
  std::printf("%s: %.17g\n", what, value);
}

/// All digits of a number, as a sum of at most three doubles.
template <class Number>
Reference exact(Number x) {
  Reference sum = 0;
  for (int part = 0; part < 3; ++part) {
    const double leading = static_cast<double>(x);
    sum += leading;
    x = x - static_cast<Number>(leading);
  }
  return sum;
}

template <class Number>
void check_digits(double tolerance) {
  const auto reference = values<Reference>();
  const auto found = values<Number>();
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Reference off = (exact(found[i]) - reference[i]) / reference[i];
    const double error = std::abs(static_cast<double>(off));
    expect(error <= tolerance, "relative error", error);
  }
}

/// Checks that the reference with 50 digits agrees with double.
void check_reference() {
  const auto in_double = values<double>();
  const auto reference = values<Reference>();
  for (std::size_t i = 0; i < in_double.size(); ++i) {
    const double value = static_cast<double>(reference[i]);
    expect(std::abs(value - in_double[i]) <= 1e-14 * std::abs(value), "in 50 digits", value);
  }
}

/// A number with its derivative in one direction.
struct Dual {
  double value = 0;
  double slope = 0;

  Dual() = default;
  Dual(double number, double rate = 0) : value(number), slope(rate) {}

  friend Dual operator-(const Dual& x) { return {-x.value, -x.slope}; }
  friend Dual operator+(const Dual& x, const Dual& y) {
    return {x.value + y.value, x.slope + y.slope};
  }
  friend Dual operator-(const Dual& x, const Dual& y) {
    return {x.value - y.value, x.slope - y.slope};
  }
  friend Dual operator*(const Dual& x, const Dual& y) {
    return {x.value * y.value, x.slope * y.value + x.value * y.slope};
  }
  friend Dual operator/(const Dual& x, const Dual& y) {
    const double quotient = x.value / y.value;
    return {quotient, (x.slope - quotient * y.slope) / y.value};
  }
  friend Dual sin(const Dual& x) { return {std::sin(x.value), std::cos(x.value) * x.slope}; }
  friend Dual cos(const Dual& x) { return {std::cos(x.value), -std::sin(x.value) * x.slope}; }
  friend Dual sqrt(const Dual& x) {
    const double root = std::sqrt(x.value);
    return {root, x.slope / (root + root)};
  }
};

/// Like Dual, but only an explicit conversion makes a Strict from a number.
struct Strict {
  using Scalar = double;
  Dual dual;

  Strict() = default;
  explicit Strict(const double& number) : dual(number) {}
  explicit Strict(const Dual& x) : dual(x) {}

  [[maybe_unused]] friend Strict operator-(const Strict& x) { return Strict(-x.dual); }
  friend Strict operator+(const Strict& x, const Strict& y) { return Strict(x.dual + y.dual); }
  friend Strict operator-(const Strict& x, const Strict& y) { return Strict(x.dual - y.dual); }
  friend Strict operator*(const Strict& x, const Strict& y) { return Strict(x.dual * y.dual); }
  friend Strict operator/(const Strict& x, const Strict& y) { return Strict(x.dual / y.dual); }
  friend Strict sin(const Strict& x) { return Strict(sin(x.dual)); }
  friend Strict cos(const Strict& x) { return Strict(cos(x.dual)); }
  friend Strict sqrt(const Strict& x) { return Strict(sqrt(x.dual)); }
};

/// Checks values and slopes in Scalar: `made(x, slope)` makes a Scalar, and `split` inverts `made`.
template <class Scalar, class Make, class Split>
void check_slopes(const Make& made, const Split& split) {
  const emitted::Parameters<double> p{};
  const auto jacobian = emitted::forward_dynamics_derivatives<double>(p, place, rates, {});
  const auto in_double = values<double>();
  for (std::size_t k = 0; k < 4; ++k) {
    const auto argument = [&](double x, std::size_t at) { return made(x, at == k ? 1.0 : 0.0); };
    const auto found = values<Scalar>({argument(place[0], 0), argument(place[1], 1)},
                                      {argument(rates[0], 2), argument(rates[1], 3)});
    for (std::size_t i = 0; i < 2; ++i) {
      const auto& matrix = k < 2 ? jacobian.by_position : jacobian.by_velocity;
      const double slope = matrix[2 * i + k % 2];
      const Dual parts = split(found[i]);
      expect(std::abs(parts.value - in_double[i]) <= 1e-13 * std::abs(in_double[i]), "value",
             parts.value);
      expect(std::abs(parts.slope - slope) <= 1e-13 * (1 + std::abs(slope)), "slope", parts.slope);
    }
  }
}

void check_complex() {
  using Complex = std::complex<double>;
  constexpr double step = 1e-100;
  check_slopes<Complex>([](double x, double slope) { return Complex(x, slope * step); },
                        [](const Complex& x) { return Dual(x.real(), x.imag() / step); });
}

void check_dual() {
  check_slopes<Dual>([](double x, double slope) { return Dual(x, slope); },
                     [](const Dual& x) { return x; });
}

void check_strict() {
  check_slopes<Strict>([](double x, double slope) { return Strict(Dual(x, slope)); },
                       [](const Strict& x) { return x.dual; });
}

void check_jet() {
#if __has_include(<ceres/jet.h>)
  using Jet = ceres::Jet<double, 2>;
  check_slopes<Jet>(
      [](double x, double slope) {
        Jet made(x);
        made.v[1] = slope;
        return made;
      },
      [](const Jet& x) { return Dual(x.a, x.v[1]); });
#else
  expect(false, "ceres is not installed", 0);
#endif
}

/// Checks derivatives by fvar of order 2, which has elements beyond the first derivative.
void check_fvar() {
  using Fvar = boost::math::differentiation::autodiff_fvar<double, 2>;
  check_slopes<Fvar>(
      [](double x, double slope) {
        const bool is_variable = slope > 0;
        return is_variable ? boost::math::differentiation::make_fvar<double, 2>(x) : Fvar(x);
      },
      [](const Fvar& x) { return Dual(x.derivative(0), x.derivative(1)); });
}

void check_autodiff() {
  using Slope = Eigen::Matrix<double, 1, 1>;
  using AutoDiff = Eigen::AutoDiffScalar<Slope>;
  check_slopes<AutoDiff>([](double x, double slope) { return AutoDiff(x, Slope::Constant(slope)); },
                         [](const AutoDiff& x) { return Dual(x.value(), x.derivatives()[0]); });
}

/// Checks that every interval contains the value in double and is narrow.
void check_interval() {
  namespace policy = boost::numeric::interval_lib;
  using Interval = boost::numeric::interval<
      double, policy::policies<policy::save_state<policy::rounded_transc_std<double>>,
                               policy::checking_base<double>>>;
  const auto in_double = values<double>();
  const auto found = values<Interval>();
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double rounding = 1e-14 * std::abs(in_double[i]);
    expect(found[i].lower() <= in_double[i] + rounding, "lower end", found[i].lower());
    expect(found[i].upper() >= in_double[i] - rounding, "upper end", found[i].upper());
    const double width = found[i].upper() - found[i].lower();
    expect(width > 0 && width <= 1e-11, "width", width);
  }
}

void check_simd() {
  using Pack = std::experimental::native_simd<double>;
  Pair<Pack> q{Pack(place[0]), Pack(place[1])};
  const Pair<Pack> v{Pack(rates[0]), Pack(rates[1])};
  const auto offset = [](std::size_t lane) { return 0.25 * static_cast<double>(lane); };
  for (std::size_t lane = 0; lane < Pack::size(); ++lane) q[1][lane] = place[1] + offset(lane);
  const auto found = values<Pack>(q, v);
  for (std::size_t lane = 0; lane < Pack::size(); ++lane) {
    const auto single = values<double>({place[0], place[1] + offset(lane)}, rates);
    for (std::size_t i = 0; i < single.size(); ++i) {
      const double value = found[i][lane];
      expect(std::abs(value - single[i]) <= 1e-13 * (1 + std::abs(single[i])), "lane", value);
    }
  }
}

struct Row {
  std::string_view type;
  void (*check)();
};
constexpr std::array rows{
    Row{"float", [] { check_digits<float>(1e-5); }},
    Row{"double", [] { check_digits<double>(1e-14); }},
    Row{"long_double", [] { check_digits<long double>(1e-17); }},
    Row{"float128", [] { check_digits<__float128>(1e-32); }},
    Row{"cpp_bin_float", &check_reference},
    Row{"complex", &check_complex},
    Row{"dual", &check_dual},
    Row{"strict", &check_strict},
    Row{"jet", &check_jet},
    Row{"fvar", &check_fvar},
    Row{"interval", &check_interval},
    Row{"autodiff", &check_autodiff},
    Row{"simd", &check_simd},
};

}  // namespace

int main(int argc, char** argv) {
  for (const Row& row : rows) {
    if (argc != 2 || row.type != argv[1]) continue;
    row.check();
    return failures == 0 ? 0 : 1;
  }
  std::puts("no such type");
  return 2;
}
