// Tests detail::SineCosine. In-line sines and cosines have errors up to 1.5 ulp in double and 0.9
// ulp in float; near multiples of pi/2 the errors are up to 0.5 ulp. Beyond `domain` and in long
// double the values have the bits of std::sin and std::cos. detail::sines_of computes several
// angles with the bits of SineCosine, even if some of the angles are beyond `domain`.
#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <random>
#include <utility>

#include "two_link_arm/two_link_arm.hpp"

namespace {

namespace code = two_link_arm::detail;

// Calls through volatile pointers, so that the compiler cannot fuse sine and cosine.
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

/// The largest |angle| whose sine is computed in line [rad]; -1 if no sine is computed in line.
template <class Scalar>
constexpr double domain = -1;
template <>
constexpr double domain<float> = 1e3;
template <>
constexpr double domain<double> = 1e5;

template <class Scalar>
int differences(const char* type) {
  const Separate<Scalar> separate;
  std::mt19937 random(1);  // NOLINT: the same angles in every run
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  std::uniform_int_distribution<int> exponent(-40, 40);
  int count = 0;
  const auto compare = [&](Scalar angle) {
    if (std::abs(angle) <= static_cast<Scalar>(domain<Scalar>)) return;
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

/// |value - truth| in ulp; `truth` has more digits than Scalar.
template <class Scalar>
double error(Scalar value, long double truth) {
  const int last = std::ilogb(truth) + 1 - std::numeric_limits<Scalar>::digits;
  return static_cast<double>(std::abs(static_cast<long double>(value) - truth) /
                             std::ldexp(1.0L, last));
}

template <class Scalar>
double worst_error(Scalar angle) {
  const auto [sine, cosine] = code::SineCosine<Scalar>::of(angle);
  if (!is_same(sine, code::Sine<Scalar>::of(angle))) return 1e9;
  if (!is_same(cosine, code::Cosine<Scalar>::of(angle))) return 1e9;
  const auto exact = static_cast<long double>(angle);
  return std::max(error(sine, std::sin(exact)), error(cosine, std::cos(exact)));
}

/// 1 if an error exceeds `most_anywhere` ulp, or 0.502 ulp near a multiple of pi/2; otherwise 0.
/// The references are long double, with 64 bits on x86 and 113 bits on aarch64. The references have
/// errors of at most 2^-11 ulp of double.
template <class Scalar>
int errors(const char* type, double least_exponent, double most_anywhere) {
  std::mt19937 random(2);  // NOLINT: the same angles in every run
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  std::uniform_real_distribution<double> exponent(least_exponent, std::log10(domain<Scalar>));
  const auto at = [](double angle) { return worst_error(static_cast<Scalar>(angle)); };
  double anywhere = 0;
  for (int i = 0; i < 200'000; ++i) {
    anywhere = std::max(anywhere, at(mantissa(random) * std::pow(10, exponent(random))));
    anywhere = std::max(anywhere, at(domain<Scalar> * mantissa(random)));
  }
  double beside = 0;
  const long double eighth = std::acos(-1.0L) / 4;
  for (int i = 1; i * eighth < domain<Scalar>; ++i) {
    const auto angle = static_cast<Scalar>(static_cast<long double>(i) * eighth);
    double& worst = i % 2 == 0 ? beside : anywhere;
    for (const Scalar to : {Scalar(0), Scalar(1e9)}) {
      worst = std::max(worst, worst_error(std::nextafter(-angle, -to)));
    }
    worst = std::max(worst, worst_error(angle));
  }
  if (anywhere <= most_anywhere && beside <= 0.502) return 0;
  std::printf("sines in line of %s: off by %.3f ulp, by %.3f beside multiples of pi/2\n", type,
              anywhere, beside);
  return 1;
}

template <class Scalar>
bool has_sign_of_zero() {
  return std::signbit(code::SineCosine<Scalar>::of(-Scalar(0)).sine) &&
         !std::signbit(code::SineCosine<Scalar>::of(Scalar(0)).sine) &&
         code::Sine<Scalar>::of(std::numeric_limits<Scalar>::denorm_min()) > 0;
}

/// How many of the angles have different bits together than alone.
template <class Scalar, std::size_t... I>
int differences_together(const std::array<Scalar, sizeof...(I)>& angles,
                         std::index_sequence<I...> /*numbers*/) {
  const auto together = code::sines_of<Scalar>(angles[I]...);
  return static_cast<int>(std::count_if(angles.begin(), angles.end(), [&](const Scalar& angle) {
    const auto i = static_cast<std::size_t>(&angle - angles.data());
    const auto [sine, cosine] = together[i];
    const auto alone = code::SineCosine<Scalar>::of(angle);
    return !is_same(sine, alone.sine) || !is_same(cosine, alone.cosine) ||
           !is_same(together.sine(i), alone.sine) || !is_same(together.cosine(i), alone.cosine);
  }));
}

/// Compares `sets` sets of `Count` angles. One set of four may have angles beyond the domain.
template <class Scalar, std::size_t Count>
int differences_together(int sets) {
  using Limits = std::numeric_limits<Scalar>;
  constexpr auto end = static_cast<Scalar>(domain<Scalar>);
  const std::array<Scalar, 12> special{Scalar(0),
                                       -Scalar(0),
                                       Limits::denorm_min(),
                                       -Limits::denorm_min(),
                                       Limits::min(),
                                       end,
                                       -end,
                                       std::nextafter(end, Limits::max()),
                                       std::nextafter(-end, -Limits::max()),
                                       Limits::max(),
                                       -Limits::infinity(),
                                       Limits::quiet_NaN()};
  std::mt19937 random(3);  // NOLINT: the same angles in every run
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  std::uniform_int_distribution<int> exponent(-40, 9);
  std::uniform_int_distribution<std::size_t> pick(0, 3 * special.size());
  int count = 0;
  for (int set = 0; set < sets; ++set) {
    std::array<Scalar, Count> angles;
    for (Scalar& angle : angles) {
      const double size = set % 2 == 0 ? 4.0 : std::ldexp(1.0, exponent(random));
      angle = static_cast<Scalar>(size * mantissa(random));
      const std::size_t number = pick(random);
      if (set % 4 == 3 && number < special.size()) angle = special[number];
    }
    count += differences_together(angles, std::make_index_sequence<Count>());
  }
  if (count > 0) std::printf("%d of %d sets of %d angles\n", count, sets, static_cast<int>(Count));
  return count;
}

/// A million angles.
template <class Scalar>
int differences_together() {
  constexpr int sets = 23'000;
  return differences_together<Scalar, 2>(sets) + differences_together<Scalar, 3>(sets) +
         differences_together<Scalar, 4>(sets) + differences_together<Scalar, 5>(sets) +
         differences_together<Scalar, 6>(sets) + differences_together<Scalar, 7>(sets) +
         differences_together<Scalar, 8>(sets) + differences_together<Scalar, 9>(sets);
}

}  // namespace

int main() {
  const bool has_signs = has_sign_of_zero<float>() && has_sign_of_zero<double>();
  if (!has_signs) std::puts("the sign of a zero");
  const int count = differences<float>("float") + differences<double>("double") +
                    differences<long double>("long double") + errors<float>("float", -37, 0.9) +
                    errors<double>("double", -300, 1.5) + differences_together<float>() +
                    differences_together<double>() + differences_together<long double, 3>(1000);
  return has_signs && count == 0 ? 0 : 1;
}
