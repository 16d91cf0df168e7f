// Functions of closed forms; model_expression_test has the identities.
#include <catch2/catch.hpp>

#include "present/arithmetic.hpp"
#include "present/polynomial.hpp"

using namespace elgen;
using namespace elgen::presenting;

namespace {

struct Space {
  Algebra algebra = {};
  std::size_t work = 100'000;
  Arithmetic arithmetic{algebra, work, 1000};
  Value x = arithmetic.leaf(Opcode::coordinate, 0);

  std::size_t atoms(AtomKind kind) const {
    std::size_t count = 0;
    for (const Atom& atom : algebra.atoms) count += atom.kind == kind ? 1 : 0;
    return count;
  }
};

}  // namespace

TEST_CASE("sines and cosines of one angle share one exponential") {
  Space s;
  (void)s.arithmetic.call(FunctionId::sin, {s.x});
  (void)s.arithmetic.call(FunctionId::cos, {s.arithmetic.negate(s.x)});
  (void)s.arithmetic.call(FunctionId::tan, {s.x});
  CHECK(s.atoms(AtomKind::circular) == 1);
}

TEST_CASE("roots of numbers are roots of primes") {
  Space s;
  const Value twelve = s.arithmetic.square_root(fraction_of(cln::cl_RA(12)));
  REQUIRE(twelve);
  CHECK(twelve->numerator.begin()->second.real == 2);
  CHECK(s.atoms(AtomKind::root) == 1);
  CHECK_FALSE(s.arithmetic.square_root(fraction_of(cln::cl_RA(-1))));
}

TEST_CASE("constants are taken apart by their text") {
  Space s;
  const cln::cl_R any = cln::sqrt(cln::cl_R(2));
  const Value half_pi = s.arithmetic.constant({any, "1/2*pi"});
  REQUIRE(half_pi);
  CHECK(half_pi->numerator.begin()->second.real == cln::cl_RA(1) / 2);
  const Atom& atom = s.algebra.atoms[half_pi->numerator.begin()->first.at(0).atom];
  CHECK(atom.constant.text == "pi");
  CHECK(atom.constant.value > 3);  // not that of the whole
  const Value sine = s.arithmetic.call(FunctionId::sin, {half_pi});
  REQUIRE(sine);
  CHECK(rational_value(sine->numerator) == cln::cl_RA(1));
  CHECK(s.arithmetic.constant({any, "1 + 2*sqrt(3)"})->numerator.size() == 2);
  const std::string digits(500, '7');  // more than models may write
  CHECK(s.arithmetic.constant({any, digits + "*pi"})->numerator.size() == 1);
}

TEST_CASE("odd and even functions have one atom for both signs") {
  Space s;
  const Value minus = s.arithmetic.negate(s.x);
  (void)s.arithmetic.call(FunctionId::tanh, {s.x});
  (void)s.arithmetic.call(FunctionId::tanh, {minus});
  CHECK(s.atoms(AtomKind::call) == 1);
  (void)s.arithmetic.call(FunctionId::exp, {s.x});
  (void)s.arithmetic.call(FunctionId::exp, {minus});
  CHECK(s.atoms(AtomKind::call) == 3);
}
