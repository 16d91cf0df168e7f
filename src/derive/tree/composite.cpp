// Composite inertias, leaves first.
#include "derive/tree/composite.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// About axis k with i, j the two others; u = s (S_ii - S_jj) + 2 c S_ij:
///     S'_ii = S_ii - s u,   S'_jj = S_jj + s u,   S'_ij = c u - S_ij
Symmetric3 turned_about_axis(VectorAlgebra& algebra, const StepRotation& r, const Symmetric3& s) {
  const auto& [k, i, j] = cyclic_axes[r.axis];
  const ex& across = s[symmetric_index(i, j)];
  Symmetric3 result = s;
  if (GiNaC::is_a<GiNaC::numeric>(r.cosine)) {
    const ex cc = r.cosine * r.cosine;
    const ex cs = r.cosine * r.sine;
    const ex ss = r.sine * r.sine;
    result[i] = algebra.define(cc * s[i] - 2 * cs * across + ss * s[j]);
    result[j] = algebra.define(ss * s[i] + 2 * cs * across + cc * s[j]);
    result[symmetric_index(i, j)] = algebra.define(cs * (s[i] - s[j]) + (cc - ss) * across);
  } else {
    const ex difference = algebra.define(s[i] - s[j]);
    const ex twice = algebra.define(2 * across);
    const ex u = algebra.define(r.sine * difference + r.cosine * twice);
    const ex shift = algebra.define(r.sine * u);
    result[i] = algebra.define(s[i] - shift);
    result[j] = algebra.define(s[j] + shift);
    result[symmetric_index(i, j)] = algebra.define(r.cosine * u - across);
  }
  const ex& ki = s[symmetric_index(k, i)];
  const ex& kj = s[symmetric_index(k, j)];
  result[symmetric_index(k, i)] = algebra.define(r.cosine * ki - r.sine * kj);
  result[symmetric_index(k, j)] = algebra.define(r.sine * ki + r.cosine * kj);
  return result;
}

Symmetric3 turned_by_matrix(VectorAlgebra& algebra, const ExMatrix3& r, const Symmetric3& s) {
  std::array<ExVector3, 3> half;  // rows of R S
  for (std::size_t i = 0; i < 3; ++i) {
    half[i] = product(algebra, s, {r[3 * i], r[3 * i + 1], r[3 * i + 2]});
  }
  Symmetric3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      const ExVector3 row{r[3 * j], r[3 * j + 1], r[3 * j + 2]};
      result[symmetric_index(i, j)] = algebra.dot(half[i], row);
    }
  }
  return result;
}

/// Adds p^2-like terms: (p.k) 1 - (p k^T + k p^T)/2 with k = h + h_p, symmetric in p and k.
CompositeInertia shifted(VectorAlgebra& algebra, const CompositeInertia& c, const ExVector3& p) {
  CompositeInertia result = c;
  const ExVector3 shift = algebra.scaled(c.mass, p);
  result.moment = algebra.add(c.moment, shift);
  const ExVector3 k = algebra.add(c.moment, result.moment);
  ExVector3 along;
  for (std::size_t i = 0; i < 3; ++i) along[i] = algebra.define(p[i] * k[i]);
  for (const auto& [i, j, l] : cyclic_axes) {
    result.inertia[i] = algebra.define(c.inertia[i] + along[j] + along[l]);
    // (p_i k_j + p_j k_i)/2 = p_i h_j + p_j h'_i, since h' = h + m p.
    const ex across = p[i] * c.moment[j] + p[j] * result.moment[i];
    result.inertia[symmetric_index(i, j)] =
        algebra.define(c.inertia[symmetric_index(i, j)] - across);
  }
  return result;
}

}  // namespace

void accumulate(VectorAlgebra& algebra, const CompositeInertia& from, CompositeInertia& to) {
  to.mass = algebra.define(to.mass + from.mass);
  to.moment = algebra.add(to.moment, from.moment);
  for (std::size_t i = 0; i < 6; ++i) {
    to.inertia[i] = algebra.define(to.inertia[i] + from.inertia[i]);
  }
}

CompositeInertia about_origin(VectorAlgebra& algebra, const RigidBody& body) {
  CompositeInertia result;
  result.mass = body.mass;
  result.moment = first_moment(algebra, body);
  for (std::size_t i = 0; i < body.inertia.size(); ++i) result.inertia[i] = body.inertia[i];
  if (body.about_origin) return result;
  ExVector3 squares;
  for (std::size_t i = 0; i < 3; ++i) squares[i] = algebra.define(body.com[i] * result.moment[i]);
  for (const auto& [i, j, l] : cyclic_axes) {
    ex& across = result.inertia[symmetric_index(i, j)];
    result.inertia[i] = algebra.define(result.inertia[i] + squares[j] + squares[l]);
    across = algebra.define(across - body.com[i] * result.moment[j]);
  }
  return result;
}

std::size_t symmetric_index(std::size_t i, std::size_t j) { return i == j ? i : 2 + i + j; }

ExVector3 product(VectorAlgebra& algebra, const Symmetric3& s, const ExVector3& x) {
  return algebra.define(ExVector3{s[0] * x[0] + s[3] * x[1] + s[4] * x[2],
                                  s[3] * x[0] + s[1] * x[1] + s[5] * x[2],
                                  s[4] * x[0] + s[5] * x[1] + s[2] * x[2]});
}

Symmetric3 to_parent(Tree& tree, std::size_t step, const Symmetric3& s) {
  const StepRotation& r = tree.rotation(step);
  switch (r.kind) {
    case StepRotation::Kind::none:
      return s;
    case StepRotation::Kind::about_axis:
      return turned_about_axis(tree.algebra, r, s);
    case StepRotation::Kind::matrix:
      break;
  }
  return turned_by_matrix(tree.algebra, r.entries, s);
}

CompositeInertia to_parent(Tree& tree, std::size_t step, const CompositeInertia& c) {
  if (tree.step(step).kind == FrameStepKind::translation) {
    return shifted(tree.algebra, c, tree.step(step).vector);
  }
  CompositeInertia result = c;
  result.moment = tree.to_parent(step, c.moment);
  result.inertia = to_parent(tree, step, c.inertia);
  return result;
}

std::vector<CompositeInertia> composite_inertias(Tree& tree) {
  auto own = on_steps<CompositeInertia>(
      tree, [&](const RigidBody& body) { return about_origin(tree.algebra, body); });
  return with_carried(tree, std::move(own), [&](std::size_t k, const CompositeInertia& inertia) {
    return to_parent(tree, k, inertia);
  });
}

SpatialForce momentum(VectorAlgebra& algebra, const CompositeInertia& inertia,
                      const ExVector3& spin, const ExVector3& velocity) {
  SpatialForce result;
  const ExVector3 linear = algebra.scaled(inertia.mass, velocity);
  const ExVector3 turning = algebra.cross(spin, inertia.moment);
  result.force = algebra.add(linear, turning);
  const ExVector3 own = product(algebra, inertia.inertia, spin);
  const ExVector3 lever = algebra.cross(inertia.moment, velocity);
  result.moment = algebra.add(own, lever);
  return result;
}

}  // namespace elgen
