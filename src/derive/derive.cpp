// derive: Lagrangian -> EquationsOfMotion. The function that bears the name of an output derives
// it; only what the scene asks for is derived.
#include <fmt/format.h>

#include <algorithm>

#include "derive/lagrangian/symmetric_solve.hpp"
#include "derive/lagrangian/turning.hpp"
#include "derive/lower/from_ginac.hpp"
#include "derive/outputs/outputs.hpp"
#include "elgen/equations_of_motion.hpp"
#include "inspect/singular_mass.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

using Fields = std::vector<FieldEquations>;

/// Fields of `rows` rows, or one column each; one without entries is left out: a model without
/// inputs has none by them.
Fields named(const std::vector<std::pair<std::string, Vector>>& entries,
             std::optional<std::size_t> rows = {}) {
  Fields result;
  for (const auto& [name, values] : entries) {
    if (values.empty()) continue;
    const std::size_t height = rows.value_or(values.size());
    result.push_back({name, static_cast<std::uint32_t>(height),
                      static_cast<std::uint32_t>(values.size() / height), values});
  }
  return result;
}

Fields fields(const Derivation& /*derivation*/, const OutputRequest& request, Vector entries) {
  return {{"", request.rows, request.columns, std::move(entries)}};
}

Fields fields(const Derivation& derivation, const OutputRequest& request, const ex& entry) {
  return fields(derivation, request, Vector{entry});
}

Fields fields(const Derivation& d, const OutputRequest& /*request*/, const InverseDerivatives& x) {
  return named({{"by_position", x.by_position}, {"by_velocity", x.by_velocity}}, d.size());
}

Fields fields(const Derivation& d, const OutputRequest& /*request*/, const ForwardDerivatives& x) {
  return named(
      {{"by_position", x.by_position}, {"by_velocity", x.by_velocity}, {"by_input", x.by_input}},
      d.size());
}

Fields fields(const Derivation& d, const OutputRequest& /*request*/, const Linearization& x) {
  return named({{"A", x.a}, {"B", x.b}}, 2 * d.size());
}

Fields fields(const Derivation& /*derivation*/, const OutputRequest& /*request*/,
              const ForwardDynamics& x) {
  return named({{"acceleration", x.acceleration},
                {"relative_pivots", x.relative_pivots},
                {"multipliers", x.multipliers},
                {"diagonal", x.diagonal}});
}

Fields fields(const Derivation& /*derivation*/, const OutputRequest& /*request*/,
              const HamiltonEquations& x) {
  return named({{"coordinate_rates", x.coordinate_rates}, {"momentum_rates", x.momentum_rates}});
}

Fields fields(const Derivation& /*derivation*/, const OutputRequest& /*request*/,
              const ConstraintResidual& x) {
  return named({{"position", x.position}, {"rate", x.rate}});
}

Fields fields(const Derivation& /*derivation*/, const OutputRequest& /*request*/,
              const ProjectedState& x) {
  return named({{"coordinates", x.coordinates}, {"rates", x.rates}});
}

Fields fields(const Derivation& /*derivation*/, const OutputRequest& /*request*/,
              const ConstrainedInverse& x) {
  return named(
      {{"inputs", x.inputs}, {"multipliers", x.multipliers}, {"unbalanced", x.unbalanced}});
}

Vector user_value(Derivation& /*derivation*/, const NamedOutput& output) { return output.values; }

Vector user_jacobian(Derivation& derivation, const NamedOutput& output) {
  return output.twist ? twist_jacobian(derivation, *output.twist)
                      : jacobian(derivation, output.values);
}

Vector user_bias(Derivation& derivation, const NamedOutput& output) {
  return output.twist ? twist_bias(derivation, *output.twist)
                      : second_rate(derivation, output.values);
}

/// The function of each output, in the order of the table; what is made of others has none.
constexpr Fields (*derivations[])(Derivation&, const OutputRequest&) = {
#define ELGEN_OUTPUT(name) \
  [](Derivation& d, const OutputRequest& request) { return fields(d, request, name(d)); },
#define ELGEN_USER_OUTPUT(name)                                             \
  [](Derivation& d, const OutputRequest& request) {                         \
    return fields(d, request, name(d, d.lagrangian.outputs[request.user])); \
  },
#define ELGEN_SUMMARY(name) nullptr,
#define ELGEN_STEP(name) nullptr
#include "elgen/outputs.def"
};

Fields derived(Derivation& derivation, const OutputRequest& request) {
  return derivations[static_cast<std::size_t>(request.kind)](derivation, request);
}

/// Entries as symbols, so that every output, and what shares them, refers to definitions.
void define_entries(Derivation& derivation, std::vector<FieldEquations>& fields) {
  for (FieldEquations& field : fields) {
    for (ex& entry : field.entries) entry = define(derivation.definitions, entry);
  }
}

Diagnostic singular(const OutputRequest& request, const ZeroPivot& pivot, const LeafNames& names) {
  switch (pivot.rows) {
    case RowsOf::constraints:
      return redundant_constraint(request, names.multipliers[pivot.row]);
    case RowsOf::inputs:
      return redundant_input(request, names.u[pivot.row]);
    case RowsOf::velocities:
      break;
  }
  const std::string& velocity = names.v[pivot.row];
  return pivot.is_diagonal ? no_kinetic_energy(request, velocity)
                           : singular_mass_matrix(request, velocity);
}

}  // namespace

Result<EquationsOfMotion> derive(const Lagrangian& lagrangian,
                                 const std::vector<OutputRequest>& outputs, const Limits& limits) {
  Derivation derivation(lagrangian);
  EquationsOfMotion equations;
  for (const OutputRequest& request : outputs) {
    if (!has_equations(output_row(request.kind))) continue;
    try {
      OutputEquations output{request, derived(derivation, request)};
      define_entries(derivation, output.fields);
      equations.outputs.push_back(std::move(output));
    } catch (const ZeroPivot& pivot) {
      return singular(request, pivot, lagrangian.leaves);
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
  const bool takes_momenta = std::ranges::any_of(outputs, [](const OutputRequest& request) {
    return output_row(request.kind).takes.has_any(Opcode::momentum);
  });
  if (takes_momenta) equations.leaves.momenta = equations.leaves.v;
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
  return text;
}

}  // namespace elgen
