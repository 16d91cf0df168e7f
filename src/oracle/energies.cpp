// Energies as sums of one term for each armature, expression of [energy], point and body.
#include "oracle/energies.hpp"

#include "numbers/echelon.hpp"

namespace elgen::oracle {
namespace {

const Jet& half() {
  static const Jet value = Jet(cln::cl_RA(1) / 2);
  return value;
}

Jet square(const Jet& x) { return x * x; }

/// 1/2 m |dp/dt|^2
Jet translation_energy(Evaluation& at, const std::optional<ExpressionId>& mass,
                       const std::array<ExpressionId, 3>& position, unsigned dimension) {
  if (!mass) return {};
  Jet sum;
  for (unsigned c = 0; c < dimension; ++c) sum = sum + square(at.rate(position[c]));
  return half() * at.value(*mass) * sum;
}

/// The summands of m gravity.p, mass by mass and axis by axis.
std::vector<Jet> weight_terms(Evaluation& at) {
  const Model& model = at.model();
  std::vector<Jet> terms;
  const auto append_weight = [&](const std::optional<ExpressionId>& mass,
                                 const std::array<ExpressionId, 3>& place) {
    if (!mass) return;
    for (unsigned c = 0; c < 3; ++c) {
      terms.push_back(at.value(*mass) * at.value((*model.gravity)[c]) * at.value(place[c]));
    }
  };
  if (!model.gravity) return terms;
  for (const Point& point : model.points) append_weight(point.mass, point.position);
  for (const Body& body : model.bodies) append_weight(body.mass, body.com);
  return terms;
}

/// w.I w; I is {Izz} or {xx yy zz xy xz yz}.
Jet twice_spin_energy(Evaluation& at, const Body& body) {
  if (body.inertia.empty() || body.spin.empty()) return {};
  if (body.inertia.size() == 1) {
    return at.value(body.inertia[0]) * square(at.value(body.spin.back()));
  }
  const Jet x = at.value(body.spin[0]);
  const Jet y = at.value(body.spin[1]);
  const Jet z = at.value(body.spin[2]);
  const auto inertia = [&](std::size_t i) { return at.value(body.inertia[i]); };
  return inertia(0) * x * x + inertia(1) * y * y + inertia(2) * z * z +
         Jet(2) * (inertia(3) * x * y + inertia(4) * x * z + inertia(5) * y * z);
}

Jet value_or_zero(Evaluation& at, const std::optional<ExpressionId>& expression) {
  return expression ? at.value(*expression) : Jet();
}

Jet armature_energy(Evaluation& at) {
  Jet sum;
  for (const Coordinate& coordinate : at.model().coordinates) {
    if (!coordinate.armature) continue;
    const Jet& rate = at.motion().v[coordinate.velocity];
    sum = sum + half() * at.value(*coordinate.armature) * square(rate);
  }
  return sum;
}

/// The value of an expression with all terms of sums and all factors made positive: the scale of
/// rounding errors, even if sums cancel. The recursion is as deep as the expression.
Jet magnitude(Evaluation& at, ExpressionId id) {
  const Expression& e = at.model().expressions[id];
  Jet result;
  switch (e.kind) {
    case ExpressionKind::negate:
      return magnitude(at, e.operands[0]);
    case ExpressionKind::add:
      for (const ExpressionId term : e.operands) result = result + magnitude(at, term);
      return result;
    case ExpressionKind::multiply:
      result = Jet(1);
      for (const ExpressionId factor : e.operands) result = result * magnitude(at, factor);
      return result;
    default:
      return at.value(id).absolute_coefficients();
  }
}

/// The two highest generators for directions of differentiation; no caller uses them.
constexpr Generators first_cyclic_generator = generator(6);
constexpr Generators second_cyclic_generator = generator(7);

/// L0 (`lagrangian_at_rest`), w (`excess`) and M_cc (`mass`, row-major) of the Routhian in
/// energies.hpp.
struct RouthianTerms {
  Jet lagrangian_at_rest;
  std::vector<Jet> excess = {};
  std::vector<Jet> mass = {};
};

RouthianTerms routhian_terms(const Evaluation& at) {
  const std::vector<CyclicCoordinate>& cyclic = at.model().reduction.cyclic;
  const std::size_t n = cyclic.size();
  const Motion whole = whole_motion(at.model(), at.motion());
  RouthianTerms parts;
  parts.mass.resize(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      Motion moved = whole;
      Jet& rate = moved.v[cyclic[i].velocity];
      rate = rate + Jet(first_cyclic_generator, 1);
      Jet& other = moved.v[cyclic[j].velocity];
      other = other + Jet(second_cyclic_generator, 1);
      Evaluation evaluation(unreduced_model(at.model()), moved);
      const Jet value = lagrangian(evaluation);
      parts.mass[i * n + j] =
          value.tangent(first_cyclic_generator).tangent(second_cyclic_generator);
      parts.mass[j * n + i] = parts.mass[i * n + j];
      if (j < i) continue;
      const Jet momentum = value.tangent(first_cyclic_generator).without(second_cyclic_generator);
      parts.lagrangian_at_rest = value.without(first_cyclic_generator | second_cyclic_generator);
      parts.excess.push_back(at.motion().parameters[cyclic[i].parameter] - momentum);
    }
  }
  return parts;
}

/// v_c from M_cc v_c = w, by elimination from the first row to the last.
std::vector<Jet> solve_cyclic_rates(const RouthianTerms& parts) {
  const std::size_t n = parts.excess.size();
  std::vector<Jet> both;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) both.push_back(parts.mass[i * n + k]);
    both.push_back(parts.excess[i]);
  }
  DiagonalPivot<Jet> field;
  return *Echelon<DiagonalPivot<Jet>>(field, both, n + 1, n).solution();
}

