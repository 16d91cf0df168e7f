// leaf_names: names, numbers, units and ranges of the leaves of a model.
#include "elgen/leaf_names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.hpp"

namespace elgen {
namespace {

/// f(list) for the list of model entries that own the leaves; none for leaves that no entry owns,
/// such as t.
template <class F>
auto apply_to_owner(const Model& model, LeafOwner owner, const F& f)
    -> std::optional<decltype(f(model.parameters))> {
  switch (owner) {
    case LeafOwner::system:
      break;
    case LeafOwner::parameters:
      return f(model.parameters);
    case LeafOwner::open_values:
      return f(model.open_values);
    case LeafOwner::coordinates:
      return f(model.coordinates);
    case LeafOwner::velocities:
      return f(model.velocities);
    case LeafOwner::constraints:
      return f(model.constraints);
    case LeafOwner::inputs:
      return f(model.inputs);
  }
  return std::nullopt;
}

}  // namespace

LeafNames leaf_names(const Model& model) {
  const auto name = [](Opcode, const auto& entry) { return entry.name; };
  const auto single = [](Opcode kind) { return kind == Opcode::time ? "t" : ""; };
  // The outputs that a page adds may contain t although the equations of the model do not.
  const auto takes_time = [](const UserOutput& o) {
    return o.argument_kinds.has_any(Opcode::time);
  };
  LeafNames leaves{make_leaf_values<std::string>(model, name, single),
                   model.uses_time || std::ranges::any_of(model.outputs, takes_time)};
  const auto clear_used = [](const LeafRow& row, std::vector<std::string>& list) {
    if (row.argument_rule == ArgumentRule::if_used) list.clear();
  };
  for_each_list(clear_used, leaves);
  for (const Parameter& p : model.parameters) leaves.assumptions.push_back(p.assumption);
  return leaves;
}

void name_optional_leaves(LeafSet takes, LeafNames& leaves) {
  const auto is_named = [takes](const LeafRow& row) {
    return row.argument_rule == ArgumentRule::if_used && takes.has_any(row.id);
  };
  const auto name_list = [&](const LeafRow& row, std::vector<std::string>& list) {
    if (is_named(row)) list = leaves.v;
  };
  for_each_list(name_list, leaves);
  const auto name_single = [&](Opcode kind, std::uint32_t, std::string& name) {
    const LeafRow& row = leaf_row(kind);
    if (is_single(kind) && is_named(row)) name = row.symbol;
  };
  for_each_leaf(name_single, leaves);
}

bool has_value_named(const Model& model, std::string_view name) {
  const auto has = [name](const auto& entries) {
    return std::ranges::any_of(entries, [name](const auto& entry) { return entry.name == name; });
  };
  return has(model.coordinates) || has(model.parameter_arrays) || has(model.inputs) ||
         has(model.functions) || has(model.prescribed) || has(model.definitions);
}

std::string energy_name(const Model& model) {
  const std::string name(leaf_row(Opcode::energy).symbol);
  return has_value_named(model, name) ? "energy_function" : name;
}

Assumption assumption_of(const LeafNames& leaves, std::uint32_t parameter) {
  return leaves.assumptions.empty() ? Assumption::none : leaves.assumptions[parameter];
}

std::string leaf_text(const LeafNames& leaves, Opcode kind, std::uint32_t number) {
  return fmt::format(fmt::runtime(leaf_row(kind).text), leaf_of(leaves, kind, number));
}

std::string leaf_text(const Model& model, Opcode kind, std::uint32_t number) {
  const LeafRow& row = leaf_row(kind);
  const auto name_in = [number](const auto& entries) { return entries[number].name; };
  const std::string name =
      apply_to_owner(model, row.owner, name_in).value_or(std::string(row.symbol));
  return fmt::format(fmt::runtime(row.text), name);
}

std::string component_name(const Model& model, const std::string& name) {
  const auto found = std::ranges::find(model.inputs, name, &Input::indexed_name);
  return name.empty() || found == model.inputs.end() ? name : found->name;
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
  const auto size_of = [](const auto& entries) { return entries.size(); };
  return apply_to_owner(model, leaf_row(kind).owner, size_of).value_or(1);
}

std::optional<Unit> declared_unit(const Model& model, Opcode kind, std::uint32_t number) {
  const auto unit_in = [number](const auto& entries) -> std::optional<Unit> {
    if constexpr (requires { entries[number].unit; }) return entries[number].unit;
    return std::nullopt;
  };
  return apply_to_owner(model, leaf_row(kind).owner, unit_in).value_or(std::nullopt);
}

std::optional<Interval> declared_range(const Model& model, Opcode kind, std::uint32_t number) {
  switch (leaf_row(kind).owner) {
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
