// Resolver, names: time, pi, running indices and sizes (as numbers), declared names; the energy and
// multipliers if the place allows them.
#include <algorithm>
#include <array>
#include <utility>

#include "base/reason.hpp"
#include "check/expressions/resolver.hpp"
#include "elgen/functions.hpp"
#include "elgen/leaf_names.hpp"
#include "elgen/units.hpp"

namespace elgen {
namespace {

constexpr std::string_view energy_function = "energy_function";

std::string_view energy_symbol() { return leaf_row(Opcode::energy).symbol; }

/// A new node for a symbol of this kind; the caller sets index and span. None if symbols of this
/// kind are no numbers.
std::optional<Expression> node_for_symbol(SymbolKind kind) {
  const auto leaf = [](Opcode of) { return Expression{.kind = ExpressionKind::leaf, .leaf = of}; };
  const auto name = [](NamedKind of) {
    return Expression{.kind = ExpressionKind::named, .named = of};
  };
  switch (kind) {
    case SymbolKind::coordinate:
      return leaf(Opcode::coordinate);
    case SymbolKind::parameter:
      return leaf(Opcode::parameter);
    case SymbolKind::definition:
      return name(NamedKind::definition);
    case SymbolKind::prescribed:
      return name(NamedKind::prescribed);
    case SymbolKind::input:
      return leaf(Opcode::input);
    case SymbolKind::open_value:
    case SymbolKind::open_derivative:
      return leaf(Opcode::open_value);
    default:
      return std::nullopt;
  }
}

/// "write `x(bob)`" for `x[bob]`, if bob is a point or body; "" otherwise.
std::string place_hint(const ExpressionSyntax& name, const SymbolTable& symbols) {
  if (find_call(name.text) == nullptr || name.operands.size() != 1) return "";
  const DeclaredName* const place = symbols.find(name.operands.front().text);
  const bool is_place =
      place != nullptr && (place->kind == SymbolKind::point || place->kind == SymbolKind::body);
  return is_place ? "write `" + name.text + "(" + name.operands.front().text + ")`" : "";
}

/// Hint on a name that is no number, such as a point: how to write its components.
std::string components_hint(const std::string& name, SymbolKind kind) {
  if (kind == SymbolKind::point) return "its components are `x(" + name + ")` and so on";
  if (kind == SymbolKind::rotation) {
    return "it is the `rotation` of a [[frame]]; its angular velocity is `dot(" + name +
           "[1])` to `dot(" + name + "[3])`";
  }
  return "";
}

/// A name that looks like a rate. theta_dot, thetadot, dtheta and dot_theta have the base theta and
/// 1 dot; theta_ddot has 2.
struct DottedName {
  std::string base;
  int dots = 0;
};

std::optional<DottedName> dotted_name(const std::string& name, const SymbolTable& symbols) {
  constexpr std::array<std::pair<std::string_view, int>, 4> endings{
      {{"_ddot", 2}, {"ddot", 2}, {"_dot", 1}, {"dot", 1}}};
  constexpr std::array<std::pair<std::string_view, int>, 5> beginnings{
      {{"ddot_", 2}, {"dot_", 1}, {"dd", 2}, {"d", 1}, {"v_", 1}}};
  const auto is_coordinate = [&](const std::string& base) {
    const DeclaredName* symbol = symbols.find(base);
    return symbol != nullptr && symbol->kind == SymbolKind::coordinate;
  };
  for (const auto& [part, dots] : endings) {
    if (!name.ends_with(part)) continue;
    const std::string base = name.substr(0, name.size() - part.size());
    if (is_coordinate(base)) return DottedName{base, dots};
  }
  for (const auto& [part, dots] : beginnings) {
    if (name.starts_with(part) && is_coordinate(name.substr(part.size()))) {
      return DottedName{name.substr(part.size()), dots};
    }
  }
  return std::nullopt;
}

/// Hint on an angle in degrees, pi, e, a unit, a component of a place, a rate or an acceleration,
/// if `name` looks like any of these; "" otherwise.
std::string usual_name_hint(const ExpressionSyntax& name, const SymbolTable& symbols) {
  if (name.text == "deg" || name.text == "degrees") return std::string(degrees_hint);
  if (name.text == "PI") return "write `pi`";
  if (name.text == "e") return "e^x is written `exp(x)`";
  if (name.text.size() > 1 && find_unit(name.text))
    return "a unit belongs to a parameter: `unit = \"" + name.text + "\"`";
  const std::string place = place_hint(name, symbols);
  return place.empty() ? rate_hint(name.text, covered_text(name.span), symbols) : place;
}

}  // namespace

std::string rate_hint(const std::string& name, std::string_view written,
                      const SymbolTable& symbols) {
  const auto dotted = dotted_name(name, symbols);
  if (!dotted) return "";
  const std::size_t bracket = std::min(written.find('['), written.size());
  const std::string base = dotted->base + std::string(written.substr(bracket));
  return dotted->dots == 1 ? "a rate is written `dot(" + base + ")`"
                           : "an acceleration is written `dot(dot(" + base + "))`";
}

std::optional<ExpressionId> Resolver::resolve_name(const ExpressionSyntax& name) {
  const bool indexed = !name.operands.empty();
  const bool is_refused = context_.symbols.has_failed(name.text);
  if (!indexed && name.text == "t" && !is_refused) return push_leaf(Opcode::time, 0, name.span);
  if (!indexed && name.text == "pi") return push({.kind = ExpressionKind::pi, .span = name.span});
  if (const auto value = scope_.find(name.text); value && !indexed) {
    return push_number(cln::cl_I(static_cast<long>(*value)), name.span);
  }
  if (is_energy(name)) return push_leaf(Opcode::energy, 0, name.span);
  if (const DeclaredName* symbol = context_.symbols.find(name.text)) {
    report_hidden_energy(name, *symbol);
    return resolve_symbol(name, *symbol);
  }
  const std::size_t multipliers =
      (allowed_ & uses_multiplier) == 0 ? 0 : context_.model.constraints.size();
  for (std::uint32_t i = 0; i < multipliers; ++i) {
    if (leaf_text(context_.model, Opcode::multiplier, i) == covered_text(name.span))
      return push_leaf(Opcode::multiplier, i, name.span);
  }
  return is_refused ? std::nullopt : report_unknown_name(name);
}

bool Resolver::is_energy(const ExpressionSyntax& name) const {
  if ((allowed_ & uses_energy) == 0 || !name.operands.empty()) return false;
  const SymbolTable& symbols = context_.symbols;
  const bool is_free = symbols.find(name.text) == nullptr && !symbols.has_failed(name.text);
  return name.text == energy_function || (name.text == energy_symbol() && is_free);
}

void Resolver::report_hidden_energy(const ExpressionSyntax& name, const DeclaredName& symbol) {
  const bool hides = (allowed_ & uses_energy) != 0 && name.text == energy_symbol();
  if (!hides || context_.report.has(Code::E213)) return;
  Diagnostic note{Code::E213, name.span,
                  "`E` is the " + std::string(symbol_noun(symbol.kind)) + " of the model here",
                  "`energy_function` is v dL/dv - L in every model"};
  note.related = symbol.span;
  note.related_message = "`E` is declared here";
  context_.report.add(std::move(note));
}

std::optional<ExpressionId> Resolver::resolve_symbol(const ExpressionSyntax& name,
                                                     const DeclaredName& symbol) {
  std::optional<Expression> node = node_for_symbol(symbol.kind);
  if (!node) {
    context_.report.add(Code::E319, name.span,
                        in_backticks(name.span) + " is a " + std::string(symbol_noun(symbol.kind)) +
                            ", not a number",
                        components_hint(name.text, symbol.kind));
    return std::nullopt;
  }
  const std::optional<std::uint32_t> index = resolve_element(name, symbol);
  if (!index) return std::nullopt;
  node->index = *index;
  node->span = name.span;
  if (is_leaf(*node, Opcode::open_value)) {
    const OpenValue& value = context_.model.open_values[*index];
    node->operands = context_.model.functions[value.function].arguments;
  }
  return push(std::move(*node));
}

const DeclaredName* Resolver::require_declaration(const ExpressionSyntax& name, SymbolKind kind,
                                                  bool has_form, std::string_view shown) {
  const bool is_frame = kind == SymbolKind::frame;
  const SymbolTable& symbols = is_frame ? context_.frames : context_.symbols;
  const DeclaredName* symbol = symbols.find(name.text);
  if (symbol == nullptr && symbols.has_failed(name.text)) return nullptr;
  if (symbol != nullptr && symbol->kind == kind && has_form) return symbol;
  std::vector<std::string> names = symbols.names({kind});
  if (is_frame) names.emplace_back(world);
  context_.report.add(Reason::name_of_another_kind, name.span,
                      "unknown " + std::string(symbol_noun(kind)) + " " + quote_text(shown),
                      symbols.suggest(name.text, names));
  return nullptr;
}

std::optional<std::uint32_t> Resolver::resolve_element(const ExpressionSyntax& name,
                                                       const DeclaredName& symbol, Code absent) {
  if (symbol.is_array == name.operands.empty()) {
    context_.report.add(Code::E208, name.span,
                        symbol.is_array ? quote_text(name.text) +
                                              " needs an index: " + elements_of(name.text, symbol)
                                        : quote_text(name.text) + " takes no index",
                        place_hint(name, context_.symbols));
    return std::nullopt;
  }
  if (!symbol.is_array) return symbol.elements.begin()->second;
  const auto index = evaluate_integer(name.operands.front(), scope_, context_.report);
  if (!index) return std::nullopt;
  const auto found = symbol.elements.find(*index);
  if (found == symbol.elements.end()) {
    const std::string element = name.text + "[" + std::to_string(*index) + "]";
    const bool says_so = covered_text(name.span) == element;
    context_.report.add(absent, name.span,
                        (says_so ? "there is no " + quote_text(element)
                                 : in_backticks(name.span) + " is " + quote_text(element)) +
                            (says_so ? ": " : ", but ") + elements_of(name.text, symbol));
    return std::nullopt;
  }
  return found->second;
}

std::optional<ExpressionId> Resolver::report_unknown_name(const ExpressionSyntax& name) {
  if (is_reserved_function(name.text)) {
    context_.report.add(Code::E316, name.span, quote_text(name.text) + " has no argument",
                        "write `" + name.text + "(…)`");
    return std::nullopt;
  }
  std::string hint = usual_name_hint(name, context_.symbols);
  if (hint.empty() && context_.report.needs_suggestion()) {
    std::vector<std::string> candidates = context_.symbols.names();
    const std::vector<std::string> indices = scope_.names();
    candidates.insert(candidates.end(), indices.begin(), indices.end());
    candidates.insert(candidates.end(), {"pi", "t"});
    hint = context_.symbols.suggest(name.text, candidates);
  }
  const CallRow* const call = find_call(name.text);
  if (hint.empty() && call != nullptr)
    hint = "declare it, or write `" + std::string(call->usage) + "`";
  context_.report.add(Reason::unknown_name, name.span, "unknown name " + quote_text(name.text),
                      std::move(hint));
  return std::nullopt;
}

}  // namespace elgen
