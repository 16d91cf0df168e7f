// derive: Lagrangian -> EquationsOfMotion. Each output is derived by the function of the same name
// (outputs/outputs.hpp). Only requested outputs are derived.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "derive/lagrangian/symmetric_solve.hpp"
#include "derive/lagrangian/turning.hpp"
#include "derive/lower/from_ginac.hpp"
#include "derive/outputs/outputs.hpp"
#include "elgen/compose.hpp"
#include "elgen/equations_of_motion.hpp"
#include "inspect/singular_mass.hpp"
#include "model/elimination.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

using Fields = std::vector<FieldEquations>;

/// The entries of each field of an output: one list per field, in the order of the output table.
using FieldEntries = std::vector<RealVector>;

FieldEntries field_entries(RealVector x) { return {std::move(x)}; }
FieldEntries field_entries(const ex& x) { return {RealVector{x}}; }
FieldEntries field_entries(const InverseDerivatives& x) { return {x.by_position, x.by_velocity}; }
FieldEntries field_entries(const ForwardDerivatives& x) {
  return {x.by_position, x.by_velocity, x.by_input};
}
FieldEntries field_entries(const Linearization& x) { return {x.a, x.b}; }
FieldEntries field_entries(const ForwardDynamics& x) {
  return {x.acceleration, x.relative_pivots, x.multipliers, x.diagonal};
}
FieldEntries field_entries(const HamiltonEquations& x) {
  return {x.coordinate_rates, x.momentum_rates};
}
FieldEntries field_entries(const ConstraintResidual& x) { return {x.position, x.rate}; }
FieldEntries field_entries(const ProjectedState& x) { return {x.coordinates, x.rates}; }
FieldEntries field_entries(const ConstrainedInverseDynamics& x) {
  return {x.inputs, x.multipliers, x.unbalanced};
}

FieldEntries field_entries(const CompletedMotion& x) { return {x.rates, x.accelerations}; }
FieldEntries field_entries(const OperationalDynamics& x) {
  return {x.inertia, x.inverse_jacobian, x.bias, x.relative_pivots};
}

FieldEntries field_entries(const Regressor& x) { return {x.matrix, x.rest}; }

FieldEntries field_entries(const OutputDerivatives& x) {
  return {x.by_position, x.by_velocity, x.by_acceleration, x.by_input};
}

/// Keeps the accelerations and the multipliers; removes pivots and diagonal.
void remove_pivots(FieldEntries& solution) {
  solution[1].clear();
  solution.resize(solution[2].empty() ? 1 : 3);
}

FieldEquations make_field(std::string_view name, const RealVector& entries, std::size_t rows) {
  return {std::string(name), static_cast<std::uint32_t>(rows),
          static_cast<std::uint32_t>(entries.size() / rows), entries};
}

/// The fields of an output. If an output has several fields, its empty fields are omitted: for
/// example, the derivatives with respect to u if the model has no inputs. The field after the last
/// row of the output table is `diagonal`.
Fields make_output_fields(const Derivation& derivation, const OutputRequest& request,
                          FieldEntries all) {
  if (request.omits_pivots) remove_pivots(all);
  if (all.size() == 1) return {{"", request.rows, request.columns, all.front()}};
  const std::span<const FieldRow> rows = output_row(request.kind).fields;
  Fields result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const RealVector& entries = all[i];
    if (entries.empty()) continue;
    const FieldRow row = i < rows.size() ? rows[i] : FieldRow{.name = "diagonal"};
    // A matrix has as many rows as the first field, or one row per velocity.
    const bool is_like_first = row.rows == rows.front().rows;
    const std::size_t of_matrix = is_like_first ? request.rows : derivation.size();
    const std::size_t height = is_matrix_field(row) ? of_matrix : entries.size();
    result.push_back(make_field(row.name, entries, height));
  }
  return result;
}

RealVector user_value(Derivation& derivation, const NamedOutput& output) {
  return output.solves_motion ? values_along_motion(derivation, output.values) : output.values;
}

RealVector user_jacobian(Derivation& derivation, const NamedOutput& output) {
  return output.twist ? twist_jacobian(derivation, *output.twist)
                      : jacobian(derivation, output.values);
}

RealVector user_bias(Derivation& derivation, const NamedOutput& output) {
  return output.twist ? twist_bias(derivation, *output.twist)
                      : second_rate(derivation, output.values);
}

