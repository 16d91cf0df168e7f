// Composite inertias agree with sums over bodies in the world. Also tests rates of momentum per
// unit twist, and the transformation of inertias and rates along the tree.
#include "derive/tree/composite.hpp"

#include <catch2/catch.hpp>

#include "framed.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// `before` in the axes after the transform `step`: a translation by r gives velocity + spin x r, a
/// rotation expresses spin and velocity in the child's axes.
Twist after(KinematicTree& tree, std::size_t step, const Twist& before) {
  Twist result = before;
  if (tree.transform(step).kind == TransformKind::translation) {
    const ExVector3 carried = tree.algebra.cross(before.spin, tree.transform(step).vector);
    result.velocity = tree.algebra.add(before.velocity, carried);
    return result;
  }
  result.spin = tree.to_child(step, before.spin);
  result.velocity = tree.to_child(step, before.velocity);
  return result;
}

GiNaC::ex power(KinematicTree& tree, const CompositeInertia& inertia, const Twist& a,
                const Twist& b) {
  const SpatialForce of_b = spatial_momentum(tree.algebra, inertia, b.spin, b.velocity);
  const GiNaC::ex turning = tree.algebra.dot(a.spin, of_b.moment);
  return turning + tree.algebra.dot(a.velocity, of_b.force);
}

const Twist first{{GiNaC::numeric(2, 3), GiNaC::numeric(-1, 5), GiNaC::numeric(3, 7)},
                  {GiNaC::numeric(1, 9), GiNaC::numeric(4, 5), GiNaC::numeric(-3, 2)}};
const Twist second{{GiNaC::numeric(1, 4), GiNaC::numeric(6, 5), GiNaC::numeric(-2, 7)},
                   {GiNaC::numeric(5, 3), GiNaC::numeric(-1, 8), GiNaC::numeric(1, 2)}};

/// The spatial force with the moment A s and the force s x P; A is `rate.a`, P is `rate.momentum`.
SpatialForce force_of_rate(VectorAlgebra& algebra, const CompositeRate& rate, const ExVector3& s) {
  SpatialForce result;
  result.moment = algebra.product(rate.a, s);
  result.force = algebra.cross(s, rate.momentum);
  return result;
}

RealVector listed(const SpatialForce& f) {
  return {f.moment[0], f.moment[1], f.moment[2], f.force[0], f.force[1], f.force[2]};
}

}  // namespace

TEST_CASE("entries of a symmetric matrix are xx yy zz xy xz yz", "[frames]") {
  CHECK(symmetric_index(0, 0) == 0);
  CHECK(symmetric_index(2, 2) == 2);
  CHECK(symmetric_index(0, 1) == 3);
  CHECK(symmetric_index(2, 0) == 4);
  CHECK(symmetric_index(1, 2) == 5);
}

TEST_CASE("the base carries all bodies", "[frames]") {
  const Framed system(read_model("two_arms"));
  const Model& model = system.checked.model;
  const State state = some_state(system.checked);
  Derivation derivation(system.lagrangian);
  const CompositeInertia base = composite_inertias(tree_of(derivation)).front();
  const auto value = [&](ExpressionId id) { return *oracle_expression_value(model, id, state); };
  Reals expected(4, 0);  // mass and first moment about the base, which is at (x, 0, 0)
  for (const Body& body : model.bodies) {
    const cln::cl_R mass = value(*body.mass);
    expected[0] = expected[0] + mass;
    for (std::size_t k = 0; k < 3; ++k) {
      const cln::cl_R lever = value(body.com[k]) - (k == 0 ? state.q[0] : cln::cl_R(0));
      expected[k + 1] = expected[k + 1] + mass * lever;
    }
  }
  const NumbersAt at(derivation.symbols, derivation.definitions, state);
  CHECK(nearly_equal(at({base.mass, base.moment[0], base.moment[1], base.moment[2]}), expected));
}

TEST_CASE("twice the kinetic energy is independent of the axes", "[frames]") {
  for (const auto& [name, text] : frame_systems()) {
    const Framed system(text);
    Derivation derivation(system.lagrangian);
    KinematicTree& tree = tree_of(derivation);
    const std::vector<CompositeInertia> inertias = composite_inertias(tree);
    for (std::size_t k = 0; k < tree.size(); ++k) {
      INFO(name << " step " << k);
      const CompositeInertia before = to_parent(tree, k, inertias[k]);
      const GiNaC::ex expected = power(tree, before, first, second);
      const GiNaC::ex transposed = power(tree, before, second, first);
      const GiNaC::ex moved =
          power(tree, inertias[k], after(tree, k, first), after(tree, k, second));
      const NumbersAt at(derivation.symbols, derivation.definitions, some_state(system.checked));
      CHECK(nearly_equal({at(moved)}, {at(expected)}));
      CHECK(nearly_equal({at(transposed)}, {at(expected)}));
    }
  }
}

TEST_CASE("the composite rate of a body along its own twist is w x momentum", "[frames]") {
  for (const auto& [name, text] : frame_systems()) {
    INFO(name);
    const Framed system(text);
    Derivation derivation(system.lagrangian);
    KinematicTree& tree = tree_of(derivation);
    VectorAlgebra& algebra = tree.algebra;
    const std::vector<Twist> twists = tree_twists(tree, derivation.rate_at_fixed_time);
    const std::size_t leaf = tree.size() - 1;  // a leaf carries only itself
    const CompositeRate rate = composite_rates(tree, twists)[leaf];
    const CompositeInertia inertia = composite_inertias(tree)[leaf];
    const ExVector3& w = twists[leaf].spin;
    const SpatialForce p = spatial_momentum(algebra, inertia, w, twists[leaf].velocity);
    SpatialForce expected;
    const ExVector3 of_spin = algebra.cross(w, p.moment);
    const ExVector3 of_velocity = algebra.cross(twists[leaf].velocity, p.force);
    expected.moment = algebra.add(of_spin, of_velocity);
    expected.force = algebra.cross(w, p.force);
    const RealVector derived = listed(force_of_rate(algebra, rate, w));
    const RealVector wanted = listed(expected);
    const NumbersAt at(derivation.symbols, derivation.definitions, some_state(system.checked));
    CHECK(nearly_equal(at(derived), at(wanted)));
  }
}

TEST_CASE("a force per twist transforms to the axes before a step", "[frames]") {
  const ExVector3 s{GiNaC::numeric(2, 3), GiNaC::numeric(-1, 5), GiNaC::numeric(3, 7)};
  for (const auto& [name, text] : frame_systems()) {
    const Framed system(text);
    Derivation derivation(system.lagrangian);
    KinematicTree& tree = tree_of(derivation);
    const std::vector<CompositeRate> rates =
        composite_rates(tree, tree_twists(tree, derivation.rate_at_fixed_time));
    for (std::size_t k = 0; k < tree.size(); ++k) {
      INFO(name << " step " << k);
      const CompositeRate before = to_parent(tree, k, rates[k]);
      const SpatialForce after = force_of_rate(tree.algebra, rates[k], tree.to_child(k, s));
      const RealVector passed = listed(tree.force_to_parent(k, after));
      const RealVector direct = listed(force_of_rate(tree.algebra, before, s));
      const NumbersAt at(derivation.symbols, derivation.definitions, some_state(system.checked));
      CHECK(nearly_equal(at(direct), at(passed)));
    }
  }
}
