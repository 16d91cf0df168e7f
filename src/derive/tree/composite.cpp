// Composite inertias and rates, summed from the leaves to the root.
#include "derive/tree/composite.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// S' = R S R^T, R a rotation about axis k with sine s and cosine c; i, j are the other axes;
/// u = s (S_ii - S_jj) + 2 c S_ij:
///     S'_ii = S_ii - s u,   S'_jj = S_jj + s u,   S'_ij = c u - S_ij
Symmetric3 rotate_about_axis(VectorAlgebra& algebra, const TransformRotation& r,
                             const Symmetric3& s) {
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

Symmetric3 rotate_by_matrix(VectorAlgebra& algebra, const ExMatrix3& r, const Symmetric3& s) {
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

/// Translation by p (parallel-axis theorem), with k = h + h_p:
///     I_p = I + (p.k) 1 - (p k^T + k p^T)/2
CompositeInertia translate_inertia(VectorAlgebra& algebra, const CompositeInertia& c,
                                   const ExVector3& p) {
  CompositeInertia result = c;
  const ExVector3 shift = algebra.scale(c.mass, p);
  result.moment = algebra.add(c.moment, shift);
  const ExVector3 k = algebra.add(c.moment, result.moment);
  ExVector3 along;
  for (std::size_t i = 0; i < 3; ++i) along[i] = algebra.define(p[i] * k[i]);
  for (const auto& [i, j, l] : cyclic_axes) {
    result.inertia[i] = algebra.define(c.inertia[i] + along[j] + along[l]);
    // (p_i k_j + p_j k_i)/2 = p_i (h)_j + p_j (h_p)_i, since h_p = h + m p.
    const ex across = p[i] * c.moment[j] + p[j] * result.moment[i];
    result.inertia[symmetric_index(i, j)] =
        algebra.define(c.inertia[symmetric_index(i, j)] - across);
  }
  return result;
}

/// A - (x y^T - (x.y) 1)
ExMatrix3 subtract_outer_product(VectorAlgebra& algebra, const ExMatrix3& a, const ExVector3& x,
                                 const ExVector3& y) {
  ExMatrix3 result = a;
  ExVector3 along;
  for (std::size_t i = 0; i < 3; ++i) along[i] = algebra.define(x[i] * y[i]);
  for (const auto& [i, j, k] : cyclic_axes) {
    result[3 * i + i] = algebra.define(a[3 * i + i] + along[j] + along[k]);
    result[3 * i + j] = algebra.define(a[3 * i + j] - x[i] * y[j]);
    result[3 * i + k] = algebra.define(a[3 * i + k] - x[i] * y[k]);
  }
  return result;
}

/// A' = R A R^T, as for symmetric matrices, with u = s (A_ii - A_jj) + c (A_ij + A_ji):
///     A'_ii = A_ii - s u,   A'_jj = A_jj + s u,   A'_ij = c u - A_ji,   A'_ji = c u - A_ij
ExMatrix3 rotate_about_axis(VectorAlgebra& algebra, const TransformRotation& r,
                            const ExMatrix3& a) {
  const auto& [k, i, j] = cyclic_axes[r.axis];
  ExMatrix3 result = a;
  const ex difference = algebra.define(a[3 * i + i] - a[3 * j + j]);
  const ex sum = algebra.define(a[3 * i + j] + a[3 * j + i]);
  const ex u = algebra.define(r.sine * difference + r.cosine * sum);
  const ex shift = algebra.define(r.sine * u);
  const ex across = algebra.define(r.cosine * u);
  result[3 * i + i] = algebra.define(a[3 * i + i] - shift);
  result[3 * j + j] = algebra.define(a[3 * j + j] + shift);
  result[3 * i + j] = algebra.define(across - a[3 * j + i]);
  result[3 * j + i] = algebra.define(across - a[3 * i + j]);
  result[3 * k + i] = algebra.define(r.cosine * a[3 * k + i] - r.sine * a[3 * k + j]);
  result[3 * k + j] = algebra.define(r.sine * a[3 * k + i] + r.cosine * a[3 * k + j]);
  result[3 * i + k] = algebra.define(r.cosine * a[3 * i + k] - r.sine * a[3 * j + k]);
  result[3 * j + k] = algebra.define(r.sine * a[3 * i + k] + r.cosine * a[3 * j + k]);
  return result;
}

ExMatrix3 product(VectorAlgebra& algebra, const ExMatrix3& a, const ExMatrix3& b) {
  ExMatrix3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result[3 * i + j] =
          algebra.define(a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j]);
    }
  }
  return result;
}

/// -[w]x Sigma, Sigma = 1/2 tr(I) 1 - I.
ExMatrix3 spin_rate_matrix(VectorAlgebra& algebra, const std::vector<ex>& inertia,
                           const ExVector3& w) {
  const ex half_trace = algebra.define((inertia[0] + inertia[1] + inertia[2]) / 2);
  Symmetric3 sigma;
  for (std::size_t i = 0; i < 3; ++i) sigma[i] = algebra.define(half_trace - inertia[i]);
  for (std::size_t i = 3; i < 6; ++i) sigma[i] = algebra.define(-inertia[i]);
  ExMatrix3 result;
  for (const auto& [i, j, k] : cyclic_axes) {
    for (std::size_t column = 0; column < 3; ++column) {
      result[3 * i + column] = algebra.define(w[k] * sigma[symmetric_index(j, column)] -
                                              w[j] * sigma[symmetric_index(k, column)]);
    }
  }
  return result;
}

