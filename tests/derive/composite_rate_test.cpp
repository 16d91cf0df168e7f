// The rate of momentum per unit twist: of one body, and passed on.
#include "derive/tree/composite_rate.hpp"

#include <catch2/catch.hpp>

#include "framed.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// (A s; s x P)
SpatialForce applied(VectorAlgebra& algebra, const CompositeRate& rate, const ExVector3& s) {
  SpatialForce result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.moment[i] =
        algebra.define(rate.a[3 * i] * s[0] + rate.a[3 * i + 1] * s[1] + rate.a[3 * i + 2] * s[2]);
  }
  result.force = algebra.cross(s, rate.momentum);
  return result;
}

Vector listed(const SpatialForce& f) {
  return {f.moment[0], f.moment[1], f.moment[2], f.force[0], f.force[1], f.force[2]};
}

}  // namespace

TEST_CASE("along its own twist a body asks for w x momentum", "[frames]") {
  for (const auto& [name, text] : frame_systems()) {
    INFO(name);
    const Framed system(text);
    Derivation derivation(system.lagrangian);
    Tree& tree = tree_of(derivation);
    VectorAlgebra& algebra = tree.algebra;
    const std::vector<Twist> twists = tree_twists(tree, derivation.frozen);
    const std::size_t leaf = tree.size() - 1;  // carries itself only
    const CompositeRate rate = composite_rates(tree, twists)[leaf];
    const CompositeInertia inertia = composite_inertias(tree)[leaf];
    const ExVector3& w = twists[leaf].spin;
    const SpatialForce p = momentum(algebra, inertia, w, twists[leaf].velocity);
    SpatialForce expected;
    const ExVector3 of_spin = algebra.cross(w, p.moment);
    const ExVector3 of_velocity = algebra.cross(twists[leaf].velocity, p.force);
    expected.moment = algebra.add(of_spin, of_velocity);
    expected.force = algebra.cross(w, p.force);
    const Vector derived = listed(applied(algebra, rate, w));
    const Vector wanted = listed(expected);
    const NumbersAt at(derivation.symbols, derivation.definitions, some_state(system.checked));
    CHECK(nearly_equal(at(derived), at(wanted)));
  }
}

TEST_CASE("a force per twist is the same force in the axes before a step", "[frames]") {
  const ExVector3 s{GiNaC::numeric(2, 3), GiNaC::numeric(-1, 5), GiNaC::numeric(3, 7)};
  for (const auto& [name, text] : frame_systems()) {
    const Framed system(text);
    Derivation derivation(system.lagrangian);
    Tree& tree = tree_of(derivation);
    const std::vector<CompositeRate> rates =
        composite_rates(tree, tree_twists(tree, derivation.frozen));
    for (std::size_t k = 0; k < tree.size(); ++k) {
      INFO(name << " step " << k);
      const CompositeRate before = to_parent(tree, k, rates[k]);
      const SpatialForce after = applied(tree.algebra, rates[k], tree.to_child(k, s));
      const Vector passed = listed(tree.before(k, after));
      const Vector direct = listed(applied(tree.algebra, before, s));
      const NumbersAt at(derivation.symbols, derivation.definitions, some_state(system.checked));
      CHECK(nearly_equal(at(direct), at(passed)));
    }
  }
}
