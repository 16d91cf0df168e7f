// Computes forces for given inertial parameters by terms of T and V, added to a copy of the model.
#include "oracle/regressor.hpp"

#include <array>

#include "elgen/inertial_parameters.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_R;
using Values = std::vector<cl_R>;

/// The number of motions at which a force is evaluated; fewer are enough. All choices of the
/// parameters use the same motions.
constexpr std::size_t motions_of_force = 16;

/// A copy of `model` at one of several choices of the inertial parameters. In the copy, terms of T
/// and V replace the masses, the inertias and the armatures.
class ParametrisedModel {
 public:
  ParametrisedModel(const Model& model, const std::vector<Values>& choices)
      : source_(model), model_(model) {
    for (Body& body : model_.bodies) {
      body.mass.reset();
      body.inertia.clear();
    }
    for (Point& point : model_.points) point.mass.reset();
    for (Coordinate& coordinate : model_.coordinates) coordinate.armature.reset();
    for (const Values& values : choices) energies_.push_back(energies_of(values));
  }

  [[nodiscard]] const Model& model() const { return model_; }

  /// Sets the energies of model() to those of a choice. Evaluations of the model stay valid,
  /// because no expression changes.
  void select(std::size_t choice) { model_.energies = energies_[choice]; }

 private:
  Energies energies_of(const Values& values) {
    const std::vector<InertialParameter> parameters = inertial_parameters(source_);
    kinetic_.clear();
    potential_.clear();
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (!cln::zerop(values[k]))
        add_parameter(parameters[k], append_number(cln::rational(values[k])));
    }
    Energies energies = source_.energies;
    add_terms(energies.T, kinetic_);
    add_terms(energies.V, potential_);
    return energies;
  }

  void add_parameter(const InertialParameter& parameter, ExpressionId value) {
    value_ = value;
    switch (parameter.owner) {
      case InertialOwner::body:
        return add_body(source_.bodies[parameter.index], parameter.component);
      case InertialOwner::point:
        return add_mass(source_.points[parameter.index].position);
      case InertialOwner::coordinate:
        return add_half_square(append_velocity(source_.coordinates[parameter.index].velocity));
      case InertialOwner::parameter:
        break;
    }
  }

  ExpressionId append_expression(Expression node) {
    model_.expressions.push_back(std::move(node));
    return static_cast<ExpressionId>(model_.expressions.size() - 1);
  }
  ExpressionId append_number(const cln::cl_RA& value) {
    return append_expression({.number = value});
  }
  ExpressionId append_product(std::vector<ExpressionId> factors) {
    return append_expression({.kind = ExpressionKind::multiply, .operands = std::move(factors)});
  }
  void add_terms(std::optional<ExpressionId>& energy, std::vector<ExpressionId> terms) {
    if (energy) terms.push_back(*energy);
    if (!terms.empty())
      energy = append_expression({.kind = ExpressionKind::add, .operands = std::move(terms)});
  }
  ExpressionId append_rate(ExpressionId value) {
    return append_expression({.kind = ExpressionKind::time_derivative, .operands = {value}});
  }
  ExpressionId append_velocity(std::uint32_t velocity) {
    return append_expression(
        {.kind = ExpressionKind::leaf, .leaf = Opcode::velocity, .index = velocity});
  }
  void add_half_square(ExpressionId rate) {
    kinetic_.push_back(append_product({value_, append_number(cln::cl_RA(1) / 2), rate, rate}));
  }

  void add_weight(const Vector3& place) {
    if (!source_.gravity) return;
    for (std::size_t c = 0; c < 3; ++c) {
      potential_.push_back(
          append_product({value_, append_number(-1), (*source_.gravity)[c], place[c]}));
    }
  }

  void add_mass(const Vector3& place) {
    for (const ExpressionId component : place) add_half_square(append_rate(component));
    add_weight(place);
  }

  void add_moment(const Frame& frame, std::uint32_t axis) {
    Vector3 direction{};
    for (std::uint32_t c = 0; c < 3; ++c) {
      direction[c] = frame.rotation[3 * c + axis];
      kinetic_.push_back(
          append_product({value_, append_rate(frame.origin[c]), append_rate(direction[c])}));
    }
    add_weight(direction);
  }

  void add_inertia(const std::vector<ExpressionId>& spin, std::uint32_t component) {
    static constexpr std::array<std::array<std::size_t, 2>, 3> products{{{0, 1}, {0, 2}, {1, 2}}};
    if (spin.size() == 1) {
      add_half_square(spin.front());
    } else if (component < 3) {
      add_half_square(spin[component]);
    } else {
      const auto& [i, j] = products[component - 3];
      kinetic_.push_back(append_product({value_, spin[i], spin[j]}));
    }
  }

  void add_body(const Body& body, std::uint32_t component) {
    if (!body.local) {
      if (component == 0) return add_mass(body.com);
      return add_inertia(body.spin, component - first_inertia_component);
    }
    const Frame& frame = source_.frames[body.local->com.frame];
    if (component == 0) return add_mass(frame.origin);
    if (component < first_inertia_component) {
      return add_moment(frame, component - first_moment_component);
    }
    add_inertia({frame.spin.begin(), frame.spin.end()}, component - first_inertia_component);
  }

  const Model& source_;
  Model model_;
  std::vector<Energies> energies_ = {};  ///< of each choice
  ExpressionId value_ = 0;               ///< value of the parameter whose terms are being added
  std::vector<ExpressionId> kinetic_ = {};
  std::vector<ExpressionId> potential_ = {};
};

