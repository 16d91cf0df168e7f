// Functions of closed forms; identities are tested in model_expression_test.
#include <catch2/catch.hpp>

#include "forms/present/arithmetic.hpp"
#include "forms/present/polynomial.hpp"

using namespace elgen;

namespace {

struct Space {
  Algebra algebra = {};
  Arithmetic arithmetic{algebra};
  OptionalFraction x = arithmetic.leaf(Opcode::coordinate, 0);

  std::size_t atoms(AtomKind kind) const {
    std::size_t count = 0;
    for (const Atom& atom : algebra.atoms) count += atom.kind == kind ? 1 : 0;
    return count;
  }
};

}  // namespace

TEST_CASE("sines and cosines of one angle share one exponential") {
  Space s;
  (void)s.arithmetic.call(FunctionId::sin, s.x, {});
  (void)s.arithmetic.call(FunctionId::cos, s.arithmetic.negate(s.x), {});
  (void)s.arithmetic.call(FunctionId::tan, s.x, {});
  CHECK(s.atoms(AtomKind::circular) == 1);
}

TEST_CASE("roots of numbers are roots of primes") {
  Space s;
  const OptionalFraction twelve = s.arithmetic.square_root(fraction_of(cln::cl_RA(12)));
  REQUIRE(twelve);
  CHECK(twelve->numerator.begin()->second.real == 2);
  CHECK(s.atoms(AtomKind::root) == 1);
  CHECK_FALSE(s.arithmetic.square_root(fraction_of(cln::cl_RA(-1))));
}

TEST_CASE("calls with rational values become numbers") {
  Space s;
  const OptionalFraction zero = fraction_of(cln::cl_RA(0));
  const auto series = [&](int k) {
    return s.arithmetic.call(FunctionId::stumpff, zero, fraction_of(cln::cl_RA(k)));
  };
  CHECK(series(2) == fraction_of(cln::cl_RA(1) / 2));
  CHECK(series(3) == fraction_of(cln::cl_RA(1) / 6));
  CHECK(series(-3) == fraction_of(cln::cl_RA(1) / 6));
  CHECK(s.arithmetic.call(FunctionId::exp, zero, {}) == fraction_of(cln::cl_RA(1)));
  CHECK(s.atoms(AtomKind::call) == 0);
  (void)s.arithmetic.call(FunctionId::exp, fraction_of(cln::cl_RA(1)), {});
  CHECK(s.atoms(AtomKind::call) == 1);
}

TEST_CASE("Stumpff functions are atoms, or quotients if the algebra has quotients") {
  for (const bool has_quotients : {false, true}) {
    Space s{.algebra = {.has_quotients = has_quotients}};
    const auto series = [&](int k) {
      return s.arithmetic.call(FunctionId::stumpff, s.x, fraction_of(cln::cl_RA(k)));
    };
    const OptionalFraction sine = s.arithmetic.call(FunctionId::sin, s.x, {});
    const OptionalFraction cube = s.arithmetic.power(s.x, 3);
    CHECK((s.arithmetic.multiply(s.x, series(1)) == sine) == has_quotients);
    CHECK((s.arithmetic.multiply(cube, series(3)) == s.arithmetic.subtract(s.x, sine)) ==
          has_quotients);
    (void)series(-1);
    CHECK(s.atoms(AtomKind::call) == (has_quotients ? 1 : 3));
  }
}

