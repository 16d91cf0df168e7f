// Composite rates, leaves first.
#include "derive/tree/composite_rate.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// A - (x y^T - (x.y) 1)
ExMatrix3 less_outer(VectorAlgebra& algebra, const ExMatrix3& a, const ExVector3& x,
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

/// As for symmetric matrices (composite.cpp), with u = s (A_ii - A_jj) + c (A_ij + A_ji):
///     A'_ii = A_ii - s u,   A'_jj = A_jj + s u,   A'_ij = c u - A_ji,   A'_ji = c u - A_ij
ExMatrix3 turned_about_axis(VectorAlgebra& algebra, const StepRotation& r, const ExMatrix3& a) {
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

/// R A R^T. Quarter turns permute, which the general product sees by its zeros and ones.
ExMatrix3 turned(Tree& tree, std::size_t step, const ExMatrix3& a) {
  const StepRotation& r = tree.rotation(step);
  const bool is_quarter =
      GiNaC::is_a<GiNaC::numeric>(r.cosine) && GiNaC::is_a<GiNaC::numeric>(r.sine);
  if (r.kind == StepRotation::Kind::about_axis && !is_quarter) {
    return turned_about_axis(tree.algebra, r, a);
  }
  ExMatrix3 rotation = r.entries;
  if (r.kind == StepRotation::Kind::about_axis) {
    for (std::size_t column = 0; column < 3; ++column) {
      ExVector3 unit{0, 0, 0};
      unit[column] = 1;
      const ExVector3 turned_unit = tree.to_parent(step, unit);
      for (std::size_t row = 0; row < 3; ++row) rotation[3 * row + column] = turned_unit[row];
    }
  }
  const ExMatrix3 half = product(tree.algebra, rotation, a);
  return product(tree.algebra, half, transposed(rotation));
}

/// -[w]x Sigma, Sigma = 1/2 tr(I) 1 - I.
ExMatrix3 spin_part(VectorAlgebra& algebra, const std::vector<ex>& inertia, const ExVector3& w) {
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

/// About the origin. An inertia about the com is shifted like a composite.
CompositeRate own_rate(VectorAlgebra& algebra, const RigidBody& body, const Twist& twist) {
  CompositeRate rate;
  if (!body.inertia.empty()) rate.a = spin_part(algebra, body.inertia, twist.spin);
  if (!has_mass(body)) return rate;
  rate.momentum = momentum_of(algebra, body, twist);
  if (body.about_origin) {
    rate.a = less_outer(algebra, rate.a, twist.velocity, first_moment(algebra, body));
  } else {
    rate.a = less_outer(algebra, rate.a, rate.momentum, body.com);
  }
  return rate;
}

}  // namespace

void accumulate(VectorAlgebra& algebra, const CompositeRate& from, CompositeRate& to) {
  for (std::size_t i = 0; i < 9; ++i) to.a[i] = algebra.define(to.a[i] + from.a[i]);
  to.momentum = algebra.add(to.momentum, from.momentum);
}

CompositeRate to_parent(Tree& tree, std::size_t step, const CompositeRate& rate) {
  CompositeRate result = rate;
  if (tree.step(step).kind == FrameStepKind::translation) {
    result.a = less_outer(tree.algebra, rate.a, rate.momentum, tree.step(step).vector);
    return result;
  }
  result.a = turned(tree, step, rate.a);
  result.momentum = tree.to_parent(step, rate.momentum);
  return result;
}

std::vector<CompositeRate> composite_rates(Tree& tree, const std::vector<Twist>& twists) {
  auto own = on_steps<CompositeRate>(tree, [&](const RigidBody& body) {
    return own_rate(tree.algebra, body, twists[*body.step]);
  });
  return with_carried(tree, std::move(own), [&](std::size_t k, const CompositeRate& rate) {
    return to_parent(tree, k, rate);
  });
}

}  // namespace elgen
