// Degrees in the rates.
#include "derive/lagrangian/rate_grades.hpp"

#include <catch2/catch.hpp>

#include "formulate/written_out.hpp"

using namespace elgen;
using GiNaC::ex;

TEST_CASE("grades add up to a quadratic and have their degree") {
  Definitions definitions;
  const GiNaC::realsymbol q("q"), v("v"), w("w"), s("s");
  add_leaf(definitions, q, Opcode::coordinate);
  add_leaf(definitions, v, Opcode::velocity);
  add_leaf(definitions, w, Opcode::velocity);
  const ex spin = define(definitions, v * cos(q) + 3 * w + q);
  const ex square = define(definitions, spin * spin);
  const ex energy = square * sin(q) + spin * v + 5 * v + q;
  RateGrades grades(definitions, {v, w});
  const auto parts = grades(energy);
  const ex whole = test::written_out(definitions, energy);
  CHECK(test::vanishes(test::written_out(definitions, parts[0] + parts[1] + parts[2]) - whole,
                       {q, v, w}));
  for (int degree = 0; degree < 3; ++degree) {
    const ex part = test::written_out(definitions, parts[static_cast<std::size_t>(degree)]);
    const ex scaled = part.subs(GiNaC::lst{v == s * v, w == s * w});
    CHECK(test::vanishes(scaled - pow(s, degree) * part, {q, v, w, s}));
  }
}

TEST_CASE("what holds no rate is of degree zero") {
  Definitions definitions;
  const GiNaC::realsymbol q("q"), v("v");
  add_leaf(definitions, q, Opcode::coordinate);
  add_leaf(definitions, v, Opcode::velocity);
  const auto parts = RateGrades(definitions, {v})(sin(q));
  CHECK(parts[0].is_equal(sin(q)));
  CHECK(parts[1].is_zero());
  CHECK(parts[2].is_zero());
}

TEST_CASE("an energy without a value at rest is refused") {
  Definitions definitions;
  const GiNaC::realsymbol v("v");
  add_leaf(definitions, v, Opcode::velocity);
  RateGrades grades(definitions, {v});
  CHECK_THROWS_AS(grades(1 / v), GiNaC::pole_error);
}
