// Names and units of the inputs that one entry declares.
#include "check/expressions/wrench_input.hpp"

#include <array>
#include <string>
#include <string_view>

#include "base/reason.hpp"

namespace elgen {
namespace {

constexpr std::array<std::string_view, 2> acting_keys{"wrench", "at"};
constexpr std::array<std::string_view, 3> exclusive_keys{"on", "wrench", "at"};

/// "_tx" … "_fz": what the name of a component adds to the name of its wrench.
std::string component_suffix(const WrenchComponentCounts& count, std::uint32_t component) {
  if (component >= count.torque) return std::string("_f") + "xyz"[component - count.torque];
  return std::string("_t") + "xyz"[count.torque == 1 ? 2U : component];
}

void set_units(Input* first, std::uint32_t count, const Unit& unit, const std::string& text) {
  for (std::uint32_t i = 0; i < count; ++i) {
    first[i].unit = unit;
    first[i].unit_text = text;
  }
}

}  // namespace

WrenchComponentCounts count_wrench_components(const Context& context, const EntrySyntax& entry) {
  const std::uint32_t torque = context.is_planar ? 1 : 3;
  return {entry.find("wrench") != nullptr ? torque : 0, context.is_planar ? 2U : 3U};
}

bool is_wrench_input(const EntrySyntax& entry) {
  return entry.name == "input" && first_two_keys(entry, acting_keys)[0] != nullptr;
}

std::optional<std::uint32_t> declare_wrench_input(Context& context, const EntrySyntax& entry,
                                                  const NewName& name) {
  const auto refuse = [&](Code reason, const Span& span, const std::string& message,
                          const std::string& hint = {}) {
    context.report.add(reason, span, message, hint);
    context.symbols.mark_failed(name.base);
    return std::nullopt;
  };
  if (const KeySyntax* repetition = entry.find("for"); repetition != nullptr || name.index) {
    return refuse(Reason::repeated_name, repetition == nullptr ? name.span : repetition->key_span,
                  "a wrench cannot be repeated: its index counts its components");
  }
  if (const KeySyntax* second = first_two_keys(entry, exclusive_keys)[1]) {
    return refuse(Reason::not_one_alternative, second->key_span,
                  "an input has one of `on`, `wrench` and `at`");
  }
  if (const KeySyntax* unit = entry.find("unit")) {
    return refuse(Reason::unit_of_wrench, unit->key_span, "torques are in N*m and forces in N",
                  "omit `unit`");
  }
  const WrenchComponentCounts count = count_wrench_components(context, entry);
  const auto first = static_cast<std::uint32_t>(context.model.inputs.size());
  for (std::uint32_t i = 0; i < count.torque + count.force; ++i) {
    const NewName indexed{name.base, i + 1, name.span};
    const NewName component{name.base + component_suffix(count, i), {}, name.span};
    context.model.inputs.push_back(make_row<Input>(entry, component));
    context.model.inputs.back().indexed_name = indexed.text();
    context.model.inputs.back().is_external = true;
    for (const NewName& each : {indexed, component}) {
      if (!context.symbols.declare(each, SymbolKind::input, first + i, context.report))
        return std::nullopt;
    }
  }
  const Unit newton = *find_unit("N");
  Input* const inputs = context.model.inputs.data() + first;
  set_units(inputs, count.torque, newton * *find_unit("m"), "N*m");
  set_units(inputs + count.torque, count.force, newton, "N");
  return first;
}

}  // namespace elgen
