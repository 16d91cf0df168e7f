// Transformations along the tree, compared with the poses of the Model.
#include "derive/tree/tree.hpp"

#include <catch2/catch.hpp>

#include "framed.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const ExVector3 some_vector{GiNaC::numeric(2, 3), GiNaC::numeric(-1, 5), GiNaC::numeric(3, 7)};

RealVector listed(const ExVector3& x) { return {x.begin(), x.end()}; }

ExVector3 unit(std::size_t axis) {
  ExVector3 result{0, 0, 0};
  result[axis] = 1;
  return result;
}

}  // namespace

TEST_CASE("to_parent and to_child are inverse", "[frames]") {
  for (const auto& [name, text] : frame_systems()) {
    const Framed system(text);
    Derivation derivation(system.lagrangian);
    KinematicTree& tree = tree_of(derivation);
    for (std::size_t k = 0; k < tree.size(); ++k) {
      INFO(name << " step " << k);
      const ExVector3 forth = tree.to_parent(k, some_vector);
      const RealVector back = listed(tree.to_child(k, forth));
      const NumbersAt at(derivation.symbols, derivation.definitions, some_state(system.checked));
      CHECK(nearly_equal(at(back), at(listed(some_vector))));
    }
  }
}

TEST_CASE("components in the world agree with the frame's rotation", "[frames]") {
  for (const auto& [name, text] : frame_systems()) {
    const Framed system(text);
    const Model& model = system.checked.model;
    const State state = some_state(system.checked);
    for (std::size_t i = 0; i < model.outputs.size(); ++i) {
      if (!model.outputs[i].frame) continue;
      INFO(name << " " << model.outputs[i].name);
      const auto step = system.lagrangian.outputs[i].twist->transform;
      Derivation derivation(system.lagrangian);
      KinematicTree& tree = tree_of(derivation);
      const RealVector world = listed(tree.change_axes(some_vector, step, std::nullopt));
      const RealVector back =
          listed(tree.change_axes({world[0], world[1], world[2]}, std::nullopt, step));
      const NumbersAt at(derivation.symbols, derivation.definitions, state);
      const Reals x = at(listed(some_vector));
      Reals expected(3, 0);
      for (std::size_t entry = 0; entry < 9; ++entry) {
        const ExpressionId id = model.frames[*model.outputs[i].frame].rotation[entry];
        expected[entry / 3] =
            expected[entry / 3] + *oracle_expression_value(model, id, state) * x[entry % 3];
      }
      CHECK(nearly_equal(at(world), expected));
      CHECK(nearly_equal(at(back), x));
    }
  }
}

TEST_CASE("a transformation between arms takes only the steps between them", "[frames]") {
  const Framed system(read_model("two_arms"));
  Derivation derivation(system.lagrangian);
  KinematicTree& tree = tree_of(derivation);
  const ExVector3 same = tree.change_axes(some_vector, 0, std::nullopt);
  CHECK(same[0].is_equal(some_vector[0]));
  const std::size_t before = derivation.definitions.list.size();
  const auto last = static_cast<std::uint32_t>(tree.size() - 1);
  CHECK(tree.change_axes(some_vector, last, last)[1].is_equal(some_vector[1]));
  CHECK(derivation.definitions.list.size() == before);
}

TEST_CASE("the rate of a rotated unit vector is spin x vector", "[frames]") {
  for (const auto& [name, text] : frame_systems()) {
    const Framed system(text);
    Derivation derivation(system.lagrangian);
    KinematicTree& tree = tree_of(derivation);
    for (std::size_t k = 0; k < tree.size(); ++k) {
      INFO(name << " step " << k);
      const ExVector3 spin = tree.relative_spin(k, derivation.motion_rate);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const ExVector3 turned = tree.to_parent(k, unit(axis));
        RealVector rates;
        for (const GiNaC::ex& x : turned) rates.push_back(derivation.motion_rate(x));
        const ExVector3 own = tree.algebra.cross(spin, unit(axis));
        const RealVector expected = listed(tree.to_parent(k, own));
        const NumbersAt at(derivation.symbols, derivation.definitions, some_state(system.checked));
        CHECK(nearly_equal(at(rates), at(expected)));
      }
    }
  }
}

TEST_CASE("quarter turns are permutations without definitions", "[frames]") {
  const Framed system(read_model("two_turns"));
  Derivation derivation(system.lagrangian);
  KinematicTree& tree = tree_of(derivation);
  const std::size_t before = derivation.definitions.list.size();
  for (std::size_t k = 0; k < tree.size(); ++k) {
    if (tree.transform(k).kind != TransformKind::turn || !tree.rotation(k).cosine.is_zero())
      continue;
    const ExVector3 turned = tree.to_parent(k, some_vector);
    CHECK(turned[0].is_equal(some_vector[0]));
    CHECK(turned[1].is_equal(-some_vector[2]));
    CHECK(turned[2].is_equal(some_vector[1]));
  }
  CHECK(derivation.definitions.list.size() == before);
}

TEST_CASE("a force transformed before a translation has a moment about the new origin",
          "[frames]") {
  const Framed system(read_model("planar"));
  Derivation derivation(system.lagrangian);
  KinematicTree& tree = tree_of(derivation);
  for (std::size_t k = 0; k < tree.size(); ++k) {
    if (tree.transform(k).kind != TransformKind::translation) continue;
    const ExVector3& p = tree.transform(k).vector;
    const SpatialForce moved = tree.force_to_parent(k, {{1, 2, 0}, {0, 0, 3}});
    CHECK(moved.force[1].is_equal(2));
    const NumbersAt at(derivation.symbols, derivation.definitions, some_state(system.checked));
    CHECK(nearly_equal({at(moved.moment[2])}, {at(3 + 2 * p[0] - p[1])}));
  }
}
