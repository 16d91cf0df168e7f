// formulate: Model -> Lagrangian. Creates symbols, then definitions of all named entries, then
// energies and forces as terms over them.
//
//     T = [energy] T + sum 1/2 m |dp/dt|^2 + sum 1/2 w.I w + sum 1/2 J v^2
//     V = [energy] V - sum m gravity.p
//
// Bodies, points and forces in frames become part of the tree of frames. An expansion or [routh]
// needs the energies as sums; in both cases everything is written in world coordinates.
#include <fmt/format.h>

#include <utility>

#include "derive/formulate/expressions.hpp"
#include "elgen/lagrangian.hpp"
#include "model/elimination.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

const ex one_half = GiNaC::numeric(1, 2);

/// A real symbol; for a positive parameter a positive symbol x, so that sqrt(x^2) becomes x.
ex make_symbol(const Parameter& parameter, const std::string& name) {
  if (parameter.assumption == Assumption::positive) return GiNaC::possymbol(name);
  return GiNaC::realsymbol(name);
}

template <class Entry>
ex make_symbol(const Entry& /*entry*/, const std::string& name) {
  return GiNaC::realsymbol(name);
}

/// Fills `q_rates` and `rotations`; the rates of quaternion components become definitions.
void add_coordinate_rates(const Model& model, Lagrangian& lagrangian) {
  Symbols& symbols = lagrangian.symbols;
  for (const Coordinate& coordinate : model.coordinates) {
    symbols.q_rates.push_back(symbols.v[coordinate.velocity]);
  }
  for (const Rotation& rotation : model.rotations) {
    const RotationPlace place{rotation.first_coordinate, rotation.first_velocity};
    symbols.rotations.push_back(place);
    const auto n = rate_matrix(symbols, place);
    for (std::uint32_t i = 0; i < quaternion_size; ++i) {
      const std::uint32_t component = place.first_coordinate + i;
      GiNaC::exvector terms;
      for (std::uint32_t k = 0; k < axis_count; ++k) {
        terms.push_back(n[i][k] * symbols.v[place.first_velocity + k]);
      }
      symbols.q_rates[component] = define(
          lagrangian.definitions, GiNaC::add(terms),
          {model.coordinates[component].identifier + "_dot", {EntityKind::coordinate, component}});
    }
  }
}

void add_symbols(const Model& model, Lagrangian& lagrangian) {
  LeafValues<ex>& symbols = lagrangian.symbols;
  symbols = make_leaf_values<ex>(
      model,
      [](Opcode kind, const auto& entry) {
        return make_symbol(entry,
                           fmt::format(fmt::runtime(leaf_row(kind).identifier), entry.identifier));
      },
      [](Opcode kind) { return GiNaC::realsymbol(std::string(leaf_row(kind).symbol)); });
  for_each_leaf([&](Opcode kind, std::uint32_t,
                    const ex& symbol) { add_leaf(lagrangian.definitions, symbol, kind); },
                symbols);
  add_coordinate_rates(model, lagrangian);
}

/// True if the entry belongs to the tree of frames, not to the sums in world coordinates.
template <class Placed>
bool is_in_tree(const Model& model, const Placed& placed) {
  return placed.local && !needs_energy_sums(model);
}

/// Adds 1/2 w.I w to T. I = [xx xy xz; xy yy yz; xz yz zz] is expressed in the same axes as w.
void add_rotational_energy(const Body& body, Entity origin, ExpressionTranslator& translation,
                           Lagrangian& lagrangian) {
  if (body.inertia.empty() || body.spin.empty()) return;
  constexpr std::array<const char*, 3> axes{"_x", "_y", "_z"};
  std::vector<ex> inertia;
  for (const ExpressionId id : body.inertia)
    inertia.push_back(translation.define_value(id, body.identifier + "_inertia", origin));
  std::vector<ex> spin;
  for (const ExpressionId id : body.spin) {
    const std::string axis = body.spin.size() == 1 ? "" : axes[spin.size()];
    spin.push_back(translation.define_value(id, body.identifier + "_spin" + axis, origin));
  }
  const auto add = [&](const ex& term) {
    lagrangian.kinetic.push_back({term, EnergyOrigin::spin});
  };
  for (std::size_t i = 0; i < spin.size(); ++i) add(one_half * inertia[i] * spin[i] * spin[i]);
  if (inertia.size() == 6) {
    add(inertia[3] * spin[0] * spin[1]);
    add(inertia[4] * spin[0] * spin[2]);
    add(inertia[5] * spin[1] * spin[2]);
  }
  lagrangian.rotating_bodies.push_back({std::move(spin), std::move(inertia), origin});
}

/// Collects the forces outside the tree of frames: forces on velocities, on points, and torques on
/// frames.
class ForceCollector {
 public:
  ForceCollector(const Model& model, ExpressionTranslator& translation, Lagrangian& lagrangian)
      : model_(model),
        translation_(translation),
        lagrangian_(lagrangian),
        terms_by_velocity_(model.velocities.size()) {}