OutputDerivatives user_derivatives(Derivation& derivation, const NamedOutput& output) {
  OutputDerivatives result = output_derivatives(derivation, user_value(derivation, output));
  if (output.solves_motion) result.by_acceleration.clear();
  return result;
}

OperationalDynamics user_operational(Derivation& derivation, const NamedOutput& output) {
  const RealVector jacobian = user_jacobian(derivation, output);
  const RealVector bias = user_bias(derivation, output);
  return operational_dynamics(derivation, jacobian, bias);
}

/// Calls the function of an output; passes the request if the function takes it.
template <class Function>
auto call_output(const Function& function, Derivation& derivation, const OutputRequest& request) {
  if constexpr (std::is_invocable_v<Function, Derivation&, const OutputRequest&>) {
    return function(derivation, request);
  } else {
    return function(derivation);
  }
}

/// The function of each output, in the order of the table of outputs; null if the output is
/// composed of other outputs.
constexpr Fields (*output_functions[])(Derivation&, const OutputRequest&) = {
#define ELGEN_OUTPUT(name)                                                                      \
  [](Derivation& d, const OutputRequest& request) {                                             \
    const auto all = [](auto&... given) -> decltype(name(given...)) { return name(given...); }; \
    return make_output_fields(d, request, field_entries(call_output(all, d, request)));         \
  },
#define ELGEN_USER_OUTPUT(name)                                                            \
  [](Derivation& d, const OutputRequest& request) {                                        \
    return make_output_fields(d, request,                                                  \
                              field_entries(name(d, d.lagrangian.outputs[request.user]))); \
  },
#define ELGEN_SUMMARY(name) nullptr,
#define ELGEN_STEP(name) nullptr,
#include "elgen/outputs.def"
};

/// The parts from which elgen/compose.hpp computes the output; none if the output is derived
/// directly.
std::optional<OutputEquations> composed_output(Derivation& derivation,
                                               const OutputRequest& request) {
  const OutputRow& row = output_row(request.kind);
  if (!row.solves_mass_matrix || !row.differentiates) return std::nullopt;
  const std::optional<ForwardDynamicsTerms> parts = forward_dynamics_terms(derivation);
  if (!parts) return std::nullopt;
  const std::size_t n = derivation.size();
  const auto& [by_position, by_velocity, by_input] = parts->forces;
  Fields fields{make_field(mass_part, parts->mass, n), make_field(force_part, parts->force, n),
                make_field(position_part, by_position, n),
                make_field(velocity_part, by_velocity, n)};
  if (!by_input.empty()) fields.push_back(make_field(input_part, by_input, n));
  // Only the linearization has rows for dq/dt.
  if (request.kind == OutputKind::linearization) {
    fields.push_back(make_field(rate_part, parts->rates, n));
  }
  OutputEquations output{request, std::move(fields)};
  for (const std::size_t velocity : velocity_elimination_order(derivation)) {
    output.elimination_order.push_back(static_cast<std::uint32_t>(velocity));
  }
  return output;
}

OutputEquations derive_output(Derivation& derivation, const OutputRequest& request) {
  if (auto parts = composed_output(derivation, request)) return std::move(*parts);
  return {request, output_functions[static_cast<std::size_t>(request.kind)](derivation, request)};
}

/// Replaces each entry by the symbol of a definition, which other outputs can share.
void define_entries(Derivation& derivation, std::vector<FieldEquations>& fields) {
  for (FieldEquations& field : fields) {
    for (ex& entry : field.entries) entry = define(derivation.definitions, entry);
  }
}

/// The number of additions, multiplications and powers in an expression.
std::size_t count_ginac_operations(const ex& value) {
  std::size_t total = GiNaC::is_a<GiNaC::power>(value) ? 1 : 0;
  if (GiNaC::is_a<GiNaC::add>(value) || GiNaC::is_a<GiNaC::mul>(value)) total = value.nops() - 1;
  for (std::size_t i = 0; i < value.nops(); ++i) total += count_ginac_operations(value.op(i));
  return total;
}

