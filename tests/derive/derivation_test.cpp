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

TEST_CASE("graded energies add up to T and V beside the point masses, and have their degree") {
  Derived s(everything_text());
  const auto whole = [&](const Terms& terms) {
    GiNaC::ex sum = 0;
    for (const GiNaC::ex& term : terms) sum += term;
    return written_out(s.derivation.definitions, sum);
  };
  const GradedEnergies& graded = s.derivation.graded();
  const Terms* const kinetic[] = {&graded.kinetic0, &graded.kinetic1, &graded.kinetic2};
  const Terms* const potential[] = {&graded.potential0, &graded.potential1};
  const auto check = [&](const auto& grades, const GiNaC::ex& expected) {
    GiNaC::exmap faster;
    for (const GiNaC::ex& v : s.source.symbols.v) faster[v] = 3 * v;
    GiNaC::ex total = 0;
    GiNaC::ex factor = 1;
    for (const Terms* grade : grades) {
      const GiNaC::ex part = whole(*grade);
      CHECK(s.agree(part.subs(faster, GiNaC::subs_options::no_pattern), factor * part));
      factor *= 3;
      total += part;
    }
    CHECK(s.agree(total, expected));
  };
  check(kinetic, whole(s.source.kinetic));
  check(potential, whole(s.source.potential));
  CHECK_FALSE(graded.kinetic1.empty());
}