  void add_all_forces() {
    for (std::size_t i = 0; i < model_.inputs.size(); ++i) {
      if (model_.inputs[i].velocity)
        terms_by_velocity_[*model_.inputs[i].velocity].push_back(lagrangian_.symbols.u[i]);
    }
    for (const Force& force : model_.forces) {
      if (force.velocity) {
        terms_by_velocity_[*force.velocity].push_back(translation_.value(force.value.front()));
      } else if (force.point) {
        add_point_force(force);
      } else if (needs_energy_sums(model_)) {
        add_torque(force);
      }
    }
    for (const GiNaC::exvector& terms : terms_by_velocity_)
      lagrangian_.forces.emplace_back(GiNaC::add(terms));
  }

 private:
  void add_point_force(const Force& force) {
    const auto at = [&](std::uint32_t point) {
      return translation_.define_vector(model_.points[point].position,
                                        model_.points[point].identifier,
                                        {EntityKind::point, point});
    };
    const bool acts_in_world = !is_in_tree(model_, model_.points[*force.point]);
    const bool reacts_in_world =
        force.reaction_point && !is_in_tree(model_, model_.points[*force.reaction_point]);
    if (!acts_in_world && !reacts_in_world) return;
    const std::array<ex, 3> value{translation_.value(force.value[0]),
                                  translation_.value(force.value[1]),
                                  translation_.value(force.value[2])};
    if (acts_in_world) lagrangian_.point_forces.push_back({at(*force.point), value});
    if (!reacts_in_world) return;
    lagrangian_.point_forces.push_back(
        {at(*force.reaction_point), {-value[0], -value[1], -value[2]}});
  }

  /// Adds torque.dw/dv_i to the force on each v_i; the angular velocity w is affine in v.
  void add_torque(const Force& force) {
    std::vector<WeightedTerm> work;
    const auto add = [&](std::uint32_t frame, const std::vector<ExpressionId>& torque, int sign) {
      for (std::size_t i = 0; i < torque.size(); ++i) {
        const ex spin = translation_.value(model_.frames[frame].spin[i]);
        work.push_back({spin, sign * translation_.value(torque[i])});
      }
    };
    add(*force.frame, force.value, 1);
    if (force.reaction_frame) add(*force.reaction_frame, force.reaction, -1);
    const std::vector<ex> forces = gradient(lagrangian_.definitions, work, lagrangian_.symbols.v);
    for (std::size_t i = 0; i < forces.size(); ++i) terms_by_velocity_[i].push_back(forces[i]);
  }

  const Model& model_;
  ExpressionTranslator& translation_;
  Lagrangian& lagrangian_;
  std::vector<GiNaC::exvector> terms_by_velocity_;  ///< terms of the force on each velocity
};

/// Adds 1/2 J v^2 of each armature.
void add_armatures(const Model& model, ExpressionTranslator& translation, Lagrangian& lagrangian) {
  lagrangian.armatures.resize(lagrangian.symbols.v.size(), 0);
  auto& kinetic = lagrangian.lagrangian.empty() ? lagrangian.kinetic : lagrangian.lagrangian;
  for (const Coordinate& coordinate : model.coordinates) {
    if (!coordinate.armature) continue;
    const ex rate = lagrangian.symbols.v[coordinate.velocity];
    const ex armature = translation.value(*coordinate.armature);
    kinetic.push_back({one_half * armature * rate * rate, EnergyOrigin::armature});
    lagrangian.armatures[coordinate.velocity] = armature;
  }
}

/// Builds the parts of a Lagrangian one after another, and stops at the first part with errors.
class Formulation {
 public:
  explicit Formulation(const Model& model) : model_(model), translation_(model, lagrangian_) {
    lagrangian_.leaves = leaf_names(model);
    lagrangian_.is_quadratic = model.is_quadratic;
    add_symbols(model, lagrangian_);
  }

  Result<UnreducedLagrangian> build() && {
    translation_.define_named_entries();
    if (!translation_.errors().empty()) return translation_.errors().front();
    using F = Formulation;
    for (void (F::*const add)() :
         {&F::add_gravity, &F::add_points, &F::add_bodies, &F::add_energies, &F::add_forces,
          &F::add_constraints, &F::add_outputs, &F::add_held_variables, &F::add_expansion,
          &F::add_tree}) {
      (this->*add)();
      if (!translation_.errors().empty()) return translation_.errors();
    }
    return std::move(lagrangian_);
  }

 private:
  void add_forces() { ForceCollector(model_, translation_, lagrangian_).add_all_forces(); }

  void add_tree() { add_frame_tree(model_, translation_, lagrangian_); }

  void add_gravity() {
    if (!model_.gravity) return;
    const auto& gravity = *model_.gravity;
    lagrangian_.gravity = {translation_.value(gravity[0]), translation_.value(gravity[1]),
                           translation_.value(gravity[2])};
  }

  void add_points() {
    for (std::uint32_t i = 0; i < model_.points.size(); ++i) {
      const Point& point = model_.points[i];
      if (!point.mass || is_in_tree(model_, point)) continue;
      const Entity origin{EntityKind::point, i};
      const ex mass = translation_.define_value(*point.mass, point.identifier + "_mass", origin);
      lagrangian_.masses.push_back(
          {mass, translation_.define_vector(point.position, point.identifier, origin), origin});
    }
  }

