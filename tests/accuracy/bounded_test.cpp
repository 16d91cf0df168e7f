// The rules of error bounds and of running errors, one by one, and that they bound what rounding
// does.
#include "accuracy/bounded.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "accuracy/running_errors.hpp"
#include "oracle/model_builder.hpp"

using namespace elgen;

namespace {

const LeafValues<Bound> no_leaves;
const BoundRules bound_rules{no_leaves, rounding<double>()};

// Formulas of bounds, as they are read.
Bound operator-(const Bound& x) { return bound_rules.negate(x); }
Bound operator+(const Bound& x, const Bound& y) { return bound_rules.add(x, y); }
Bound operator-(const Bound& x, const Bound& y) { return bound_rules.subtract(x, y); }
Bound operator*(const Bound& x, const Bound& y) { return bound_rules.multiply(x, y); }
Bound operator/(const Bound& x, const Bound& y) { return bound_rules.divide(x, y); }
Bound sqrt(const Bound& x) { return bound_rules.square_root(x); }
Bound sin(const Bound& x) { return bound_rules.call(FunctionId::sin, x, x); }
Bound sinh(const Bound& x) { return bound_rules.call(FunctionId::sinh, x, x); }
Bound cosh(const Bound& x) { return bound_rules.call(FunctionId::cosh, x, x); }
Bound tanh(const Bound& x) { return bound_rules.call(FunctionId::tanh, x, x); }
Bound exp(const Bound& x) { return bound_rules.call(FunctionId::exp, x, x); }
Bound atan2(const Bound& y, const Bound& x) { return bound_rules.call(FunctionId::atan2, y, x); }

Bound leaf(const char* text) { return leaf_bound(test::exact(text), rounding<double>()); }
double bound(const Bound& x) { return ScalarTraits<double>::from_real(x.bound.value()); }

const RunningErrorRules running_rules{};

Running without_error(const char* text) { return {Real(test::exact(text)), Real()}; }
Running off(const char* text, const char* error) {
  return {Real(test::exact(text)), Real(test::exact(error))};
}
double error(const Running& x) { return ScalarTraits<double>::from_real(x.error.value()); }

}  // namespace

TEST_CASE("leaves: binary numbers are exact, others are rounded") {
  CHECK(leaf("-3/4").exact);
  CHECK_FALSE(leaf("1/10").exact);
  CHECK(bound(leaf("-3/4")) == 0.75);
}

TEST_CASE("sums add bounds, products multiply them") {
  CHECK(bound(leaf("3") - leaf("2")) == 5);
  CHECK(bound((leaf("3") - leaf("2")) * leaf("-4")) == 20);
}

TEST_CASE("quotients: (Bx + |x/y| By) / |y|") {
  CHECK(bound((leaf("3") - leaf("2")) / leaf("-4")) == Approx((5 + 0.25 * 4) / 4));
}

TEST_CASE("functions: |f| + |f'| A, without A where the argument is exact") {
  CHECK(bound(sin(leaf("1/2"))) == Approx(std::sin(0.5)));
  CHECK(bound(sin(-leaf("1/2") * leaf("4"))) == Approx(std::sin(2.0)));
  const Bound angle = leaf("3/4") * leaf("3");
  CHECK_FALSE(angle.exact);
  CHECK(bound(sin(angle)) == Approx(std::sin(2.25) + std::abs(std::cos(2.25)) * 2.25));
  CHECK(bound(sqrt(leaf("1") + leaf("3"))) == Approx(2 + 4.0 / 4));
  CHECK(bound(atan2(leaf("1") + leaf("2"), leaf("4"))) == Approx(std::atan2(3, 4) + 3.0 * 4 / 25));
}

TEST_CASE("functions of one argument do not look at what stands in the other slot") {
  const Bound x = leaf("3/4") * leaf("3");
  const Bound other = leaf("1/10") * leaf("1000");
  for (const FunctionRow& row : function_table()) {
    if (row.arity != 1 || row.id == FunctionId::asin || row.id == FunctionId::acos) continue;
    INFO(row.name);
    const Bound alone = bound_rules.call(row.id, x, x);
    const Bound beside = bound_rules.call(row.id, x, other);
    CHECK(bound(beside) == bound(alone));
    CHECK(beside.roundings == alone.roundings);
  }
  CHECK(bound(bound_rules.call(FunctionId::abs, x, other)) == 2.25);
}

TEST_CASE("functions have the values that their rows say") {
  for (const FunctionRow& row : function_table()) {
    INFO(row.name);
    if (row.arity == 1)
      CHECK(interpreter::call<double>(row.id, row.exact_at, 0) == row.exact_value);
    if (!row.far_values) continue;
    CHECK(interpreter::call<double>(row.id, -1e6, 0) == row.far_values->left);
    CHECK(interpreter::call<double>(row.id, 1e6, 0) == row.far_values->right);
  }
}

TEST_CASE("the second order matters at large angles") {
  const Bound angle = leaf("1000000000000001") * leaf("3");
  const double a = 3e15;
  CHECK(bound(sin(angle)) > 0.5 * 0x1p-53 * a * a);
}

