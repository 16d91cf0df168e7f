// derive: Lagrangian -> EquationsOfMotion. One row per output says which function derives it; only
// what the scene asks for is derived.
#include <fmt/format.h>

#include "derive/derivation.hpp"
#include "derive/derivatives.hpp"
#include "derive/energies.hpp"
#include "derive/forces.hpp"
#include "derive/forward_dynamics.hpp"
#include "derive/matrices.hpp"
#include "derive/node_limit.hpp"
#include "derive/reaction.hpp"
#include "derive/turning.hpp"
#include "elgen/equations_of_motion.hpp"
#include "formulate/print.hpp"
#include "inspect/singular_mass.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

std::vector<FieldEquations> plain(const OutputRequest& request, Vector entries) {
  return {{"", request.rows, request.columns, std::move(entries)}};
}

std::vector<FieldEquations> accelerations(Derivation& derivation) {
  ForwardDynamics solved = forward_dynamics(derivation);
  const auto n = static_cast<std::uint32_t>(derivation.size());
  return {{"acceleration", n, 1, std::move(solved.acceleration)},
          {"relative_pivots", n, 1, std::move(solved.relative_pivots)},
          {"diagonal", n, 1, std::move(solved.diagonal)}};
}

std::vector<FieldEquations> inverse_derivatives(Derivation& derivation) {
  InverseDerivatives derived = inverse_dynamics_derivatives(derivation);
  const auto n = static_cast<std::uint32_t>(derivation.size());
  return {{"by_position", n, n, std::move(derived.by_position)},
          {"by_velocity", n, n, std::move(derived.by_velocity)}};
}

std::vector<FieldEquations> forward_derivatives(Derivation& derivation) {
  ForwardDerivatives derived = forward_dynamics_derivatives(derivation);
  const auto n = static_cast<std::uint32_t>(derivation.size());
  const auto inputs = static_cast<std::uint32_t>(derivation.symbols.u.size());
  std::vector<FieldEquations> result{{"by_position", n, n, std::move(derived.by_position)},
                                     {"by_velocity", n, n, std::move(derived.by_velocity)}};
  if (inputs > 0) result.push_back({"by_input", n, inputs, std::move(derived.by_input)});
  return result;
}

std::vector<FieldEquations> state_matrices(Derivation& derivation) {
  Linearization linear = linearization(derivation);
  const auto n = static_cast<std::uint32_t>(2 * derivation.size());
  const auto inputs = static_cast<std::uint32_t>(derivation.symbols.u.size());
  std::vector<FieldEquations> result{{"A", n, n, std::move(linear.a)}};
  if (inputs > 0) result.push_back({"B", n, inputs, std::move(linear.b)});
  return result;
}

Vector user_value(Derivation& derivation, const OutputRequest& request) {
  const NamedOutput& output = derivation.lagrangian.outputs[request.user];
  if (request.kind == OutputKind::user_value) return output.values;
  const bool is_jacobian = request.kind == OutputKind::user_jacobian;
  if (output.twist) {
    return is_jacobian ? twist_jacobian(derivation, *output.twist)
                       : twist_bias(derivation, *output.twist);
  }
  return is_jacobian ? jacobian(derivation, output.values) : second_rate(derivation, output.values);
}

std::vector<FieldEquations> fields(Derivation& d, const OutputRequest& request) {
  switch (request.kind) {
    case OutputKind::mass_matrix:
      return plain(request, mass_matrix(d));
    case OutputKind::coriolis_matrix:
      return plain(request, coriolis_matrix(d));
    case OutputKind::velocity_force:
      return plain(request, velocity_force(d));
    case OutputKind::gravity:
      return plain(request, gravity(d));
    case OutputKind::potential_energy:
      return plain(request, {potential_energy(d)});
    case OutputKind::drift:
      return plain(request, drift(d));
    case OutputKind::dissipation:
      return plain(request, dissipation(d));
    case OutputKind::applied_force:
      return plain(request, applied_force(d, InputForces::absent));
    case OutputKind::bias:
      return plain(request, bias(d, InputForces::absent));
    case OutputKind::momentum:
      return plain(request, momentum(d));
    case OutputKind::kinetic_energy:
      return plain(request, {kinetic_energy(d)});
    case OutputKind::total_energy:
      return plain(request, {total_energy(d)});
    case OutputKind::energy_function:
      return plain(request, {energy_function(d)});
    case OutputKind::input_matrix:
      return plain(request, input_matrix(d));
    case OutputKind::inverse_dynamics:
      return plain(request, inverse_dynamics(d));
    case OutputKind::reaction:
      return plain(request, reaction(d));
    case OutputKind::forward_dynamics:
      return accelerations(d);
    case OutputKind::linearization:
      return state_matrices(d);
    case OutputKind::inverse_dynamics_derivatives:
      return inverse_derivatives(d);
    case OutputKind::forward_dynamics_derivatives:
      return forward_derivatives(d);
    case OutputKind::coordinate_rates:
      return plain(request, coordinate_rates(d));
    case OutputKind::normalized:
      return plain(request, normalized(d));
    case OutputKind::user_value:
    case OutputKind::user_jacobian:
    case OutputKind::user_bias:
      return plain(request, user_value(d, request));
    case OutputKind::dynamics:
      break;
  }
  return {};
}

/// Entries as symbols, so that every output, and what shares them, refers to definitions.
void define_entries(Derivation& derivation, std::vector<FieldEquations>& fields) {
  for (FieldEquations& field : fields) {
    for (ex& entry : field.entries) entry = define(derivation.definitions, entry);
  }
}

Diagnostic singular_mass(const OutputRequest& request, const ZeroPivot& pivot,
                         const LeafNames& names) {
  const std::string& velocity = names.v[pivot.velocity];
  return pivot.is_diagonal ? no_kinetic_energy(request, velocity)
                           : singular_mass_matrix(request, velocity);
}

}  // namespace

Result<EquationsOfMotion> derive(const Lagrangian& lagrangian,
                                 const std::vector<OutputRequest>& outputs, const Limits& limits) {
  Derivation derivation(lagrangian);
  EquationsOfMotion equations;
  for (const OutputRequest& request : outputs) {
    if (request.kind == OutputKind::dynamics) continue;  // made of the others
    try {
      OutputEquations derived{request, fields(derivation, request)};
      define_entries(derivation, derived.fields);
      equations.outputs.push_back(std::move(derived));
    } catch (const ZeroPivot& pivot) {
      return singular_mass(request, pivot, lagrangian.leaves);
    } catch (const GiNaC::pole_error&) {
      return Diagnostic{
          Code::E313, request.span,
          fmt::format("`{}` has no value: an energy divides by zero at zero rates", request.name)};
    }
    if (derivation.definitions.list.size() > limits.derived_nodes) {
      return too_many_nodes(request, limits.derived_nodes);
    }
  }
  equations.symbols = derivation.symbols;
  equations.leaves = lagrangian.leaves;
  equations.definitions = std::move(derivation.definitions);
  return equations;
}

std::string dump(const EquationsOfMotion& equations) {
  const ExpressionPrinter print(equations.definitions);
  std::string text = dump(equations.definitions);
  for (const OutputEquations& output : equations.outputs) {
    for (const FieldEquations& field : output.fields) {
      const std::string dot = field.name.empty() ? "" : ".";
      text += fmt::format("{}{}{} ({} x {}) =", output.request.name, dot, field.name, field.rows,
                          field.columns);
      for (const ex& entry : field.entries) text += " " + print(entry);
      text += '\n';
    }
  }
  return text;
}

}  // namespace elgen
