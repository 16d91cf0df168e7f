// Solutions and pivots of the symmetric elimination, and its fill-in between limbs.
#include "derive/lagrangian/symmetric_solve.hpp"

#include <catch2/catch.hpp>

#include "derive/outputs/outputs.hpp"
#include "framed.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Lagrangian derivation_in_order(const std::string& text, bool last_first) {
  Lagrangian lagrangian = Framed(text).lagrangian;
  lagrangian.eliminates_last_first = last_first;
  return lagrangian;
}

SymmetricSolver solve_of(Derivation& derivation, const RealVector& mass) {
  return {derivation.definitions, mass, velocity_elimination_order(derivation),
          RowKind::velocities};
}

/// The number of definitions that the factorisation and one solution need besides the entries of M.
std::size_t cost(const std::string& text, bool last_first) {
  Derivation derivation(derivation_in_order(text, last_first));
  RealVector mass = mass_matrix(derivation);
  for (GiNaC::ex& entry : mass) entry = define(derivation.definitions, entry);
  const std::size_t before = derivation.definitions.list.size();
  SymmetricSolver solve = solve_of(derivation, mass);
  (void)solve.solve(derivation.symbols.a);
  return derivation.definitions.list.size() - before;
}

/// A base that slides along x with two arms of three revolute joints each. The order of the
/// coordinates is x, a1, a2, a3, b1, b2, b3.
std::string branched_text() {
  std::string text = model_text("branched", "[[coordinate]]\nname = \"x\"\n");
  std::string frames =
      "[[frame]]\nname = \"base\"\nparent = \"world\"\ntranslate = [\"x\", \"0\", "
      "\"0\"]\n";
  for (const std::string arm : {"a", "b"}) {
    std::string parent = "base";
    for (int i = 1; i <= 3; ++i) {
      const std::string name = arm + std::to_string(i);
      text += "[[coordinate]]\nname = \"" + name + "\"\n";
      frames += "[[frame]]\nname = \"" + name + "\"\nparent = \"" + parent +
                "\"\ntranslate = [\"l\", \"0\", \"0\"]\nrotate = [[\"z\", \"" + name +
                "\"]]\n[[body]]\nname = \"body_" + name + "\"\nframe = \"" + name +
                "\"\nmass = \"m\"\ncom = [\"l\", \"0\", \"0\"]\ninertia = [\"J\", \"J\", \"J\"]\n";
      parent = name;
    }
  }
  return text + "[parameters]\nm = 2\nl = \"7/10\"\nJ = \"1/5\"\n" + frames;
}

}  // namespace

TEST_CASE("M x = r holds in both orders of elimination", "[frames]") {
  for (const auto& [name, text] : frame_systems()) {
    for (const bool last_first : {false, true}) {
      INFO(name << " " << last_first);
      const Framed system(text);
      Derivation derivation(derivation_in_order(text, last_first));
      const std::size_t n = derivation.size();
      const RealVector mass = mass_matrix(derivation);
      SymmetricSolver solve = solve_of(derivation, mass);
      const RealVector x = solve.solve(derivation.symbols.a);
      RealVector products(n, 0);
      for (std::size_t i = 0; i < n * n; ++i) products[i / n] += mass[i] * x[i % n];
      const NumbersAt at(derivation.symbols, derivation.definitions, some_state(system.checked));
      CHECK(nearly_equal(at(products), at(derivation.symbols.a)));
    }
  }
}

TEST_CASE("the first relative pivot is 1, the second is its Schur complement over the diagonal",
          "[frames]") {
  const Framed system(read_model("two_turns"));
  for (const bool last_first : {false, true}) {
    Derivation derivation(derivation_in_order(read_model("two_turns"), last_first));
    const RealVector mass = mass_matrix(derivation);
    const RealVector pivots = solve_of(derivation, mass).relative_pivots();
    const std::size_t first = last_first ? 1 : 0;
    CHECK(pivots[first].is_equal(1));
    const GiNaC::ex expected = 1 - mass[1] * mass[1] / (mass[0] * mass[3]);
    const NumbersAt at(derivation.symbols, derivation.definitions, some_state(system.checked));
    CHECK(nearly_equal({at(pivots[1 - first])}, {at(expected)}));
  }
}

TEST_CASE("elimination from the limbs has no fill-in between them", "[frames]") {
  const Framed system(branched_text());
  CHECK(system.lagrangian.eliminates_last_first);
  // If the base is eliminated last, 9 entries between the arms stay zero.
  CHECK(cost(branched_text(), true) + 9 < cost(branched_text(), false));
  CHECK_FALSE(Framed(read_model("three_turns")).lagrangian.eliminates_last_first);
}
