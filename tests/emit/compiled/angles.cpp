// detail::sine_cosine gives the bits of std::sin and std::cos.
#include <cstdio>
#include <limits>
#include <random>

#include "two_link_arm/two_link_arm.hpp"

namespace {

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
    const auto [sine, cosine] = two_link_arm::detail::SineCosine<Scalar>::of(angle);
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

}  // namespace

int main() {
  const int count = differences<float>("float") + differences<double>("double") +
                    differences<long double>("long double");
  return count == 0 ? 0 : 1;
}
