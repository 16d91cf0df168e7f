// Mechanics: degrees of the energies in the rates, forces affine in the inputs, and kinetic energy
// for every velocity.
#include <algorithm>

#include "base/reason.hpp"
#include "check/judge/judge.hpp"
#include "elgen/references.hpp"

namespace elgen {
namespace {

bool has_energy(const Point& point) { return point.mass.has_value(); }
bool has_energy(const Body& body) { return body.mass.has_value() || !body.inertia.empty(); }

bool has_masses(const Model& model) {
  const auto has_own = [](const auto& row) { return has_energy(row); };
  const auto has_armature = [](const Coordinate& q) { return q.armature.has_value(); };
  return std::ranges::any_of(model.points, has_own) || std::ranges::any_of(model.bodies, has_own) ||
         std::ranges::any_of(model.coordinates, has_armature);
}

using Expressions = std::vector<ExpressionId>;

/// True if a root belongs to the equations or outputs by itself. Frames, definitions, prescribed
/// functions and points without mass belong only if another root refers to them.
bool is_in_equations(const Model& model, const Root& root) {
  switch (root.entity.kind) {
    case EntityKind::point:
      return has_energy(model.points[root.entity.index]);
    case EntityKind::frame:
    case EntityKind::definition:
    case EntityKind::prescribed:
      return false;
    case EntityKind::body:
    case EntityKind::coordinate:
    case EntityKind::gravity:
    case EntityKind::energy:
    case EntityKind::force:
    case EntityKind::constraint:
    case EntityKind::output:
      return true;
  }
  return true;
}

/// All expressions in the equations and outputs, and the work_expressions() of all forces.
Expressions expressions_in_equations(const Model& model) {
  Expressions all =
      filter_roots(model, [&model](const Root& root) { return is_in_equations(model, root); });
  for (const Force& force : model.forces) {
    const Expressions moved = work_expressions(model, force);
    all.insert(all.end(), moved.begin(), moved.end());
  }
  return all;
}

/// True if T has a term below degree 2 in the rates, if a spin has a term below degree 1, if V
/// depends on rates, or if L is given.
bool energy_may_drift(const Model& model, const std::vector<ExpressionTraits>& traits) {
  const Energies& e = model.energies;
  const auto lowest = [&](ExpressionId id) { return traits[id].lowest_rate_degree; };
  const auto turns_at_rest = [&](const Body& body) {
    return std::ranges::any_of(body.spin, [&](ExpressionId id) { return lowest(id) < 1; });
  };
  return e.L || (e.T && lowest(*e.T) < 2) || (e.V && traits[*e.V].rate_degree > 0) ||
         std::ranges::any_of(model.bodies, turns_at_rest);
}

class MechanicsCheck {
 public:
  MechanicsCheck(Context& context, const std::vector<ExpressionTraits>& traits)
      : context_(context), model_(context.model), traits_(traits) {}

  void check_all() {
    check_degree(model_.energies.V, 1, Code::E503, "at most linear");
    check_degree(model_.energies.T, 2, Code::E504, "at most quadratic");
    for (const Body& body : model_.bodies) {
      for (const ExpressionId component : body.spin) {
        check_degree(component, 1, Code::E504, "at most linear");
      }
    }
    if (model_.energies.L) model_.is_quadratic = traits_[*model_.energies.L].rate_degree <= 2;
    for (const Force& force : model_.forces) {
      for (const ExpressionId value : force.value) {
        check_affine(value);
        check_inputs(value);
      }
    }
    check_lagrangian();
    model_.uses_time = std::ranges::any_of(expressions_in_equations(model_), [&](ExpressionId id) {
      return (traits_[id].ingredients & uses_time) != 0;
    });
    model_.may_drift = model_.uses_time || energy_may_drift(model_, traits_);
  }

 private:
  [[nodiscard]] const Span& span(ExpressionId id) const { return model_.expressions[id].span; }

  /// Reports `code` if an energy or a spin (T is quadratic in spins) exceeds the degree `most`.
  void check_degree(const std::optional<ExpressionId>& energy, std::uint8_t most, Code code,
                    const std::string& rule) {
    // check_ingredients() reports ingredients that an energy must not contain.
    constexpr unsigned misplaced = uses_kink | uses_input | uses_acceleration | uses_open_rate |
                                   uses_open_derivative | uses_momentum;
    if (!energy || (traits_[*energy].ingredients & misplaced) != 0 ||
        traits_[*energy].rate_degree <= most) {
      return;
    }
    const std::uint8_t degree = traits_[*energy].rate_degree;
    const std::string observed =
        degree < not_polynomial
            ? "is of degree " + std::to_string(degree) + " in the rates"
            : std::string("is of degree 3 or more in the rates, or no polynomial in them");
    context_.report.add(code, span(*energy),
                        in_backticks(span(*energy)) + " " + observed + ", not " + rule);
  }

