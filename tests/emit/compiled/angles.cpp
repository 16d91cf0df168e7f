// detail::SineCosine: in double, which the header is for, sines in line are off by 1.5 ulp, by 0.5
// beside multiples of pi/2, and the library's beyond the domain; other scalars, and all where
// arithmetic is reordered, have the bits of std::sin and std::cos.
#include <cstdio>
#include <limits>
#include <random>

#include "two_link_arm/two_link_arm.hpp"

namespace {

namespace code = two_link_arm::detail;

// By pointers that the compiler cannot look through, so that it does not fuse the two calls itself.
template <class Scalar>
struct Separate {
  Scalar (*volatile sine)(Scalar) = std::sin;
  Scalar (*volatile cosine)(Scalar) = std::cos;
};

template <class Scalar>
bool is_same(Scalar x, Scalar y) {
  return (std::isnan(x) && std::isnan(y)) ||
         (!(x < y) && !(x > y) && std::signbit(x) == std::signbit(y));
}

template <class Scalar>
int differences(const char* type) {
  const Separate<Scalar> separate;
  std::mt19937 random(1);  // NOLINT: the same angles in every run
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  std::uniform_int_distribution<int> exponent(-40, 40);
  int count = 0;
  const auto compare = [&](Scalar angle) {
    if (std::is_same_v<Scalar, double> && std::abs(angle) <= Scalar(1e5)) return;
    const auto [sine, cosine] = code::SineCosine<Scalar>::of(angle);
    if (is_same(sine, separate.sine(angle)) && is_same(cosine, separate.cosine(angle))) return;
    if (++count == 1) std::printf("%s: angle %.20Lg\n", type, static_cast<long double>(angle));
  };
  for (int i = 0; i < 200'000; ++i) {
    compare(static_cast<Scalar>(std::ldexp(mantissa(random), exponent(random))));
    compare(static_cast<Scalar>(4.0 * mantissa(random)));
  }
  using Limits = std::numeric_limits<Scalar>;
  for (const Scalar angle : {Scalar(0), -Scalar(0), Limits::denorm_min(), Limits::min(),
                             Limits::max(), Limits::infinity(), Limits::quiet_NaN()}) {
    compare(angle);
  }
  return count;
}

/// In units of the last place of a truth in more digits.
double error(double value, long double truth) {
  const int last = std::ilogb(truth) + 1 - std::numeric_limits<double>::digits;
  return static_cast<double>(std::abs(static_cast<long double>(value) - truth) /
                             std::ldexp(1.0L, last));
}

double worst_error(double angle) {
  const auto [sine, cosine] = code::SineCosine<double>::of(angle);
  if (!is_same(sine, code::Sine<double>::of(angle))) return 1e9;
  if (!is_same(cosine, code::Cosine<double>::of(angle))) return 1e9;
  const auto exact = static_cast<long double>(angle);
  return std::max(error(sine, std::sin(exact)), error(cosine, std::cos(exact)));
}

/// At angles of all magnitudes; beside multiples of pi/4.
int errors_in_double() {
  std::mt19937 random(2);  // NOLINT: the same angles in every run
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  std::uniform_real_distribution<double> exponent(-300, 5);
  double anywhere = 0;
  for (int i = 0; i < 200'000; ++i) {
    anywhere = std::max(anywhere, worst_error(mantissa(random) * std::pow(10, exponent(random))));
    anywhere = std::max(anywhere, worst_error(1e5 * mantissa(random)));
  }
  double beside = 0;
  const long double eighth = std::acos(-1.0L) / 4;
  for (int i = 1; i < 127'000; ++i) {
    const auto angle = static_cast<double>(static_cast<long double>(i) * eighth);
    double& worst = i % 2 == 0 ? beside : anywhere;
    for (const double to : {0.0, 1e9}) {
      worst = std::max(worst, worst_error(std::nextafter(-angle, -to)));
    }
    worst = std::max(worst, worst_error(angle));
  }
  // x86 and aarch64 have 64 or 113 bits in long double: truths are off by 2^-11 ulp of double.
  if (anywhere <= 1.5 && beside <= 0.502) return 0;
  std::printf("sines in line: off by %.3f ulp, by %.3f beside multiples of pi/2\n", anywhere,
              beside);
  return 1;
}

bool has_sign_of_zero() {
  return std::signbit(code::SineCosine<double>::of(-0.0).sine) &&
         !std::signbit(code::SineCosine<double>::of(0.0).sine) &&
         code::Sine<double>::of(5e-324) > 0;
}

}  // namespace

int main() {
  const int count = differences<float>("float") + differences<double>("double") +
                    differences<long double>("long double");
  if (!has_sign_of_zero()) std::puts("the sign of a zero");
  return count == 0 && errors_in_double() == 0 && has_sign_of_zero() ? 0 : 1;
}
