// Derives the potential energy V of [energy] as separate equations, and replaces V and its
// derivatives by leaves in the Lagrangian. Then all functions use the same rewritten form of V.
//
//     before    V = 1/2*k*(sqrt(l^2 + x^2) - l)^2
//               bias = c*v + k*(sqrt(l^2 + x^2) - l)*x/sqrt(l^2 + x^2)
//     after     V = f[0], dV/dx = f[1]
//               bias = c*v + f[1]
#include <string>
#include <utility>

#include "derive/lagrangian/derivation.hpp"
#include "elgen/equations_of_motion.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// A request for an output with `rows` entries. `user` distinguishes two outputs of one kind,
/// because the equations of an output are found by kind and `user`.
OutputRequest make_request(OutputKind kind, std::uint32_t user, std::string name,
                           std::size_t rows) {
  OutputRequest request;
  request.kind = kind;
  request.user = user;
  request.name = std::move(name);
  request.rows = static_cast<std::uint32_t>(rows);
  return request;
}

void add_output(Derivation& derivation, const OutputRequest& request, RealVector entries,
                PotentialEquations& potential) {
  for (ex& entry : entries) entry = define(derivation.definitions, entry);
  potential.requests.push_back(request);
  potential.equations.outputs.push_back({request, {{"", request.rows, 1, std::move(entries)}}});
}

/// d2V/dx_i dx_j, i <= j, row by row.
RealVector second_derivatives(Derivation& derivation, const RealVector& variables,
                              const RealVector& slopes) {
  std::vector<Tangent> along;
  for (const ex& variable : variables) {
    along.emplace_back(derivation.definitions, Seeds{{variable, 1}});
  }
  RealVector result;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    for (std::size_t j = i; j < variables.size(); ++j) result.push_back(along[j](slopes[i]));
  }
  return result;
}

/// Appends a definition whose value is a leaf. define() would return the leaf itself.
ex define_leaf(Definitions& definitions, const ex& leaf, LeafSet depends) {
  const ex symbol = GiNaC::realsymbol();
  const auto index = static_cast<std::uint32_t>(definitions.list.size());
  definitions.places.emplace(symbol, SymbolPlace{true, index, depends});
  definitions.list.push_back({symbol, leaf, {}, {}, {}, depends});
  return symbol;
}

}  // namespace

std::optional<PotentialEquations> derive_potential(const Lagrangian& lagrangian,
                                                   bool has_second_derivatives) {
  if (lagrangian.potential.empty() || lagrangian.expansion) return std::nullopt;
  Derivation derivation(lagrangian);
  const Terms terms = values_of(lagrangian.potential);
  const ex V = define(derivation.definitions, GiNaC::add(terms));
  const LeafSet depends = dependence(derivation.definitions, V);
  if (depends.has_any(Opcode::velocity) || !depends.has_any(Opcode::coordinate)) {
    return std::nullopt;
  }
  RealVector leaves = derivation.symbols.q;
  leaves.push_back(derivation.symbols.t);
  const RealVector all = gradient(derivation.definitions, weighted_terms(terms, 1), leaves);
  PotentialEquations potential;
  RealVector slopes;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    if (all[i].is_zero()) continue;
    potential.variables.push_back(leaves[i]);
    slopes.push_back(define(derivation.definitions, all[i]));
  }
  const std::size_t count = slopes.size();
  add_output(derivation, make_request(OutputKind::potential_energy, 0, "V", 1), {V}, potential);
  add_output(derivation, make_request(OutputKind::gravity, 0, "V_x", count), slopes, potential);
  if (has_second_derivatives) {
    add_output(derivation, make_request(OutputKind::gravity, 1, "V_xx", count * (count + 1) / 2),
               second_derivatives(derivation, potential.variables, slopes), potential);
  }
  potential.equations.symbols = derivation.symbols;
  potential.equations.leaves = lagrangian.leaves;
  potential.equations.definitions = std::move(derivation.definitions);
  return potential;
}

Lagrangian with_open_potential(Lagrangian lagrangian, const std::vector<ex>& variables) {
  Definitions& definitions = lagrangian.definitions;
  LeafSet depends;
  for (const ex& variable : variables) depends |= definitions.places.at(variable).leaf_dependence;
  const auto add = [&](const std::string& name) {
    const ex leaf = GiNaC::realsymbol(name);
    add_leaf(definitions, leaf, Opcode::open_value);
    lagrangian.symbols.f.push_back(leaf);
    lagrangian.leaves.f.push_back(name);
    return leaf;
  };
  const std::size_t count = variables.size();
  const ex V = add("V");
  RealVector leaves;
  for (std::size_t i = 0; i < count; ++i) leaves.push_back(add("V_x[" + std::to_string(i) + "]"));
  std::vector<std::vector<std::pair<ex, ex>>> seconds(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i; j < count; ++j) {
      const ex second = add("V_xx[" + std::to_string(i) + "][" + std::to_string(j) + "]");
      seconds[i].emplace_back(variables[j], second);
      if (j != i) seconds[j].emplace_back(variables[i], second);
    }
  }
  std::vector<std::pair<ex, ex>> slopes;
  for (std::size_t i = 0; i < count; ++i) {
    slopes.emplace_back(variables[i], define_leaf(definitions, leaves[i], depends));
    definitions.list.back().derivatives = std::move(seconds[i]);
  }
  lagrangian.potential = {{define_leaf(definitions, V, depends)}};
  definitions.list.back().derivatives = std::move(slopes);
  return lagrangian;
}

}  // namespace elgen
