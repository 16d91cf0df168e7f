// The names, numbers and ranges of the leaves of a model.
#include "elgen/leaf_names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.hpp"

namespace elgen {

LeafNames leaf_names(const Model& model) {
  const auto name = [](Opcode, const auto& entry) { return entry.name; };
  const auto single = [](Opcode kind) { return kind == Opcode::time ? "t" : ""; };
  LeafNames leaves{leaves_of<std::string>(model, name, single), model.uses_time};
  leaves.momenta.clear();
  for (const Parameter& p : model.parameters) leaves.assumptions.push_back(p.assumption);
  return leaves;
}

std::string energy_name(const Model& model) {
  const std::string name(leaf_row(Opcode::energy).symbol);
  const auto has = [&name](const auto& entries) {
    return std::ranges::any_of(entries, [&name](const auto& entry) { return entry.name == name; });
  };
  const bool is_taken = has(model.coordinates) || has(model.parameter_arrays) ||
                        has(model.inputs) || has(model.functions) || has(model.prescribed) ||
                        has(model.definitions);
  return is_taken ? "energy_function" : name;
}

Assumption assumption_of(const LeafNames& leaves, std::uint32_t parameter) {
  return leaves.assumptions.empty() ? Assumption::none : leaves.assumptions[parameter];
}

std::string leaf_text(const LeafNames& leaves, Opcode kind, std::uint32_t number) {
  return fmt::format(fmt::runtime(leaf_row(kind).text), leaf_of(leaves, kind, number));
}

std::string leaf_text(const Model& model, Opcode kind, std::uint32_t number) {
  const LeafRow& row = leaf_row(kind);
  const auto text = [&](std::string_view name) {
    return fmt::format(fmt::runtime(row.text), name);
  };
  switch (row.of) {
    case LeafOwner::system:
      break;
    case LeafOwner::parameters:
      return text(model.parameters[number].name);
    case LeafOwner::open_values:
      return text(model.open_values[number].name);
    case LeafOwner::coordinates:
      return text(model.coordinates[number].name);
    case LeafOwner::velocities:
      return text(model.velocities[number].name);
    case LeafOwner::constraints:
      return text(model.constraints[number].name);
    case LeafOwner::inputs:
      return text(model.inputs[number].name);
  }
  return text(row.symbol);
}

std::string identifier_of(std::string_view name) {
  std::string identifier;
  for (const char c : name) {
    if (is_word_character(c)) identifier += c;
    if (c == '[') identifier += '_';
  }
  return identifier;
}

std::size_t leaf_count(const Model& model, Opcode kind) {
  switch (leaf_row(kind).of) {
    case LeafOwner::system:
      return 1;
    case LeafOwner::parameters:
      return model.parameters.size();
    case LeafOwner::open_values:
      return model.open_values.size();
    case LeafOwner::coordinates:
      return model.coordinates.size();
    case LeafOwner::velocities:
      return model.velocities.size();
    case LeafOwner::constraints:
      return model.constraints.size();
    case LeafOwner::inputs:
      return model.inputs.size();
  }
  return 0;
}

std::optional<Interval> declared_range(const Model& model, Opcode kind, std::uint32_t number) {
  switch (leaf_row(kind).of) {
    case LeafOwner::parameters:
      return model.parameter_arrays[model.parameters[number].array].range;
    case LeafOwner::coordinates:
      return model.coordinates[number].range;
    case LeafOwner::velocities:
      if (kind != Opcode::velocity) break;
      return model.velocities[number].rate_range;
    case LeafOwner::inputs:
      return model.inputs[number].limits;
    case LeafOwner::open_values:
    case LeafOwner::constraints:
    case LeafOwner::system:
      break;
  }
  return std::nullopt;
}

}  // namespace elgen