  void add_bodies() {
    for (std::uint32_t i = 0; i < model_.bodies.size(); ++i) {
      const Body& body = model_.bodies[i];
      if (is_in_tree(model_, body)) continue;
      const Entity origin{EntityKind::body, i};
      if (body.mass) {
        const ex mass = translation_.define_value(*body.mass, body.identifier + "_mass", origin);
        lagrangian_.masses.push_back(
            {mass, translation_.define_vector(body.com, body.identifier, origin), origin});
      }
      add_rotational_energy(body, origin, translation_, lagrangian_);
    }
  }

  /// Adds each operand of a sum as a separate term, so that terms stay small.
  void add_terms(std::optional<ExpressionId> energy, EnergyTerms& terms) {
    if (!energy) return;
    const Expression& expression = model_.expressions[*energy];
    if (expression.kind != ExpressionKind::add) {
      terms.push_back({translation_.value(*energy)});
      return;
    }
    for (const ExpressionId operand : expression.operands)
      terms.push_back({translation_.value(operand)});
  }

  void add_energies() {
    add_terms(model_.energies.T, lagrangian_.kinetic);
    add_terms(model_.energies.V, lagrangian_.potential);
    add_terms(model_.energies.D, lagrangian_.dissipation);
    add_terms(model_.energies.L, lagrangian_.lagrangian);
    add_armatures(model_, translation_, lagrangian_);
  }

  void add_expansion() {
    if (!model_.approximation) return;
    const Approximation& approximation = *model_.approximation;
    const Symbols& symbols = lagrangian_.symbols;
    Expansion expansion{approximation.order, {}};
    for (std::size_t i = 0; i < symbols.q.size(); ++i) {
      if (!approximation.small[i]) continue;
      expansion.small.push_back({symbols.q[i], translation_.value(*approximation.coordinates[i])});
      expansion.small.push_back({symbols.v[model_.coordinates[i].velocity], 0});
    }
    for (std::size_t i = 0; approximation.has_small_inputs && i < symbols.u.size(); ++i) {
      const std::optional<ExpressionId>& value = approximation.inputs[i];
      expansion.small.push_back({symbols.u[i], value ? translation_.value(*value) : ex(0)});
    }
    lagrangian_.expansion = std::move(expansion);
  }

  void add_constraints() {
    for (std::uint32_t i = 0; i < model_.constraints.size(); ++i) {
      const Constraint& constraint = model_.constraints[i];
      const Entity origin{EntityKind::constraint, i};
      const auto gain = [&](const std::optional<ExpressionId>& value) {
        return value ? translation_.value(*value) : ex(0);
      };
      const ex omega = gain(constraint.omega);
      const ex stiffness = constraint.is_position ? omega * omega : ex(0);
      const ex value = translation_.define_value(constraint.value, constraint.identifier, origin);
      lagrangian_.constraints.push_back(
          {value, constraint.is_position, 2 * gain(constraint.zeta) * omega, stiffness, origin});
    }
  }

  void add_outputs() {
    for (const UserOutput& output : model_.outputs) {
      NamedOutput named{output.name, {}, {}, output.solves_motion};
      for (const ExpressionId id : output.values) named.values.push_back(translation_.value(id));
      lagrangian_.outputs.push_back(std::move(named));
    }
  }

  void add_held_variables() {
    for (const LockedCoordinate& lock : model_.reduction.locks) {
      HeldCoordinateMotion locked{lock, {}};
      for (std::uint32_t i = 0; i < lock.values.size(); ++i) {
        const Coordinate& coordinate = model_.coordinates[lock.coordinate + i];
        const Entity origin{EntityKind::coordinate, lock.coordinate + i};
        locked.values.push_back(
            translation_.define_value(lock.values[i], coordinate.identifier, origin));
      }
      lagrangian_.locked.push_back(std::move(locked));
    }
    const RemainingIndices inputs = remaining_variables(model_).inputs;
    for (std::uint32_t i = 0; i < model_.inputs.size(); ++i) {
      if (!inputs[i]) lagrangian_.held_inputs.push_back(i);
    }
    for (const CyclicCoordinate& cyclic : model_.reduction.cyclic) {
      lagrangian_.cyclic.push_back({cyclic, {lagrangian_.symbols.parameters[cyclic.parameter]}});
    }
  }

  const Model& model_;
  UnreducedLagrangian lagrangian_;
  ExpressionTranslator translation_;
};

}  // namespace

std::vector<ex> values_of(const EnergyTerms& terms) {
  std::vector<ex> values;
  for (const EnergyTerm& term : terms) values.push_back(term.value);
  return values;
}

Result<UnreducedLagrangian> formulate(const Model& model) {
  Result<UnreducedLagrangian> lagrangian = Formulation(unreduced_model(model)).build();
  // Passes `model`, not unreduced_model(model), because held velocities are not eliminated.
  if (lagrangian) lagrangian->eliminates_last_first = eliminates_backward(model);
  if (lagrangian) lagrangian->inertial = inertial_parameters(model);
  return lagrangian;
}

}  // namespace elgen