  void check_affine(ExpressionId value) {
    const ExpressionTraits& traits = traits_[value];
    if (traits.input_degree > 1) {
      context_.report.add(Code::E509, span(value),
                          in_backticks(span(value)) + " is not linear in the inputs");
    } else if (traits.input_times_rate) {
      context_.report.add(Code::E509, span(value),
                          in_backticks(span(value)) + " multiplies an input by a rate");
    }
  }

  /// Reports E112 for an input with `on` in the value of a force: the input would act twice.
  void check_inputs(ExpressionId value) {
    if ((traits_[value].ingredients & uses_input) == 0) return;
    for (const ExpressionId id : reachable_expressions(model_, {value})) {
      const Expression& node = model_.expressions[id];
      if (!is_leaf(node, Opcode::input) || !model_.inputs[node.index].velocity) continue;
      const Input& input = model_.inputs[node.index];
      context_.report.add({Reason::input_acts_twice, node.span,
                           quote_text(input.name) + " acts on " +
                               quote_text(model_.velocities[*input.velocity].name) +
                               " by its `on`, but a force also contains it",
                           "without `on`, an input acts through the force that contains it",
                           input.span, "the input is declared here"});
    }
  }

  void check_lagrangian() {
    const Energies& energies = model_.energies;
    if (energies.L && (energies.T || energies.V || has_masses(model_))) {
      const std::string other = energies.T || energies.V ? "T or V" : "the mass of an entry";
      context_.report.add(Code::E515, context_.lagrangian_span, "`L` is given besides " + other);
    }
    if (!energies.L && !energies.T && !has_masses(model_)) {
      context_.report.add(Code::E514, context_.model_span,
                          quote_text(model_.name) + " has no kinetic energy",
                          "give a point or body a mass, or write `[energy] T`");
    } else if (context_.report.error_count() == 0) {
      check_motion();
    }
  }

  void check_motion() {
    const std::vector<bool> moving = velocities_with_energy(model_);
    for (std::size_t i = 0; i < moving.size(); ++i) {
      if (!moving[i]) {
        const Velocity& velocity = model_.velocities[i];
        context_.report.add(Code::E513, velocity.span,
                            "the rate of " + quote_text(velocity.name) +
                                " is in no energy, so nothing determines its motion",
                            model_.constraints.empty()
                                ? ""
                                : "give it a mass, even if a constraint holds it: M is inverted "
                                  "separately");
      }
    }
  }

