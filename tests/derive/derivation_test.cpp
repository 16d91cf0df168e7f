// Directions and graded energies that the outputs share.
#include "derive/lagrangian/derivation.hpp"

#include <catch2/catch.hpp>

#include "derived.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("the four directions differ by what moves") {
  Derived s(everything_text());
  const GiNaC::ex& x = s.source.masses.front().position[0];
  const GiNaC::ex whole = s.textbook.rate(s.textbook.out(x));
  GiNaC::ex still = whole;
  for (const GiNaC::ex& v : s.source.symbols.v) still = still.subs(v == 0);
  CHECK(s.agree(s.derivation.motion(x), whole));
  CHECK(s.agree(s.derivation.coasting(x), whole));
  CHECK(s.agree(s.derivation.passing(x), still));
  CHECK(s.agree(s.derivation.frozen(x), whole - still));
}

TEST_CASE("graded energies add up to T and V beside the point masses") {
  Derived s(everything_text());
  const auto total = [](const Terms& terms) {
    GiNaC::ex sum = 0;
    for (const GiNaC::ex& term : terms) sum += term;
    return sum;
  };
  const GradedEnergies& graded = s.derivation.graded();
  const GiNaC::ex kinetic = s.textbook.out(total(s.source.kinetic));
  const GiNaC::ex potential = s.textbook.out(total(s.source.potential));
  CHECK(s.agree(total(graded.kinetic2) + total(graded.kinetic1) + total(graded.kinetic0), kinetic));
  CHECK(s.agree(total(graded.potential1) + total(graded.potential0), potential));
  CHECK(s.agree(total(graded.kinetic0), s.textbook.at_rest(kinetic)));
  CHECK(s.agree(total(graded.potential0), s.textbook.at_rest(potential)));
  CHECK_FALSE(graded.kinetic1.empty());
}