/// The values of Model::affine_parameters, which are the last inertial parameters.
Values affine_values(const Model& model, const Values& choice) {
  return {choice.end() - static_cast<std::ptrdiff_t>(model.affine_parameters.size()), choice.end()};
}

/// w.(M a + C(q, v) r + drift(r) + g + dD/dv(r) - Q(v)), r the reference velocity
cl_R force_by_reference(Mechanics& at, Mechanics& at_reference, const Direction& w) {
  return at.mass_product(w, at.state().a) + coriolis_matrix_product(at, w, at_reference.state().v) +
         drift(at_reference, w) + at.gravity(w) + at_reference.dissipation_force(w) -
         at.applied_force(w);
}

/// The parameter `component` of a body in a frame; moments are about the origin of the frame.
cl_R parameter_of_framed_body(Evaluation& at, const Body& body, std::uint32_t component) {
  const auto value = [&at](ExpressionId id) { return at.value(id).real(); };
  const LocalBody& local = *body.local;
  const cl_R mass = body.mass ? value(*body.mass) : cl_R(0);
  if (component == 0) return mass;
  std::array<cl_R, 3> c{0, 0, 0};
  for (std::size_t i = 0; body.mass && i < 3; ++i) c[i] = value(local.com.position[i]);
  if (component < first_inertia_component) return mass * c[component - first_moment_component];
  const std::uint32_t entry = component - first_inertia_component;
  const bool is_planar = local.inertia.size() == 1;
  const bool has_entry = is_planar ? entry == 2 : !local.inertia.empty();
  const cl_R own = has_entry ? value(local.inertia[is_planar ? 0 : entry]) : cl_R(0);
  if (local.is_about_origin) return own;
  const cl_R square = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
  const std::array<cl_R, 6> shift{square - c[0] * c[0], square - c[1] * c[1], square - c[2] * c[2],
                                  -c[0] * c[1],         -c[0] * c[2],         -c[1] * c[2]};
  return own + mass * shift[entry];
}

cl_R parameter_of_body(Evaluation& at, const Body& body, const InertialParameter& parameter) {
  if (parameter.is_mass()) return at.value(*body.mass).real();
  const std::uint32_t entry = parameter.component - first_inertia_component;
  return at.value(body.inertia[body.inertia.size() == 1 ? 0 : entry]).real();
}

}  // namespace

std::vector<Values> forces_of_parameters(const Model& model, const State& state,
                                         const std::vector<Values>& choices,
                                         const std::vector<Direction>& directions,
                                         bool uses_reference) {
  ParametrisedModel given(model, choices);
  std::vector<Values> forces(choices.size());
  for (std::size_t first = 0, end = 0; first < choices.size(); first = end) {
    const Values affine = affine_values(model, choices[first]);
    while (end < choices.size() && affine_values(model, choices[end]) == affine) ++end;
    State own = state;
    for (std::size_t k = 0; k < affine.size(); ++k) {
      own.parameters[model.affine_parameters[k]] = affine[k];
    }
    Mechanics at(given.model(), own, motions_of_force);
    own.v = own.reference;
    Mechanics at_reference(given.model(), own, motions_of_force);
    for (std::size_t k = 0; k < directions.size() * (end - first); ++k) {
      const Direction& w = directions[k / (end - first)];
      const std::size_t choice = first + k % (end - first);
      given.select(choice);
      forces[choice].push_back(uses_reference ? force_by_reference(at, at_reference, w)
                                              : inverse_dynamics(at, w));
    }
  }
  return forces;
}

Values regressor_parameters(const Model& model, const State& state) {
  const Motion motion = make_motion(state);
  Evaluation at(model, motion);
  Values values;
  for (const InertialParameter& parameter : inertial_parameters(model)) {
    switch (parameter.owner) {
      case InertialOwner::parameter:
        values.push_back(state.parameters[parameter.index]);
        break;
      case InertialOwner::coordinate:
        values.push_back(at.value(*model.coordinates[parameter.index].armature).real());
        break;
      case InertialOwner::point:
        values.push_back(at.value(*model.points[parameter.index].mass).real());
        break;
      case InertialOwner::body: {
        const Body& body = model.bodies[parameter.index];
        values.push_back(body.local ? parameter_of_framed_body(at, body, parameter.component)
                                    : parameter_of_body(at, body, parameter));
        break;
      }
    }
  }
  return values;
}

}  // namespace elgen::oracle
