// E512: gravity or `[energy] V` pushes a mass upwards. This is reported in two cases: [gravity] has
// a positive last component, because in most models the last axis is vertical; or V contains the
// height of a point with a mass, and V decreases at a constant rate as the point rises.
//
// For V, the upward direction is opposite to [gravity] or, without [gravity], the last axis of the
// point. The point gets an additional coordinate, its lift, and dV/d(lift) is sampled. If
// dV/d(lift) is negative and the same at all samples, V contains a weight with the wrong sign.
//
// E526: `[energy] V` contains a weight that [gravity] already adds. E527: `[energy] T` contains a
// kinetic energy that a mass already adds.
//
//     added by elgen                                      compared with
//     W = -sum m gravity.p of the points and bodies       V of [energy]
//     K = sum 1/2 m v^2 of the points                     T of [energy]
//
// We compare only the part of an energy that depends on the parameters of the mass (and, for V, on
// the parameters of gravity): the energy minus its value with these parameters set to 0. If V and W
// have the same part up to a constant, the weight is counted twice; the same holds for T and K. For
// a mass or gravity without parameters, nothing is subtracted.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <set>

#include "elgen/references.hpp"
#include "inspect/checks.hpp"
#include "inspect/samples.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

using cln::cl_R;
using UpVector = std::array<cl_R, 3>;
using ParameterSet = std::set<std::uint32_t>;