/// B of one body about the origin of its transform. If the inertia is about the com, A is
/// translated from the com to the origin, as in to_parent().
CompositeRate body_rate(VectorAlgebra& algebra, const RigidBody& body, const Twist& twist) {
  CompositeRate rate;
  if (!body.inertia.empty()) rate.a = spin_rate_matrix(algebra, body.inertia, twist.spin);
  if (!has_mass(body)) return rate;
  rate.momentum = linear_momentum(algebra, body, twist);
  if (body.is_about_origin) {
    rate.a = subtract_outer_product(algebra, rate.a, twist.velocity, first_moment(algebra, body));
  } else {
    rate.a = subtract_outer_product(algebra, rate.a, rate.momentum, body.com);
  }
  return rate;
}

}  // namespace

void accumulate(VectorAlgebra& algebra, const CompositeInertia& from, CompositeInertia& to) {
  to.mass = algebra.define(to.mass + from.mass);
  to.moment = algebra.add(to.moment, from.moment);
  for (std::size_t i = 0; i < 6; ++i) {
    to.inertia[i] = algebra.define(to.inertia[i] + from.inertia[i]);
  }
}

CompositeInertia inertia_about_origin(VectorAlgebra& algebra, const RigidBody& body) {
  CompositeInertia result;
  result.mass = body.mass;
  result.moment = first_moment(algebra, body);
  for (std::size_t i = 0; i < body.inertia.size(); ++i) result.inertia[i] = body.inertia[i];
  if (body.is_about_origin) return result;
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

Symmetric3 to_parent(KinematicTree& tree, std::size_t transform, const Symmetric3& s) {
  const TransformRotation& r = tree.rotation(transform);
  switch (r.kind) {
    case TransformRotation::Kind::none:
      return s;
    case TransformRotation::Kind::about_axis:
      return rotate_about_axis(tree.algebra, r, s);
    case TransformRotation::Kind::matrix:
      break;
  }
  return rotate_by_matrix(tree.algebra, r.entries, s);
}

/// R A R^T. For a constant quarter turn, the general product is cheap: the entries 0 and +-1 of R
/// reduce the product to a permutation with signs.
ExMatrix3 to_parent(KinematicTree& tree, std::size_t transform, const ExMatrix3& a) {
  const TransformRotation& r = tree.rotation(transform);
  const bool is_quarter =
      GiNaC::is_a<GiNaC::numeric>(r.cosine) && GiNaC::is_a<GiNaC::numeric>(r.sine);
  if (r.kind == TransformRotation::Kind::about_axis && !is_quarter) {
    return rotate_about_axis(tree.algebra, r, a);
  }
  ExMatrix3 rotation = r.entries;
  if (r.kind == TransformRotation::Kind::about_axis) {
    for (std::size_t column = 0; column < 3; ++column) {
      ExVector3 unit{0, 0, 0};
      unit[column] = 1;
      const ExVector3 turned_unit = tree.to_parent(transform, unit);
      for (std::size_t row = 0; row < 3; ++row) rotation[3 * row + column] = turned_unit[row];
    }
  }
  const ExMatrix3 half = product(tree.algebra, rotation, a);
  return product(tree.algebra, half, transposed(rotation));
}

CompositeInertia to_parent(KinematicTree& tree, std::size_t transform, const CompositeInertia& c) {
  if (tree.transform(transform).kind == TransformKind::translation) {
    return translate_inertia(tree.algebra, c, tree.transform(transform).vector);
  }
  CompositeInertia result = c;
  result.moment = tree.to_parent(transform, c.moment);
  result.inertia = to_parent(tree, transform, c.inertia);
  return result;
}

std::vector<CompositeInertia> composite_inertias(KinematicTree& tree) {
  const NameScope inertias = tree.algebra.name_scope("inertia");
  auto own = sum_over_bodies<CompositeInertia>(
      tree, [&](const RigidBody& body) { return inertia_about_origin(tree.algebra, body); });
  return subtree_sums(tree, std::move(own), [&](std::size_t k, const CompositeInertia& inertia) {
    return to_parent(tree, k, inertia);
  });
}

SpatialForce spatial_momentum(VectorAlgebra& algebra, const CompositeInertia& inertia,
                              const ExVector3& spin, const ExVector3& velocity) {
  SpatialForce result;
  const ExVector3 linear = algebra.scale(inertia.mass, velocity);
  const ExVector3 turning = algebra.cross(spin, inertia.moment);
  result.force = algebra.add(linear, turning);
  const ExVector3 own = product(algebra, inertia.inertia, spin);
  const ExVector3 lever = algebra.cross(inertia.moment, velocity);
  result.moment = algebra.add(own, lever);
  return result;
}

void accumulate(VectorAlgebra& algebra, const CompositeRate& from, CompositeRate& to) {
  for (std::size_t i = 0; i < 9; ++i) to.a[i] = algebra.define(to.a[i] + from.a[i]);
  to.momentum = algebra.add(to.momentum, from.momentum);
}

CompositeRate to_parent(KinematicTree& tree, std::size_t transform, const CompositeRate& rate) {
  CompositeRate result = rate;
  if (tree.transform(transform).kind == TransformKind::translation) {
    result.a = subtract_outer_product(tree.algebra, rate.a, rate.momentum,
                                      tree.transform(transform).vector);
    return result;
  }
  result.a = to_parent(tree, transform, rate.a);
  result.momentum = tree.to_parent(transform, rate.momentum);
  return result;
}

std::vector<CompositeRate> composite_rates(KinematicTree& tree, const std::vector<Twist>& twists) {
  const NameScope rates = tree.algebra.name_scope("inertia_rate");
  auto own = sum_over_bodies<CompositeRate>(tree, [&](const RigidBody& body) {
    return body_rate(tree.algebra, body, twists[*body.transform]);
  });
  return subtree_sums(tree, std::move(own), [&](std::size_t k, const CompositeRate& rate) {
    return to_parent(tree, k, rate);
  });
}

}  // namespace elgen
