// PackTrigonometry: sines and cosines are off by at most what a scene asks for, on the whole
// domain.
#include "evaluate/pack_trigonometry.hpp"

#include <cln/rational.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "base/exact_number.hpp"
#include "base/random.hpp"
#include "elgen/evaluate.hpp"

using namespace elgen;

namespace {

/// The largest error of sine and cosine over random angles of all magnitudes.
template <class Scalar>
double largest_error(const Numerics& numerics) {
  const PackTrigonometry<Scalar> packs(numerics);
  const double domain = angle_reduction(scalar_kind<Scalar>).domain;
  Random random(7);
  double most = 0;
  for (int i = 0; i < 4000; ++i) {
    const double magnitude = i % 2 == 0 ? 4 : domain;
    const auto angle = static_cast<Scalar>(random.uniform(-magnitude, magnitude));
    const Real exact{exact_value(static_cast<double>(angle))};
    const auto [sine, cosine] = packs.of(angle);
    for (const auto& [value, truth] :
         {std::pair(sine, sin(exact)), std::pair(cosine, cos(exact))}) {
      const Real error = Real(exact_value(static_cast<double>(value))) - truth;
      most = std::max(most, std::abs(ScalarTraits<double>::from_real(error.value())));
    }
  }
  return most;
}

}  // namespace

TEST_CASE("sines and cosines are off by at most what is asked for, and need not be by less") {
  Numerics numerics;
  CHECK(largest_error<double>(numerics) <= 0x1p-52);
  CHECK(largest_error<float>(numerics) <= 0x1p-23);
  numerics.trigonometry_error = cln::cl_RA(1) / 1'000'000;
  CHECK(largest_error<double>(numerics) <= 1e-6);
  CHECK(largest_error<double>(numerics) > 1e-8);
  CHECK(largest_error<float>(numerics) <= 1e-6);
}

TEST_CASE("angles beyond the domain have no value") {
  const PackTrigonometry<float> packs(Numerics{});
  CHECK(std::isnan(packs.of(1001.0F).sine));
  CHECK(std::isnan(packs.of(-1001.0F).cosine));
  CHECK(std::isnan(packs.of(std::nanf("")).sine));
  CHECK_FALSE(std::isnan(packs.of(1000.0F).sine));
}

TEST_CASE("quarter turns are exact") {
  const PackTrigonometry<double> packs(Numerics{});
  CHECK(packs.of(0).sine == 0);
  CHECK(packs.of(0).cosine == 1);
  CHECK(packs.of(std::acos(-1.0)).cosine == -1);
  CHECK(packs.of(std::acos(-1.0) / 2).sine == 1);
}
