// LeafNames of a model, and the dimensions outputs are shaped by.
#include "elgen/leaf_names.hpp"

namespace elgen {
namespace {

template <class Rows>
std::vector<std::string> names_of(const Rows& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) {
    names.push_back(row.name);
  }
  return names;
}

}  // namespace

LeafNames leaf_names(const Model& model) {
  const std::vector<std::string> velocities = names_of(model.velocities);
  return {{names_of(model.parameters), names_of(model.coordinates), velocities, velocities,
           names_of(model.inputs), "t"},
          model.uses_time};
}

std::string leaf_text(const LeafNames& leaves, Opcode kind, std::uint32_t number) {
  const std::string& name = leaf_of(leaves, kind, number);
  if (kind == Opcode::acceleration) return "dot(dot(" + name + "))";
  return kind == Opcode::velocity ? "dot(" + name + ")" : name;
}

Dimensions dimensions(const Model& model) {
  return {model.coordinates.size(), model.velocities.size(), model.inputs.size(),
          model.parameters.size()};
}

}  // namespace elgen
