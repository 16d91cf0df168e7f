// Tables that are not repeated: [model], [define], [gravity], [energy], [outputs].
#include <algorithm>
#include <array>

#include "check/entries/entries.hpp"
#include "check/entries/in_frame.hpp"
#include "check/expressions/places.hpp"
#include "check/expressions/values.hpp"
#include "check/names/reserved_names.hpp"

namespace elgen {
namespace {

bool is_model_name(std::string_view name) {
  const auto has_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  return is_well_formed_name(name) && std::ranges::none_of(name, has_capital);
}

void read_header(Context& context, const EntrySyntax& entry) {
  Model& model = context.model;
  context.model_span = entry.span;
  model.name = text_value(entry, "name");
  model.title = text_value(entry, "title");
  model.description = text_value(entry, "description");
  model.reference = text_value(entry, "reference");
  const KeySyntax* name = entry.find("name");
  if (name == nullptr) return;
  model.name_span = name->value.span;
  if (!is_model_name(model.name)) {
    context.report.add(
        Code::E205, name->value.span,
        quote_text(model.name) + " is not lower-case letters, digits and underscores");
  } else {
    (void)check_name(model.name, name->value.span, context.report);
  }
}

void read_definitions(ValueReader& values, const EntrySyntax& entry) {
  Context& context = values.context();
  constexpr ExpressionRole place{"a definition", place::force_terms};
  for (const KeySyntax& key : entry.keys) {
    const DeclaredName* symbol = context.symbols.find(key.key);
    if (symbol == nullptr || symbol->kind != SymbolKind::definition) continue;
    const std::uint32_t target = symbol->elements.begin()->second;
    context.model.definitions[target].value = values.root(key.value, {place});
  }
}

void read_gravity(ValueReader& values, const EntrySyntax& entry) {
  const KeySyntax* vector = entry.find("vector");
  if (vector == nullptr) return;
  const Unit acceleration = *find_unit("m") / power(*find_unit("s"), {2, 1});
  const ExpressionRole place{"gravity", place::time_terms};
  values.context().model.gravity =
      pad_to_three(values.read_roots(vector->value, {place, acceleration}));
  (void)values.check_vector(vector->value);
}

struct EnergyKey {
  std::string_view key;
  std::optional<ExpressionId> Energies::*member;
  std::string_view unit;
  Ingredients allowed = place::energy_terms;
};

constexpr std::array<EnergyKey, 4> energy_keys{{
    {"T", &Energies::T, "J"},
    {"V", &Energies::V, "J"},
    {"D", &Energies::D, "W", place::dissipation_terms},
    {"L", &Energies::L, "J"},
}};

void read_energies(ValueReader& values, const EntrySyntax& entry) {
  Context& context = values.context();
  if (const KeySyntax* lagrangian = entry.find("L")) context.lagrangian_span = lagrangian->key_span;
  for (const auto& [key, member, unit, allowed] : energy_keys) {
    const ExpressionRole place{key, allowed};
    context.model.energies.*member = values.root(entry, key, {place, find_unit(unit)});
  }
}

void read_outputs(Model& model, const EntrySyntax& entry) {
  const KeySyntax* dynamics = entry.find("forward_dynamics");
  const KeySyntax* pivots = dynamics == nullptr ? nullptr : dynamics->value.find("pivots");
  model.omits_pivots = pivots != nullptr && !pivots->value.boolean;
}

}  // namespace

void read_table(Context& context, const EntrySyntax& entry) {
  ValueReader values(context);
  if (entry.name == "model") {
    read_header(context, entry);
  } else if (entry.name == "define") {
    read_definitions(values, entry);
  } else if (entry.name == "gravity") {
    read_gravity(values, entry);
  } else if (entry.name == "energy") {
    read_energies(values, entry);
  } else if (entry.name == "outputs") {
    read_outputs(context.model, entry);
  }
}

}  // namespace elgen