/// The points whose coordinates an expression contains, directly or through names.
std::vector<std::uint32_t> points_in(const Model& model, ExpressionId root) {
  std::vector<std::uint32_t> points;
  for (const ExpressionId id : reachable_expressions(model, {root})) {
    const Expression& e = model.expressions[id];
    if (refers_to_entry(e, NamedKind::point)) points.push_back(e.index);
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// The upward direction: opposite to [gravity] or, without [gravity], the last axis of the point.
std::optional<UpVector> up_direction(const InspectedModel& subject, const Point& point) {
  UpVector up{0, 0, 0};
  if (!subject.model.gravity) {
    up[point.dimension - 1] = 1;
    return up;
  }
  const State state = nominal_state(subject.model, subject.scene);
  for (std::size_t c = 0; c < 3; ++c) {
    const auto component =
        oracle_expression_value(subject.model, (*subject.model.gravity)[c], state);
    if (!component) return std::nullopt;
    up[c] = -*component;
  }
  return up;
}

ExpressionId append_node(Model& model, Expression expression) {
  model.expressions.push_back(std::move(expression));
  return static_cast<ExpressionId>(model.expressions.size() - 1);
}

ExpressionId append_operation(Model& model, ExpressionKind kind,
                              std::vector<ExpressionId> operands) {
  return append_node(model, {.kind = kind, .operands = std::move(operands)});
}

ExpressionId append_number(Model& model, const cl_R& value) {
  return append_node(model, {.number = cln::rational(value)});
}

/// A copy of the model with one more coordinate, which moves the point along `up`.
Model with_lift_coordinate(const Model& model, std::uint32_t point, const UpVector& up) {
  Model result = model;
  const std::uint32_t coordinate = append_coordinate(result, {});
  const ExpressionId lift = append_node(
      result, {.kind = ExpressionKind::leaf, .leaf = Opcode::coordinate, .index = coordinate});
  for (std::size_t c = 0; c < 3; ++c) {
    if (cln::zerop(up[c])) continue;
    const ExpressionId scale = append_number(result, up[c]);
    const ExpressionId shift = append_operation(result, ExpressionKind::multiply, {scale, lift});
    ExpressionId& at = result.points[point].position[c];
    at = append_operation(result, ExpressionKind::add, {at, shift});
  }
  return result;
}

/// dV/d(lift) at a state, with V = `potential`; none if the slope has no value.
std::optional<cl_R> lift_slope(const Model& liftable, ExpressionId potential, State state) {
  state.v.assign(liftable.velocities.size(), cl_R(0));
  state.a = state.v;
  state.q.emplace_back(0);
  const auto at_rest = oracle_expression_rate(liftable, potential, state);
  state.v.back() = 1;
  const auto rising = oracle_expression_rate(liftable, potential, state);
  if (!at_rest || !rising) return std::nullopt;
  return *rising - *at_rest;
}

bool has_mass(const Model& model, std::uint32_t point) {
  if (model.points[point].mass) return true;
  if (!model.energies.T) return false;
  const std::vector<std::uint32_t> moving = points_in(model, *model.energies.T);
  return std::find(moving.begin(), moving.end(), point) != moving.end();
}

bool has_falling_potential(const InspectedModel& subject, std::uint32_t point, const UpVector& up) {
  const Model lifted = with_lift_coordinate(subject.model, point, up);
  std::optional<cl_R> first;
  for (unsigned seed = 0; seed < zero_sample_count; ++seed) {
    const auto here = lift_slope(lifted, *subject.model.energies.V, sample_state(subject, seed));
    if (!here || *here >= 0) return false;
    if (!first) first = here;
    // The slope of a weight is constant to 50 digits; the slope of a spring is not.
    if (cln::abs(*here - *first) > -*first * power_of_ten(-50)) return false;
  }
  return true;
}

/// The dimension of the points and bodies, 2 or 3; 0 if the model has neither.
std::uint32_t dimension_of(const Model& model) {
  if (!model.points.empty()) return model.points.front().dimension;
  return model.bodies.empty() ? 0 : model.bodies.front().dimension;
}

/// E512 if gravity pulls along the positive last axis ("y" or "z"), which points upwards in most
/// models.
Diagnostics upward_gravity_errors(const InspectedModel& subject) {
  const Model& model = subject.model;
  const std::uint32_t dimension = dimension_of(model);
  if (!model.gravity || dimension == 0) return {};
  const std::uint32_t last = dimension - 1;
  const State state = nominal_state(model, subject.scene);
  const auto component = oracle_expression_value(model, (*model.gravity)[last], state);
  if (!component || *component <= 0) return {};
  return {{Code::E512, model.expressions[(*model.gravity)[last]].span,
           fmt::format("gravity pulls along +{}", last == 1 ? "y" : "z"),
           "if the axis points up, gravity is negative: sign mistake?"}};
}

// Energies that masses already add.

ParameterSet parameters_in(const Model& model, const std::vector<ExpressionId>& roots) {
  ParameterSet found;
  for (const ExpressionId id : reachable_expressions(model, roots)) {
    const Expression& node = model.expressions[id];
    if (is_leaf(node, Opcode::parameter)) found.insert(node.index);
  }
  return found;
}

/// A mass m and its position p; the weight has the energy -m gravity.p.
struct PlacedMass {
  std::string name;
  ExpressionId mass = 0;
  std::array<ExpressionId, 3> at = {};
};

std::vector<PlacedMass> placed_masses(const Model& model) {
  std::vector<PlacedMass> weights;
  for (const Point& point : model.points) {
    if (point.mass) weights.push_back({point.name, *point.mass, point.position});
  }
  for (const Body& body : model.bodies) {
    if (body.mass) weights.push_back({body.name, *body.mass, body.com});
  }
  return weights;
}

/// -m gravity.p; none if m, gravity or p has no value.
std::optional<cl_R> weight_energy(const Model& model, const PlacedMass& weight,
                                  const State& state) {
  const auto mass = oracle_expression_value(model, weight.mass, state);
  if (!mass) return std::nullopt;
  cl_R energy = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto pull = oracle_expression_value(model, (*model.gravity)[c], state);
    const auto place = oracle_expression_value(model, weight.at[c], state);
    if (!pull || !place) return std::nullopt;
    energy = energy - *mass * *pull * *place;
  }
  return energy;
}

using StateEnergy = std::function<std::optional<cl_R>(const State&)>;

/// The part of an energy that vanishes if the parameters of any of the first `count` sets are 0.
std::optional<cl_R> dependent_part(const StateEnergy& energy, const std::vector<ParameterSet>& sets,
                                   std::size_t count, const State& state) {
  if (count == 0) return energy(state);
  State without = state;
  for (const std::uint32_t index : sets[count - 1]) without.parameters[index] = 0;
  const auto with_all = dependent_part(energy, sets, count - 1, state);
  const auto with_none = dependent_part(energy, sets, count - 1, without);
  return with_all && with_none ? std::optional(*with_all - *with_none) : std::nullopt;
}

/// The dependent part of an energy at each sampled state, minus the dependent part at the first
/// state, because a constant in an energy has no effect.
std::vector<cl_R> dependent_differences(const InspectedModel& subject, const StateEnergy& energy,
                                        const std::vector<ParameterSet>& sets) {
  std::vector<cl_R> values;
  State state = sample_state(subject, 0);
  const std::vector<cl_R> parameters = state.parameters;
  for (unsigned seed = 0; seed <= zero_sample_count; ++seed) {
    state = sample_state(subject, seed);
    state.parameters = parameters;
    const auto value = dependent_part(energy, sets, sets.size(), state);
    if (!value) return {};
    values.push_back(*value);
  }
  for (std::size_t i = 1; i < values.size(); ++i) values[i] = values[i] - values[0];
  values.erase(values.begin());
  return values;
}

bool are_equal_and_nonzero(const std::vector<cl_R>& a, const std::vector<cl_R>& b) {
  if (a.empty() || b.empty()) return false;
  bool is_zero = true;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (cln::abs(a[i] - b[i]) > cln::abs(b[i]) * power_of_ten(-40)) return false;
    is_zero = is_zero && cln::abs(b[i]) < power_of_ten(-40);
  }
  return !is_zero;
}