Jet routhian(const Evaluation& at) {
  const RouthianTerms parts = routhian_terms(at);
  const std::vector<Jet> rates = solve_cyclic_rates(parts);
  Jet work;
  for (std::size_t i = 0; i < rates.size(); ++i) work = work + parts.excess[i] * rates[i];
  return parts.lagrangian_at_rest - half() * work;
}

}  // namespace

Motion whole_motion(const Model& model, const Motion& motion) {
  const RemainingVariables left = remaining_variables(unreduced_model(model));
  Motion whole = motion;
  whole.q = left.coordinates.with_zeros(motion.q);
  whole.v = left.velocities.with_zeros(motion.v);
  whole.a = left.velocities.with_zeros(motion.a);
  whole.u = left.inputs.with_zeros(motion.u);
  Evaluation at(model, motion);
  for (const LockedCoordinate& lock : model.reduction.locks) {
    for (std::uint32_t i = 0; i < lock.values.size(); ++i) {
      whole.q[lock.coordinate + i] = at.value(lock.values[i]);
    }
    if (lock.is_rotation) continue;
    whole.v[lock.velocity] = at.rate(lock.values.front());
    whole.a[lock.velocity] = at.second_rate(lock.values.front());
  }
  return whole;
}

std::vector<Jet> cyclic_rates(const Evaluation& at) {
  return solve_cyclic_rates(routhian_terms(at));
}

Jet kinetic_energy(Evaluation& at) {
  const Model& model = at.model();
  Jet sum = armature_energy(at) + value_or_zero(at, model.energies.T);
  for (const Point& point : model.points) {
    sum = sum + translation_energy(at, point.mass, point.position, point.dimension);
  }
  for (const Body& body : model.bodies) {
    sum = sum + half() * twice_spin_energy(at, body);
    sum = sum + translation_energy(at, body.mass, body.com, body.dimension);
  }
  return sum;
}

Jet potential_energy(Evaluation& at) {
  Jet sum = value_or_zero(at, at.model().energies.V);
  for (const Jet& term : weight_terms(at)) sum = sum - term;
  return sum;
}

Jet potential_magnitude(Evaluation& at) {
  const Model& model = at.model();
  Jet sum;
  for (const Jet& term : weight_terms(at)) sum = sum + term.absolute_coefficients();
  return model.energies.V ? sum + magnitude(at, *model.energies.V) : sum;
}

Jet lagrangian(Evaluation& at) {
  if (has_routhian(at.model())) return routhian(at);
  const Jet kinetic = kinetic_energy(at);  // before V, which needs values that T memoises
  return value_or_zero(at, at.model().energies.L) + kinetic - potential_energy(at);
}

Jet dissipation(Evaluation& at) { return value_or_zero(at, at.model().energies.D); }

}  // namespace elgen::oracle