/// Forward dynamics by the articulated-body algorithm. `is_shorter`: the algorithm needs fewer
/// operations than the factorisation of M, so forward dynamics through M is not derived.
/// articulated_route() returns none if the algorithm does not apply, if the definitions exceed
/// their limit, or if a pivot is 0. In the last case, the route through M reports that M is
/// singular.
struct ArticulatedRoute {
  EquationsOfMotion equations = {};
  bool is_shorter = false;
};
std::optional<ArticulatedRoute> articulated_route(const Lagrangian& lagrangian,
                                                  const OutputRequest& request,
                                                  const Limits& limits) {
  const bool may_be_shorter = lagrangian.symbols.v.size() >= min_articulated_velocities;
  // The articulated-body algorithm only gives forward dynamics.
  if (request.kind != OutputKind::forward_dynamics || !may_be_shorter) return std::nullopt;
  Derivation derivation(lagrangian);
  ArticulatedRoute route;
  try {
    const auto dynamics = articulated_dynamics(derivation, !request.omits_pivots);
    if (!dynamics) return std::nullopt;
    OutputEquations output{
        request, make_output_fields(derivation, request, field_entries(dynamics->solution))};
    define_entries(derivation, output.fields);
    output.value_names = std::move(derivation.definitions.value_names.names);
    route.equations.outputs.push_back(std::move(output));
    std::size_t operations = 0;
    for (const Definition& definition : derivation.definitions.list) {
      operations += count_ginac_operations(definition.value);
    }
    route.is_shorter = operations < dynamics->factorisation_operations;
  } catch (const ZeroPivot&) {
    return std::nullopt;
  }
  if (derivation.definitions.list.size() > limits.derived_nodes) return std::nullopt;
  route.equations.symbols = derivation.symbols;
  route.equations.leaves = lagrangian.leaves;
  route.equations.definitions = std::move(derivation.definitions);
  return route;
}

Diagnostic zero_pivot_error(const OutputRequest& request, const ZeroPivot& pivot,
                            const LeafNames& names) {
  switch (pivot.rows) {
    case RowKind::constraints:
      return *singular_system_error(request, pivot.row, names);
    case RowKind::inputs:
      return redundant_input_error(request, names.u[pivot.row]);
    case RowKind::velocities:
      break;
  }
  const std::string& velocity = names.v[pivot.row];
  return pivot.is_diagonal ? no_kinetic_energy_error(request, velocity)
                           : singular_mass_matrix_error(request, velocity);
}

}  // namespace

Result<EquationsOfMotion> derive(const Lagrangian& lagrangian,
                                 const std::vector<OutputRequest>& outputs, const Limits& limits) {
  Derivation derivation(lagrangian);
  EquationsOfMotion equations;
  for (const OutputRequest& request : outputs) {
    if (!has_equations(output_row(request.kind))) continue;
    try {
      auto other = articulated_route(lagrangian, request, limits);
      if (other) equations.alternatives.push_back(std::move(other->equations));
      if (other && other->is_shorter) continue;
      OutputEquations output = derive_output(derivation, request);
      define_entries(derivation, output.fields);
      output.value_names = std::exchange(derivation.definitions.value_names, {}).names;
      equations.outputs.push_back(std::move(output));
    } catch (const ZeroPivot& pivot) {
      return zero_pivot_error(request, pivot, lagrangian.leaves);
    } catch (const GiNaC::pole_error&) {
      return Diagnostic{
          Code::E313, request.span,
          fmt::format("`{}` has no value: an energy divides by zero at zero rates", request.name)};
    }
    if (derivation.definitions.list.size() > limits.derived_nodes) {
      return too_many_nodes_error(request, limits.derived_nodes);
    }
  }
  equations.symbols = derivation.symbols;
  equations.leaves = lagrangian.leaves;
  for (const OutputRequest& request : outputs) {
    // Integration steps have no equations here: they are composed later, and the leaf h gets its
    // name then.
    const OutputRow& row = output_row(request.kind);
    if (has_equations(row)) name_optional_leaves(row.argument_kinds, equations.leaves);
  }
  equations.definitions = std::move(derivation.definitions);
  return equations;
}

std::string dump(const EquationsOfMotion& equations) {
  std::string text = dump(equations.definitions);
  for (const OutputEquations& output : equations.outputs) {
    for (const FieldEquations& field : output.fields) {
      const std::string dot = field.name.empty() ? "" : ".";
      text += fmt::format("{}{}{} ({} x {}) =", output.request.name, dot, field.name, field.rows,
                          field.columns);
      for (const ex& entry : field.entries) {
        text += " " + expression_text(equations.definitions, entry);
      }
      text += '\n';
    }
  }
  for (const EquationsOfMotion& other : equations.alternatives) text += dump(other);
  return text;
}

}  // namespace elgen