/// state -> sum of of_entry(entry, state) over all entries; none if an entry has no value.
template <class Entry, class Of>
StateEnergy sum_of_energies(const std::vector<Entry>& entries, const Of& of_entry) {
  return [&entries, of_entry](const State& state) -> std::optional<cl_R> {
    cl_R sum = 0;
    for (const Entry& entry : entries) {
      const auto energy = of_entry(entry, state);
      if (!energy) return std::nullopt;
      sum = sum + *energy;
    }
    return sum;
  };
}

StateEnergy energy_of_expression(const Model& model, ExpressionId expression) {
  return [&model, expression](const State& state) {
    return oracle_expression_value(model, expression, state);
  };
}

/// True if the parts of V and W that depend on the parameters of gravity and of the mass `weight`
/// are equal up to a constant.
bool is_counted_twice(const InspectedModel& subject, const std::vector<PlacedMass>& weights,
                      const PlacedMass& weight) {
  const Model& model = subject.model;
  const auto& gravity = *model.gravity;
  std::vector<ParameterSet> sets;
  for (const ParameterSet& set : {parameters_in(model, {weight.mass}),
                                  parameters_in(model, {gravity.begin(), gravity.end()})}) {
    if (!set.empty()) sets.push_back(set);
  }
  const StateEnergy written = energy_of_expression(model, *model.energies.V);
  const StateEnergy given =
      sum_of_energies(weights, [&model](const PlacedMass& each, const State& state) {
        return weight_energy(model, each, state);
      });
  return are_equal_and_nonzero(dependent_differences(subject, written, sets),
                               dependent_differences(subject, given, sets));
}

/// 1/2 m v^2 of a point: 0 if the point has no mass, none if the mass or v has no value.
std::optional<cl_R> kinetic_energy_of(const Model& model, const Point& point, const State& state) {
  if (!point.mass) return cl_R(0);
  const auto mass = oracle_expression_value(model, *point.mass, state);
  if (!mass) return std::nullopt;
  cl_R square = 0;
  for (std::size_t c = 0; c < point.dimension; ++c) {
    const auto rate = oracle_expression_rate(model, point.position[c], state);
    if (!rate) return std::nullopt;
    square = square + *rate * *rate;
  }
  return *mass * square / 2;
}

/// True if the parts of T and K that depend on the parameters of `point.mass` are equal up to a
/// constant.
bool is_counted_twice(const InspectedModel& subject, const Point& point) {
  const Model& model = subject.model;
  const ParameterSet mass = parameters_in(model, {*point.mass});
  if (mass.empty()) return false;
  const StateEnergy written = energy_of_expression(model, *model.energies.T);
  const StateEnergy given =
      sum_of_energies(model.points, [&model](const Point& each, const State& state) {
        return kinetic_energy_of(model, each, state);
      });
  return are_equal_and_nonzero(dependent_differences(subject, written, {mass}),
                               dependent_differences(subject, given, {mass}));
}

}  // namespace

Diagnostics inspect_potential(const InspectedModel& subject) {
  const Model& model = subject.model;
  Diagnostics diagnostics = upward_gravity_errors(subject);
  if (!model.energies.V || model.velocities.size() > most_coordinates_sampled) {
    return diagnostics;
  }
  for (const std::uint32_t index : points_in(model, *model.energies.V)) {
    const Point& point = model.points[index];
    const auto up = has_mass(model, index) ? up_direction(subject, point) : std::nullopt;
    if (!up || !has_falling_potential(subject, index, *up)) continue;
    diagnostics.push_back({Code::E512, model.expressions[*model.energies.V].span,
                           fmt::format("V falls as `{}` rises", point.name),
                           "a weight is `m*g*height`: sign mistake?"});
  }
  return diagnostics;
}

Diagnostics inspect_kinetic_energies(const InspectedModel& subject) {
  const Model& model = subject.model;
  if (!model.energies.T || model.velocities.size() > most_coordinates_sampled) return {};
  for (const Point& point : model.points) {
    if (!point.mass || !is_counted_twice(subject, point)) continue;
    return {{Code::E527, model.expressions[*model.energies.T].span,
             fmt::format("T contains the kinetic energy of `{}`, which its mass adds already",
                         point.name),
             "remove one of the two"}};
  }
  return {};
}

Diagnostics inspect_weights(const InspectedModel& subject) {
  const Model& model = subject.model;
  if (!model.gravity || !model.energies.V) return {};
  if (model.velocities.size() > most_coordinates_sampled) return {};
  const std::vector<PlacedMass> weights = placed_masses(model);
  for (const PlacedMass& weight : weights) {
    if (!is_counted_twice(subject, weights, weight)) continue;
    return {
        {Code::E526, model.expressions[*model.energies.V].span,
         fmt::format("V contains the weight of `{}`, which [gravity] adds already", weight.name),
         "remove one of the two"}};
  }
  return {};
}

}  // namespace elgen
