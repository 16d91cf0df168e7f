// Energies against the textbook route.
#include "derive/outputs/energies.hpp"

#include <catch2/catch.hpp>

#include "derived.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("energies of every system") {
  for (const auto& [name, text] : systems()) {
    INFO(name);
    Derived s(text);
    CHECK(s.agree(energy_function(s.derivation), s.textbook.energy()));
    if (!s.source.quadratic) continue;
    CHECK(s.agree(kinetic_energy(s.derivation), s.textbook.kinetic()));
    CHECK(s.agree(potential_energy(s.derivation), s.textbook.potential0()));
    CHECK(s.agree(total_energy(s.derivation), s.textbook.kinetic() + s.textbook.potential()));
  }
}

TEST_CASE("an L given whole is split by its degree in the rates") {
  Derived s(model_text("oscillator", R"toml(
[[coordinate]]
name = "x"
[parameters]
m = 2
k = 3
e = 5
[energy]
L = "1/2*m*dot(x)^2 + e*x*dot(x) - 1/2*k*x^2"
)toml"));
  const GiNaC::ex x = s.source.symbols.q[0];
  const GiNaC::ex v = s.source.symbols.v[0];
  const auto& p = s.source.symbols.parameters;
  CHECK(s.agree(kinetic_energy(s.derivation), p[0] * v * v / 2));
  CHECK(s.agree(potential_energy(s.derivation), p[1] * x * x / 2));
  CHECK(s.agree(total_energy(s.derivation), p[0] * v * v / 2 + p[1] * x * x / 2 - p[2] * x * v));
}
