// Builds equations of motion from GiNaC expressions, for tests of the import and of later passes.
#pragma once

#include <string>
#include <vector>

#include "elgen/equations_of_motion.hpp"

namespace elgen::test {

/// Equations without outputs, with leaves m, l (parameters), x, y (coordinates), u (input), t.
/// `rotation` changes the order in which symbols are created, and thereby GiNaC's order of terms.
inline EquationsOfMotion leaves(std::size_t rotation = 0) {
  const std::vector<std::string> names = {"m", "l", "x", "y", "vx", "vy", "ax", "ay", "u", "t"};
  std::vector<GiNaC::ex> symbols(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::size_t at = (i * 7 + rotation) % names.size();
    symbols[at] = GiNaC::symbol(names[at]);
  }
  EquationsOfMotion equations;
  equations.leaves.parameters = {"m", "l"};
  equations.leaves.q = equations.leaves.v = equations.leaves.a = {"x", "y"};
  equations.leaves.u = {"u"};
  equations.leaves.t = "t";
  equations.leaves.uses_time = true;
  equations.symbols.parameters = {symbols[0], symbols[1]};
  equations.symbols.q = {symbols[2], symbols[3]};
  equations.symbols.v = equations.symbols.q_rates = {symbols[4], symbols[5]};
  equations.symbols.a = {symbols[6], symbols[7]};
  equations.symbols.u = {symbols[8]};
  equations.symbols.t = symbols[9];
  return equations;
}

/// Appends the definition `name` = `value` and returns the symbol of the definition.
inline GiNaC::ex define_as(EquationsOfMotion& equations, const std::string& name,
                           const GiNaC::ex& value) {
  Definition definition;
  definition.symbol = GiNaC::symbol(name.empty() ? "anonymous" : name);
  definition.value = value;
  definition.name = name;
  for (std::uint32_t i = 0; i < equations.definitions.list.size(); ++i) {
    if (value.has(equations.definitions.list[i].symbol)) definition.used_definitions.push_back(i);
  }
  equations.definitions.list.push_back(definition);
  return definition.symbol;
}

/// Appends an output with one row; returns its request.
inline OutputRequest add_output(EquationsOfMotion& equations, OutputKind kind,
                                const std::vector<GiNaC::ex>& entries) {
  OutputRequest request;
  request.kind = kind;
  request.name = std::string(output_row(kind).name);
  request.columns = static_cast<std::uint32_t>(entries.size());
  equations.outputs.push_back({request, {{"", 1, request.columns, entries}}});
  return request;
}

}  // namespace elgen::test