TEST_CASE("exponentials are atoms, or powers of a few atoms if the algebra has exponentials") {
  for (const bool has_exponentials : {false, true}) {
    Space s{.algebra = {.has_exponentials = has_exponentials}};
    Arithmetic& a = s.arithmetic;
    const auto call = [&a](FunctionId function, const OptionalFraction& x) {
      return a.call(function, x, OptionalFraction());
    };
    const auto exp = [&](const OptionalFraction& x) { return call(FunctionId::exp, x); };
    const OptionalFraction one = fraction_of(cln::cl_RA(1));
    const OptionalFraction y = a.leaf(Opcode::coordinate, 1);
    const OptionalFraction half = a.divide(s.x, fraction_of(cln::cl_RA(2)));
    const OptionalFraction sine = call(FunctionId::sin, s.x);
    const OptionalFraction quotient = a.divide(s.x, a.add(one, y));
    CHECK((a.multiply(exp(s.x), exp(a.negate(s.x))) == one) == has_exponentials);
    CHECK((a.multiply(exp(quotient), exp(a.divide(y, a.add(one, y)))) ==
           exp(a.divide(a.add(s.x, y), a.add(one, y)))) == has_exponentials);
    for (const OptionalFraction& u : {half, s.x, y, one, sine, a.pi()}) {
      CHECK((a.power(exp(u), 2) == exp(a.add(u, u))) == has_exponentials);
      CHECK((a.multiply(exp(u), exp(s.x)) == exp(a.add(u, s.x))) == has_exponentials);
      CHECK(a.power(exp(u), 3) != exp(a.add(u, u)));
      const OptionalFraction squared = exp(a.add(u, u));
      const OptionalFraction tangent = a.divide(a.subtract(squared, one), a.add(squared, one));
      const OptionalFraction difference = a.subtract(call(FunctionId::tanh, u), tangent);
      REQUIRE(difference);
      CHECK(difference->numerator.empty() == has_exponentials);
    }
    const OptionalFraction hyperbola =
        a.subtract(a.power(call(FunctionId::cosh, y), 2), a.power(call(FunctionId::sinh, y), 2));
    CHECK((hyperbola == one) == has_exponentials);
    CHECK((a.subtract(call(FunctionId::cosh, y), call(FunctionId::sinh, y)) == exp(a.negate(y))) ==
          has_exponentials);
    CHECK(call(FunctionId::sinh, y) != call(FunctionId::cosh, y));
  }
}

TEST_CASE("constants are split by their form") {
  Space s;
  const ConstantForm pi{.kind = ConstantKind::pi, .operands = {}};
  const ConstantForm half = rational_form(cln::cl_RA(1) / 2);
  const ConstantForm three = rational_form(3);
  const ConstantForm root{.kind = ConstantKind::square_root, .operands = {{three, 1}}};
  const OptionalFraction half_pi =
      s.arithmetic.constant({.kind = ConstantKind::product, .operands = {{half, 1}, {pi, 1}}});
  REQUIRE(half_pi);
  CHECK(half_pi->numerator.begin()->second.real == cln::cl_RA(1) / 2);
  CHECK(s.algebra.atoms[half_pi->numerator.begin()->first[0].atom].kind == AtomKind::pi);
  const OptionalFraction sine = s.arithmetic.call(FunctionId::sin, half_pi, {});
  REQUIRE(sine);
  CHECK(rational_value(sine->numerator) == cln::cl_RA(1));
  const ConstantForm difference{.kind = ConstantKind::sum, .operands = {{three, 1}, {root, -1}}};
  const OptionalFraction product = s.arithmetic.multiply(
      s.arithmetic.constant(difference),
      s.arithmetic.constant({.kind = ConstantKind::sum, .operands = {{three, 1}, {root, 1}}}));
  REQUIRE(product);
  CHECK(rational_value(product->numerator) == cln::cl_RA(6));
}

TEST_CASE("odd and even functions have one atom for both signs of the argument") {
  Space s;
  const OptionalFraction minus = s.arithmetic.negate(s.x);
  (void)s.arithmetic.call(FunctionId::tanh, s.x, {});
  (void)s.arithmetic.call(FunctionId::tanh, minus, {});
  CHECK(s.atoms(AtomKind::call) == 1);
  (void)s.arithmetic.call(FunctionId::exp, s.x, {});
  (void)s.arithmetic.call(FunctionId::exp, minus, {});
  CHECK(s.atoms(AtomKind::call) == 3);
}
