// Enclosures contain every value on their box. The values of all functions are computed in 64
// digits at random points. Some cases have exact bounds.
#include "numbers/enclosure.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "elgen/evaluate.hpp"
#include "numbers/dual.hpp"
#include "numbers/exact_number.hpp"
#include "numbers/random.hpp"

using namespace elgen;

namespace {

bool holds(const Enclosure& enclosure, const Real& value) {
  if (enclosure.definedness == Definedness::nowhere) return false;
  const auto is_above = [&](double low) {
    return std::isinf(low) || exact_value(low) <= value.value();
  };
  const auto is_below = [&](double high) {
    return std::isinf(high) || value.value() <= exact_value(high);
  };
  return is_above(enclosure.low) && is_below(enclosure.high);
}

Real real_of(double x) { return Real(exact_value(x)); }

/// A random enclosure with lower end in [-160, 160] and width between 2^-54 and 16.
Enclosure random_enclosure(Random& random) {
  const double first = random.uniform(-4, 4) * (random.next() % 8 == 0 ? 40 : 1);
  const double width = std::abs(random.log_uniform(-54, 3));
  return {std::min(first, first + width), std::max(first, first + width)};
}

double inside(const Enclosure& box, Random& random) {
  const double share = random.uniform(0, 1);
  const double value = box.low + share * (box.high - box.low);
  return std::clamp(value, box.low, box.high);
}

constexpr int boxes = 400;
constexpr int points_in_box = 6;

}  // namespace

TEST_CASE("enclosures of functions contain all values on their box") {
  Random random(7);
  for (const FunctionRow& row : function_table()) {
    INFO(row.name);
    int defined = 0;
    for (int i = 0; i < boxes; ++i) {
      const Enclosure x = random_enclosure(random);
      const bool is_stumpff = row.id == FunctionId::stumpff;
      const Enclosure y = is_stumpff ? point_enclosure((1 + i % 5) * (i % 2 == 0 ? 1 : -1))
                                     : random_enclosure(random);
      const Enclosure all = interpreter::call(row.id, x, y);
      for (int k = 0; k < points_in_box; ++k) {
        const double at_x = inside(x, random);
        const double at_y = inside(y, random);
        const Real value = interpreter::call(row.id, real_of(at_x), real_of(at_y));
        if (!value.is_defined()) {
          CHECK(all.definedness != Definedness::everywhere);
          continue;
        }
        ++defined;
        INFO(at_x << " " << at_y << " in [" << all.low << ", " << all.high << "]");
        CHECK(holds(all, value));
      }
    }
    CHECK(defined > boxes);
  }
}

TEST_CASE("enclosures of sums, products, quotients and roots contain all values") {
  Random random(11);
  for (int i = 0; i < boxes; ++i) {
    const Enclosure x = random_enclosure(random);
    const Enclosure y = random_enclosure(random);
    for (int k = 0; k < points_in_box; ++k) {
      const Real at_x = real_of(inside(x, random));
      const Real at_y = real_of(inside(y, random));
      CHECK(holds(x + y, at_x + at_y));
      CHECK(holds(x - y, at_x - at_y));
      CHECK(holds(x * y, at_x * at_y));
      CHECK(holds(x * x, at_x * at_x));
      if ((at_x / at_y).is_defined()) CHECK(holds(x / y, at_x / at_y));
      if (sqrt(at_x).is_defined()) CHECK(holds(sqrt(x), sqrt(at_x)));
    }
  }
}

TEST_CASE("enclosures of exact results have width 0") {
  const auto is_exactly = [](const Enclosure& x, double value) {
    return x.low == value && x.high == value;
  };
  const Enclosure two = point_enclosure(2);
  const Enclosure three = point_enclosure(3);
  CHECK(is_exactly(two + three, 5));
  CHECK(is_exactly(two - three, -1));
  CHECK(is_exactly(two * three, 6));
  CHECK(is_exactly(three / two, 1.5));
  CHECK(is_exactly(sqrt(point_enclosure(2.25)), 1.5));
  CHECK(is_exactly(point_enclosure(0) * Enclosure{-5, 7}, 0));
  CHECK(is_exactly(ScalarTraits<Enclosure>::from_real(cln::cl_RA(3) / 4), 0.75));
}

TEST_CASE("enclosures of rounded results are one ulp wide") {
  const Enclosure tenth = ScalarTraits<Enclosure>::from_real(cln::cl_RA(1) / 10);
  CHECK(tenth.high == std::nextafter(tenth.low, 1));
  const Enclosure third = point_enclosure(1) / point_enclosure(3);
  CHECK(third.high == std::nextafter(third.low, 1));
  CHECK(third.low <= 1.0 / 3);
}

TEST_CASE("enclosures of sines reach 1 if they contain a maximum") {
  CHECK(sin(Enclosure{1, 2}).high == 1);
  CHECK(sin(Enclosure{1, 1.5}).high < 1);
  CHECK(cos(Enclosure{3, 4}).low == -1);
  CHECK(cos(Enclosure{-0.5, 0.25}).high == 1);
  CHECK(sin(Enclosure{0, 7}).low == -1);
  CHECK(sin(Enclosure{1e300, 1e300}).high == 1);
}

TEST_CASE("the product of an operand with itself is a square, other products are not") {
  const Enclosure x{-1, 2};
  const Enclosure same = x;
  CHECK((x * x).low == 0);
  CHECK((x * same).low == -2);
}

TEST_CASE("enclosures report undefined values and jumps") {
  CHECK(sqrt(Enclosure{-1, 4}).definedness == Definedness::somewhere);
  CHECK(sqrt(Enclosure{-1, 4}).low == 0);
  CHECK(sqrt(Enclosure{-2, -1}).definedness == Definedness::nowhere);
  CHECK(log(Enclosure{-1, 0}).definedness == Definedness::nowhere);
  CHECK(asin(Enclosure{2, 3}).definedness == Definedness::nowhere);
  CHECK((Enclosure{1, 2} / Enclosure{-1, 1}).definedness == Definedness::somewhere);
  CHECK(tan(Enclosure{1, 2}).definedness == Definedness::somewhere);
  CHECK(sign(Enclosure{-1, 1}).definedness == Definedness::somewhere);
  CHECK(sign(Enclosure{1, 2}).definedness == Definedness::everywhere);
  const Enclosure undefined = sqrt(Enclosure{-2, -1});
  CHECK((undefined + Enclosure{1, 2}).definedness == Definedness::nowhere);
  CHECK_FALSE(may_contain(undefined * undefined, 0));
}

TEST_CASE("slopes of enclosures contain all slopes on their box") {
  const Dual<Enclosure> x{{0, 1}, point_enclosure(1)};
  const Dual<Enclosure> y = sin(x * x);
  // d sin(x^2)/dx = 2 x cos(x^2) is in [0, 1.28...] on [0, 1]; its enclosure is [0.54, 1]*[0, 2].
  CHECK(y.slope.low <= 0);
  CHECK(y.slope.high >= 1.6);
  CHECK(y.slope.high <= 2.0 + 1e-12);
}