  Context& context_;
  Model& model_;
  const std::vector<ExpressionTraits>& traits_;
};

/// All subexpressions of the keys `T` and `L` of the file, and of the spins of bodies.
Expressions expressions_in_energies(const Model& model) {
  return reachable_expressions(model, filter_roots(model, [](const Root& root) {
                                 const bool is_of_body = root.entity.kind == EntityKind::body;
                                 return root.role == RootRole::kinetic ||
                                        root.role == RootRole::lagrangian ||
                                        (is_of_body && root.role == RootRole::spin);
                               }));
}

/// All subexpressions of the time derivatives in `energies` and of the positions of masses.
Expressions differentiated_expressions(const Model& model, const Expressions& energies) {
  Expressions roots;
  std::ranges::copy_if(energies, std::back_inserter(roots), [&](ExpressionId id) {
    return model.expressions[id].kind == ExpressionKind::time_derivative;
  });
  for (const Point& point : model.points) {
    if (point.mass) roots.insert(roots.end(), point.position.begin(), point.position.end());
  }
  for (const Body& body : model.bodies) {
    if (body.mass) roots.insert(roots.end(), body.com.begin(), body.com.end());
  }
  return reachable_expressions(model, roots);
}

}  // namespace

void check_mechanics(Context& context, const std::vector<ExpressionTraits>& traits) {
  MechanicsCheck(context, traits).check_all();
}

std::vector<bool> velocities_with_energy(const Model& model) {
  std::vector<bool> moving(model.velocities.size(), false);
  const auto mark = [&](const Coordinate& coordinate) {
    std::fill_n(moving.begin() + coordinate.velocity, coordinate.rotation ? axis_count : 1, true);
  };
  const auto mark_rates = [&](const Expressions& all) {
    for (const ExpressionId id : all) {
      const Expression& node = model.expressions[id];
      // An acceleration is reported as E502, so it counts as a rate here.
      const bool is_rate = is_leaf(node, Opcode::velocity) || is_leaf(node, Opcode::acceleration);
      if (is_rate) moving[node.index] = true;
    }
  };
  const Expressions energies = expressions_in_energies(model);
  const Expressions moved = differentiated_expressions(model, energies);
  mark_rates(energies);
  mark_rates(moved);
  for (const ExpressionId id : moved) {
    const Expression& node = model.expressions[id];
    if (is_leaf(node, Opcode::coordinate)) mark(model.coordinates[node.index]);
  }
  for (const Coordinate& coordinate : model.coordinates) {
    if (coordinate.armature) mark(coordinate);
  }
  return moving;
}

namespace {

/// One flag per constraint: true if it contains no coordinate and no rate.
std::vector<bool> constraints_without_motion(const Model& model,
                                             const std::vector<ExpressionTraits>& traits) {
  std::vector<bool> marks;
  for (const Constraint& constraint : model.constraints) {
    const Ingredients made_of = traits[constraint.value].ingredients;
    marks.push_back((made_of & (uses_coordinate | uses_rate)) == 0);
  }
  return marks;
}

/// Reports E535 for a velocity equation that is not affine in the rates or contains no rate.
void check_constraint_rates(Context& context, const Constraint& constraint,
                            const ExpressionTraits& traits) {
  const Span& span = constraint.equation_span;
  if (!constraint.is_position && traits.rate_degree > 1) {
    context.report.add(Code::E535, span, in_backticks(span) + " is not affine in the rates");
  } else if (!constraint.is_position && traits.rate_degree == 0) {
    context.report.add(Code::E535, span, in_backticks(span) + " contains no rate",
                       "without `kind = \"velocity\"` it is a constraint on positions");
  }
}

/// Reports E539: the part `what` of the model or scene does not support constraints.
void report_constraint_conflict(Context& context, const Span& span, const std::string& what,
                                const std::string& instead) {
  context.report.add({Code::E539, span, what + " does not support constraints", instead,
                      context.model.constraints.front().span, "constrained here"});
}

void report_constraint_conflicts(Context& context) {
  const Model& model = context.model;
  if (!model.is_quadratic) {
    report_constraint_conflict(context, model.expressions[*model.energies.L].span,
                               "a Lagrangian that is not quadratic in the rates",
                               "choose coordinates that respect the constraint");
  }
  if (model.approximation) {
    report_constraint_conflict(context, model.approximation->span, "`[approximate]`",
                               "`linearization` linearises the constrained equations");
  }
  if (has_routhian(model)) {
    report_constraint_conflict(context, model.reduction.cyclic.front().span, "`[routh]`",
                               "choose coordinates that respect the constraint");
  }
  if (!reaction_row_velocities(model).empty()) {
    report_constraint_conflict(context, model.reduction.locks.front().span, "`reaction = true`",
                               "write the lock as a constraint: its multiplier is the reaction");
  }
  for (const Equilibrium& equilibrium : unreduced_model(model).equilibria) {
    report_constraint_conflict(context, equilibrium.span, "an `[[equilibrium]]`",
                               "choose coordinates that respect the constraint");
  }
}

}  // namespace

void check_constraints(Context& context) {
  const Model& model = context.model;
  if (model.constraints.empty()) return;
  const std::vector<ExpressionTraits> traits = find_traits(model);
  const std::vector<bool> resting = constraints_without_motion(model, traits);
  for (std::size_t i = 0; i < resting.size(); ++i) {
    const Constraint& constraint = model.constraints[i];
    if (resting[i]) {
      context.report.add(Code::E536, constraint.equation_span,
                         quote_text(constraint.name) + " contains nothing that moves",
                         equation_hint(model.constraints, resting, constraint));
    } else {
      check_constraint_rates(context, constraint, traits[constraint.value]);
    }
  }
  const std::size_t velocities = model.velocities.size();
  if (model.constraints.size() > velocities) {
    context.report.add(Code::E535, model.constraints[velocities].span,
                       count_text(model.constraints.size(), "equation") + ", but " +
                           std::to_string(velocities) +
                           (velocities == 1 ? " velocity" : " velocities"));
  }
  report_constraint_conflicts(context);
}

}  // namespace elgen
