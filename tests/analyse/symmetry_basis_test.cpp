// Kinds of generators, and a basis that prefers common rotations of all points.
#include "analyse/symmetry_basis.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "forms/present/arithmetic.hpp"
#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// The layout of the generators of a model with `scalars` coordinates of armature 1 and, if
/// `has_rotation`, a rotation.
GeneratorLayout class_of(std::size_t scalars, bool has_rotation = false) {
  std::string text;
  for (std::size_t i = 1; i <= scalars; ++i) {
    text += "[[coordinate]]\nname = \"q" + std::to_string(i) + "\"\narmature = 1\n";
  }
  if (has_rotation) {
    text +=
        "[[coordinate]]\nname = \"attitude\"\nkind = \"rotation\"\n[[frame]]\nname = \"top\"\n"
        "parent = \"world\"\nrotation = \"attitude\"\n[[body]]\nname = \"rigid\"\n"
        "frame = \"top\"\nmass = 1\ninertia = [1, 2, 3]\n";
  }
  text += "[energy]\nV = 0\n";
  return GeneratorLayout(checked_model(model_text("points", text)).model);
}

using Unknowns = std::vector<std::pair<std::size_t, int>>;

Generator generator(const GeneratorLayout& all, const Unknowns& values) {
  Generator result(all.size());
  for (const auto& [unknown, value] : values) result[unknown] = fraction_of(cln::cl_RA(value));
  return result;
}

/// dq_k = q_i, dq_i = -q_k
Unknowns turn(const GeneratorLayout& all, std::size_t i, std::size_t k) {
  return {{all.a_index(k, i), 1}, {all.a_index(i, k), -1}};
}

Unknowns concatenate(Unknowns first, const Unknowns& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

bool are_equal(ClosedForms& forms, const Generator& x, const Generator& y) {
  REQUIRE(x.size() == y.size());
  for (std::size_t u = 0; u < x.size(); ++u) {
    if (!is_proved_equal(forms, x[u], y[u])) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("the unknowns of a class are numbered consecutively") {
  const GeneratorLayout plane = class_of(2);
  CHECK(plane.size() == 4 + 2 + 2 + 1);
  CHECK(plane.a_index(1, 0) == 2);
  CHECK(plane.c_index(0) == 4);
  CHECK(plane.b_index(0) == 6);
  CHECK(plane.time_index() == 8);
  const GeneratorLayout body = class_of(3, true);
  CHECK(body.size() == 9 + 3 + 3 + 6 + 1);
  CHECK(body.world_turn_index(0, 0) == 15);
  CHECK(body.body_turn_index(0, 2) == 20);
  CHECK(body.time_index() == 21);
}

TEST_CASE("the kind of a generator follows from its motion") {
  ClosedForms forms;
  const GeneratorLayout all = class_of(2, true);
  const auto kind = [&](const Unknowns& values) {
    return kind_of(forms, all, generator(all, values));
  };
  CHECK(kind({{all.time_index(), 1}}) == SymmetryKind::time);
  CHECK(kind({{all.b_index(1), 3}}) == SymmetryKind::coordinate);
  CHECK(kind({{all.b_index(0), 1}, {all.b_index(1), -1}}) == SymmetryKind::translation);
  CHECK(kind({{all.c_index(0), 1}}) == SymmetryKind::boost);
  CHECK(kind({{all.c_index(0), 1}, {all.c_index(1), 2}}) == SymmetryKind::boost);
  CHECK(kind(turn(all, 0, 1)) == SymmetryKind::rotation);
  CHECK(kind({{all.world_turn_index(0, 2), 1}}) == SymmetryKind::body_rotation);
  CHECK(kind({{all.world_turn_index(0, 2), 1}, {all.body_turn_index(0, 0), 1}}) ==
        SymmetryKind::body_rotation);
  CHECK(kind({{all.a_index(0, 1), 1}, {all.a_index(1, 0), 1}}) == SymmetryKind::other);
  CHECK(kind({{all.a_index(0, 0), 1}}) == SymmetryKind::other);
  CHECK(kind(concatenate(turn(all, 0, 1), {{all.time_index(), 1}})) == SymmetryKind::other);
  CHECK(kind({{all.b_index(0), 1}, {all.c_index(0), 1}}) == SymmetryKind::other);
  CHECK(kind({{all.b_index(0), 1}, {all.time_index(), 1}}) == SymmetryKind::other);
}

TEST_CASE("two independent rotations become the common rotation and one of them") {
  ClosedForms forms;
  const GeneratorLayout all = class_of(4);
  const Generator first = generator(all, turn(all, 0, 1));
  const Generator second = generator(all, turn(all, 2, 3));
  std::vector<Generator> basis{first, second};
  prefer_common_rotations(forms, all, basis);
  REQUIRE(basis.size() == 2);
  CHECK(are_equal(forms, basis[0], generator(all, concatenate(turn(all, 0, 1), turn(all, 2, 3)))));
  CHECK(are_equal(forms, basis[1], second));
}

TEST_CASE("rotations in space turn x to y, y to z, z to x") {
  ClosedForms forms;
  const GeneratorLayout all = class_of(3);
  std::vector<Generator> basis{generator(all, turn(all, 0, 1)), generator(all, turn(all, 0, 2)),
                               generator(all, turn(all, 1, 2))};
  prefer_common_rotations(forms, all, basis);
  REQUIRE(basis.size() == 3);
  CHECK(are_equal(forms, basis[0], generator(all, turn(all, 0, 1))));
  CHECK(are_equal(forms, basis[1], generator(all, turn(all, 2, 0))));
  CHECK(are_equal(forms, basis[2], generator(all, turn(all, 1, 2))));
}

TEST_CASE("a common rotation that is no symmetry is not preferred") {
  ClosedForms forms;
  const GeneratorLayout all = class_of(2);
  Arithmetic arithmetic(forms.algebra);
  // dx = -k y, dy = x
  Generator elliptic = generator(all, {{all.a_index(1, 0), 1}});
  elliptic[all.a_index(0, 1)] = arithmetic.negate(arithmetic.leaf(Opcode::parameter, 0)).value();
  std::vector<Generator> basis{elliptic, generator(all, {{all.time_index(), 1}})};
  prefer_common_rotations(forms, all, basis);
  CHECK(are_equal(forms, basis[0], elliptic));
  CHECK(kind_of(forms, all, basis[0]) == SymmetryKind::other);
  // Only the sum of the rotation in the plane and a shift of time is a symmetry.
  std::vector<Generator> mixed{
      generator(all, concatenate(turn(all, 0, 1), {{all.time_index(), 2}}))};
  const Generator before = mixed[0];
  prefer_common_rotations(forms, all, mixed);
  CHECK(are_equal(forms, mixed[0], before));
}
