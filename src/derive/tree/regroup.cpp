// regroup: base inertial parameters. Some parameters of a link affect the motion exactly as
// parameters of the previous link do, and are added to the parameters of the previous link:
//
//     turn about z        mass, h_z and an inertia diag(Iyy, Iyy, 0), which a turn does not change
//     translation         inertia, which a translation does not change
//     constant transform  all parameters
//
//     before    link 2: m, h = (hx, hy, hz), I = (Ixx, Iyy, Izz, Ixy, Ixz, Iyz)       about z
//     after     link 2: 0, (hx, hy, 0), (Ixx - Iyy, 0, Izz, Ixy, Ixz, Iyz)
//               link 1: + m, (0, 0, hz), (Iyy, Iyy, 0, 0, 0, 0)
//
// Gautier, Khalil, IEEE Trans. Robotics and Automation 6(3), 1990.
#include <algorithm>

#include "derive/tree/composite.hpp"

namespace elgen {

namespace {

using GiNaC::ex;

bool is_rational(const ex& value) {
  return GiNaC::is_a<GiNaC::numeric>(value) && GiNaC::ex_to<GiNaC::numeric>(value).is_rational();
}

template <class List>
bool are_rational(const List& values) {
  return std::all_of(values.begin(), values.end(), [](const ex& x) { return is_rational(x); });
}

bool is_rational(const RigidBody& body) {
  return is_rational(body.mass) && are_rational(body.com) && are_rational(body.inertia);
}

/// True if a transform is constant and its entries are rational. With irrational entries the
/// regrouped parameters would be expressions, not numbers.
bool is_constant_rational(const KinematicTree& tree, std::size_t transform) {
  const TransformRotation& r = tree.rotation(transform);
  switch (r.kind) {
    case TransformRotation::Kind::none:
      return are_rational(tree.transform(transform).vector);
    case TransformRotation::Kind::about_axis:
      return is_rational(r.cosine) && is_rational(r.sine);
    case TransformRotation::Kind::matrix:
      return are_rational(r.entries);
  }
  return false;
}

/// The part of an inertia that the motion of a transform does not change.
CompositeInertia invariant_part(const KinematicTree& tree, std::size_t transform,
                                const CompositeInertia& c) {
  const TransformRotation& r = tree.rotation(transform);
  CompositeInertia part;
  if (r.kind == TransformRotation::Kind::none) {
    part.inertia = c.inertia;
    return part;
  }
  part.mass = c.mass;
  if (r.kind == TransformRotation::Kind::matrix) return part;
  const auto& [k, i, j] = cyclic_axes[r.axis];
  part.moment[k] = c.moment[k];
  part.inertia[i] = part.inertia[j] = c.inertia[j];
  return part;
}

CompositeInertia difference(const CompositeInertia& a, const CompositeInertia& b) {
  CompositeInertia result = a;
  result.mass -= b.mass;
  for (std::size_t i = 0; i < 3; ++i) result.moment[i] -= b.moment[i];
  for (std::size_t i = 0; i < 6; ++i) result.inertia[i] -= b.inertia[i];
  return result;
}

bool is_zero_inertia(const CompositeInertia& c) {
  return c.mass.is_zero() && is_zero(c.moment) &&
         std::all_of(c.inertia.begin(), c.inertia.end(), [](const ex& x) { return x.is_zero(); });
}

RigidBody make_body(const CompositeInertia& c, std::optional<std::uint32_t> transform) {
  RigidBody body;
  body.transform = transform;
  body.mass = c.mass;
  body.com = {0, 0, 0};
  body.inertia.assign(c.inertia.begin(), c.inertia.end());
  body.is_about_origin = true;
  body.moment = c.moment;
  return body;
}

RigidBody make_point_mass(const ex& mass, std::optional<std::uint32_t> transform) {
  CompositeInertia point;
  point.mass = mass;
  RigidBody body = make_body(point, transform);
  body.inertia.clear();
  return body;
}

/// The body with mass 0 and the same h and I, about the origin of its transform.
RigidBody without_mass(KinematicTree& tree, const RigidBody& body) {
  CompositeInertia rest = inertia_about_origin(tree.algebra, body);
  rest.mass = 0;
  RigidBody result = make_body(rest, body.transform);
  result.origin = body.origin;
  return result;
}

/// True if `base` is an ancestor of `transform`, and not `transform` itself.
bool is_descendant(const KinematicTree& tree, std::optional<std::uint32_t> transform,
                   std::uint32_t base) {
  if (transform == base) return false;
  while (transform && *transform != base) transform = tree.transform(*transform).parent;
  return transform.has_value();
}

/// Moves the masses of the bodies on the transform `rotation` to a point mass on the parent
/// transform, at the origin of `rotation`. The term 1/2 m v^2 of the point mass contains no
/// quaternion (R^T R = 1 is used), so that T, momenta and forces agree with M even if |q| is not 1.
/// Bodies on descendants of `rotation` keep their masses. Instead, a point mass with the negative
/// sum of these masses is added on `rotation`, at its origin, and a point mass with the sum on the
/// parent transform.
void lift_masses(KinematicTree& tree, std::uint32_t rotation, std::vector<RigidBody>& bodies) {
  ex own = 0;
  ex behind = 0;
  for (RigidBody& body : bodies) {
    if (body.mass.is_zero()) continue;
    if (is_descendant(tree, body.transform, rotation)) behind += body.mass;
    if (body.transform != rotation) continue;
    own += body.mass;
    body = without_mass(tree, body);
  }
  const ex lifted = own + behind;
  if (!behind.is_zero()) bodies.push_back(make_point_mass(-behind, rotation));
  if (!lifted.is_zero()) bodies.push_back(make_point_mass(lifted, tree.transform(rotation).parent));
}

}  // namespace

std::vector<RigidBody> regroup_bodies(KinematicTree& tree) {
  std::vector<RigidBody> bodies;
  std::vector<CompositeInertia> own(tree.size());
  CompositeInertia of_world;
  for (const RigidBody& body : tree.frames().bodies) {
    if (body.transform && is_rational(body)) {
      accumulate(tree.algebra, inertia_about_origin(tree.algebra, body), own[*body.transform]);
    } else {
      bodies.push_back(body);
    }
  }
  for (std::size_t k = tree.size(); k-- > 0;) {
    const auto& parent = tree.transform(k).parent;
    const bool rigid = is_constant_rational(tree, k);
    const CompositeInertia part = rigid ? own[k] : invariant_part(tree, k, own[k]);
    own[k] = difference(own[k], part);
    const CompositeInertia moved = rigid ? to_parent(tree, k, part) : part;
    accumulate(tree.algebra, moved, parent ? own[*parent] : of_world);
  }
  if (!is_zero_inertia(of_world)) bodies.push_back(make_body(of_world, {}));
  for (std::uint32_t k = 0; k < tree.size(); ++k) {
    if (!is_zero_inertia(own[k])) bodies.push_back(make_body(own[k], k));
  }
  return with_lifted_masses(tree, std::move(bodies));
}

std::vector<RigidBody> with_lifted_masses(KinematicTree& tree, std::vector<RigidBody> bodies) {
  for (auto k = static_cast<std::uint32_t>(tree.size()); k-- > 0;) {
    if (tree.transform(k).rotation) lift_masses(tree, k, bodies);
  }
  return bodies;
}

}  // namespace elgen