TEST_CASE("what may underflow carries the smallest denormal along") {
  const Bound tiny = leaf("1e-300") * leaf("1e-300");
  CHECK(bound(tiny) >= 0x1p-1074 / 0x1p-53);
  CHECK(bound(tiny / leaf("1e-300")) > 1e-9);
}

TEST_CASE("dividing by what is uncertain loses the bound, also for what follows") {
  const Bound difference = leaf("3000000000000001") * leaf("3") - leaf("9000000000000000");
  CHECK_FALSE(difference.lost);
  CHECK((leaf("1") / difference).lost);
  CHECK((leaf("2") + leaf("1") / difference).lost);
  CHECK(sqrt(difference).lost);
  CHECK_FALSE((leaf("1") / leaf("3")).lost);
}

TEST_CASE("float bounds speak of float's rounding") {
  const Bound x = leaf_bound(cln::cl_R("16777217"), rounding<float>());
  CHECK_FALSE(x.exact);
  CHECK(leaf("16777217").exact);
}

TEST_CASE("exponentials far out take their limits") {
  const Bound far = leaf("1e300");
  CHECK(bound(tanh(-far)) == 1);
  CHECK(cln::minusp(tanh(-far).value.value()));
  CHECK(cln::zerop(exp(-far).value.value()));
  for (const Bound& infinite : {exp(far), cosh(far), sinh(far), -sinh(-far)}) {
    CHECK(infinite.value.value() > rounding<double>().largest.value());
  }
}

TEST_CASE("roundings count along the longest sum, and meet in products") {
  const Bound x = leaf("3");
  const Bound long_sum = x + x + x + x;
  CHECK(long_sum.roundings == 3);
  CHECK((long_sum * x - x).roundings == 5);
  CHECK((long_sum * long_sum).roundings == 7);
  CHECK((-sqrt(long_sum) / x).roundings == 4);
}

TEST_CASE("calls, roots and quotients round, too") {
  // exp(x)^2 and cosh(x)^2: each factor has the rounding of its call, 1 or 4 u.
  const Bound x = leaf("3");
  CHECK((exp(x) * exp(x)).roundings == 3);
  CHECK((cosh(x) * cosh(x)).roundings == 9);
  CHECK((sqrt(x) * sqrt(x)).roundings == 3);
  CHECK((x / leaf("4") * (x / leaf("4"))).roundings == 3);
}

TEST_CASE("a bound beyond all numbers is lost") {
  Bound x = leaf("3");
  for (int i = 0; i < 80; ++i) x.bound = x.bound * x.bound;
  CHECK_FALSE(x.bound.is_defined());
  const Bound product = x * leaf("2");
  CHECK(product.lost);
  CHECK(product.bound.is_defined());
}

TEST_CASE("along what repeats itself B has every rounding, of first order") {
  const RunningBoundRules running{bound_rules};
  const Bound x = leaf("3");
  const Bound y = leaf("-4");
  CHECK(bound(running.add(x, y)) == 3 + 4 + 1);
  CHECK(bound(running.subtract(x, y)) == 3 + 4 + 7);
  CHECK(bound(running.multiply(x, y)) == Approx(3 * 4 + 4 * 3 + 12));
  CHECK(bound(running.divide(x, y)) == Approx((3 + 0.75 * 4) / 4 + 0.75));
  CHECK(running.multiply(running.add(x, y), y).roundings == 0);
}

TEST_CASE("where an iteration takes errors away, B stays") {
  const RunningBoundRules running{bound_rules};
  Bound x = leaf("21") - leaf("20");
  Bound outgrown = x;
  for (int i = 0; i < 20; ++i) {
    x = running.add(leaf("1"), running.divide(running.multiply(x, x), leaf("8")));
    outgrown = leaf("1") + outgrown * outgrown / leaf("8");
  }
  CHECK(bound(x) < 10);
  CHECK(bound(outgrown) > 1e100);
}

TEST_CASE("leaves are exact or rounded once") {
  Arguments<double> point;
  point.q = {-3};
  CHECK(error(running_leaves(point, Leaves::exact).q[0]) == 0);
  CHECK(error(running_leaves(point, Leaves::rounded).q[0]) == 3);
}

TEST_CASE("each operation rounds once, and passes errors on") {
  CHECK(error(running_rules.add(off("3", "2"), off("-1", "1"))) == 2 + 1 + 2);
  CHECK(error(running_rules.subtract(without_error("3"), without_error("5"))) == 2);
  CHECK(error(running_rules.multiply(off("3", "2"), off("5", "1"))) == 2 * 5 + 3 + 15);
  CHECK(error(running_rules.multiply(off("3", "2"), without_error("4"))) == 2 * 4);
  CHECK(error(running_rules.divide(off("6", "1"), off("3", "2"))) == Approx((1 + 2 * 2) / 3.0 + 2));
  CHECK(error(running_rules.square_root(off("9", "6"))) == Approx(1 + 3));
}

TEST_CASE("functions pass errors on by their slopes") {
  const Running x = off("0.5", "3");
  CHECK(error(running_rules.call(FunctionId::sin, x, x)) ==
        Approx(std::sin(0.5) + 3 * std::cos(0.5)));
  CHECK(error(running_rules.call(FunctionId::abs, x, x)) == 3);
  CHECK(error(running_rules.call(FunctionId::max, without_error("1"), off("2", "5"))) == 5);
}
