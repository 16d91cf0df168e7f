// Expansion: the point from the model's expressions, and motions scaled towards it.
#include "oracle/expansion.hpp"

#include "oracle/mechanics.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_R;
using KnownValues = std::vector<std::optional<cl_R>>;

void scale(std::vector<Jet>& quantity, const KnownValues& about, const Jet& s) {
  for (std::size_t i = 0; i < quantity.size(); ++i) {
    if (about[i]) quantity[i] = Jet(*about[i]) + s * (quantity[i] - Jet(*about[i]));
  }
}

/// Evaluates expressions made of parameters.
KnownValues values_of(const Model& model,
                      const std::vector<std::optional<ExpressionId>>& expressions,
                      const State& state) {
  const Motion motion = motion_of(state);
  Evaluation at(model, motion);
  KnownValues values;
  for (const auto& expression : expressions) {
    values.push_back(expression ? std::optional(at.value(*expression).real()) : std::nullopt);
  }
  return values;
}

}  // namespace

std::optional<ExpansionPoint> expansion_point(const Model& model, const State& state) {
  if (!model.approximation) return std::nullopt;
  const Approximation& approximation = *model.approximation;
  ExpansionPoint point;
  point.order = approximation.order;
  point.q = values_of(model, approximation.coordinates, state);
  point.u = values_of(model, approximation.inputs, state);
  point.v.resize(model.velocities.size());
  for (std::size_t i = 0; i < point.q.size(); ++i) {
    if (!approximation.small[i]) point.q[i].reset();
    if (approximation.small[i]) point.v[model.coordinates[i].velocity] = cl_R(0);
  }
  const bool small_inputs = approximation.small_inputs;
  for (std::optional<cl_R>& value : point.u) {
    if (!small_inputs) value.reset();
    if (small_inputs && !value) value = cl_R(0);
  }
  return point;
}

Motion towards(const ExpansionPoint& point, const Motion& motion, unsigned order) {
  const Jet s(graded_symbol(order), 1);
  Motion result = motion;
  scale(result.q, point.q, s);
  scale(result.v, point.v, s);
  scale(result.a, point.v, s);
  scale(result.u, point.u, s);
  return result;
}

}  // namespace elgen::oracle
