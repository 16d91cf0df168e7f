// Resolver, calls: the functions of functions.def, composite_functions.def, resolve_motion.cpp and
// resolve_sum.cpp, and the functions that are expanded here:
//
//     dot(q) -> rate    delta(i, j) -> 0 or 1    p(q) -> momentum
#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <utility>

#include "base/reason.hpp"
#include "check/expressions/resolver.hpp"
#include "check/names/reserved_names.hpp"
#include "elgen/functions.hpp"

namespace elgen {
namespace {

constexpr std::array composites{
#define ELGEN_COMPOSITE(name, arity, definition, in_space, usage, doc) \
  Resolver::CompositeFunction{#name, arity, definition, in_space},
#include "base/composite_functions.def"
#undef ELGEN_COMPOSITE
};

const Resolver::CompositeFunction* find_composite(std::string_view name) {
  const auto found = std::ranges::find(composites, name, &Resolver::CompositeFunction::name);
  return found == composites.end() ? nullptr : &*found;
}

/// The syntax of a definition of the table, parsed at its first use. The table has no errors.
const ExpressionSyntax& parse_definition(std::string_view definition) {
  static std::map<std::string_view, ExpressionSyntax> read;
  const auto known = read.find(definition);
  if (known != read.end()) return known->second;
  const SourcePointer source = make_source("definition", std::string(definition));
  return read.emplace(definition, *parse_expression(source, Limits{})).first->second;
}

/// The definition with the call's arguments substituted for x and y; every node has the call's
/// span.
ExpressionSyntax substitute_arguments(ExpressionSyntax definition, const ExpressionSyntax& call) {
  if (definition.kind == SyntaxKind::name) {
    if (definition.text == "x") return call.operands[0];
    if (definition.text == "y") return call.operands[1];
  }
  for (ExpressionSyntax& operand : definition.operands)
    operand = substitute_arguments(operand, call);
  definition.span = call.span;
  definition.token = call.token;
  return definition;
}

/// Hint on an unknown function: for one of other languages the call to write, such as `x^2` for
/// pow(x, 2); for other names the nearest function.
std::string unknown_function_hint(const ExpressionSyntax& call) {
  if (call.text == "deg" || call.text == "radians" || call.text == "deg2rad")
    return std::string(degrees_hint);
  std::vector<std::string> arguments;
  for (const ExpressionSyntax& operand : call.operands) {
    const std::string text(covered_text(operand.span));
    const bool is_short = call.operands.size() == 1 || operand.kind == SyntaxKind::name ||
                          operand.kind == SyntaxKind::number || operand.kind == SyntaxKind::call;
    arguments.push_back(is_short ? text : "(" + text + ")");
  }
  const bool is_rate = call.text == "diff" && arguments.size() == 2 && call.operands[1].text == "t";
  const std::string translated =
      is_rate ? "dot(" + arguments[0] + ")" : translate_call(call.text, arguments);
  return translated.empty() ? suggestion(call.text, function_names())
                            : "write " + quote_text(translated);
}

}  // namespace

std::optional<ExpressionId> Resolver::resolve_call(const ExpressionSyntax& call) {
  if (const FunctionRow* function = find_function(call.text)) {
    return function->id == FunctionId::stumpff ? resolve_stumpff(call)
                                               : resolve_function(call, function->id);
  }
  if (const CompositeFunction* composite = find_composite(call.text)) {
    return resolve_composite(call, *composite);
  }
#define ELGEN_EXPANDED(name, rule, is_reserved, usage, doc) \
  if (call.text == #name) return rule(call);
#include "base/expanded_functions.def"
#undef ELGEN_EXPANDED
  // not in the table, since a model may declare a `p`
  if (call.text == "p") return resolve_momentum(call);
  context_.report.add(Code::E202, call.span, "unknown function " + quote_text(call.text),
                      unknown_function_hint(call));
  return std::nullopt;
}

bool Resolver::check_arity(const ExpressionSyntax& call, std::size_t arity) {
  if (call.operands.size() == arity) return true;
  const std::size_t count = call.operands.size();
  context_.report.add(Code::E309, call.span,
                      count_text(count, "argument") + ", but " + quote_text(call.text) + " takes " +
                          std::to_string(arity));
  return false;
}

std::optional<ExpressionId> Resolver::resolve_function(const ExpressionSyntax& call,
                                                       FunctionId function) {
  if (!check_arity(call, function_row(function).arity)) return std::nullopt;
  std::optional<Operands> operands = resolve_operands(call.operands);
  if (!operands) return std::nullopt;
  return push({.kind = ExpressionKind::function,
               .function = function,
               .operands = std::move(*operands),
               .span = call.span});
}

/// stumpff(x, k); for k = 0 this is cos(x).
std::optional<ExpressionId> Resolver::resolve_stumpff(const ExpressionSyntax& call) {
  constexpr std::int64_t largest_order = 40;
  if (!check_arity(call, 2)) return std::nullopt;
  const ExpressionSyntax& order = call.operands[1];
  const auto k = evaluate_integer(order, scope_, context_.report);
  if (!k) return std::nullopt;
  if (std::abs(*k) > largest_order) {
    const std::string most = std::to_string(largest_order);
    context_.report.add(Code::E318, order.span,
                        in_backticks(order.span) + " is not from -" + most + " to " + most);
    return std::nullopt;
  }
  const std::optional<ExpressionId> x = resolve(call.operands[0]);
  if (!x) return std::nullopt;
  if (*k == 0) {
    return push({.kind = ExpressionKind::function,
                 .function = FunctionId::cos,
                 .operands = {*x},
                 .span = call.span});
  }
  const auto number = push_number(cln::cl_I(static_cast<long>(*k)), order.span);
  if (!number) return std::nullopt;
  return push({.kind = ExpressionKind::function,
               .function = FunctionId::stumpff,
               .operands = {*x, *number},
               .span = call.span});
}

std::optional<ExpressionId> Resolver::resolve_composite(const ExpressionSyntax& call,
                                                        const CompositeFunction& composite) {
  if (!check_arity(call, composite.arity)) return std::nullopt;
  if (composite.spatial_definition.empty())
    return resolve(substitute_arguments(parse_definition(composite.definition), call));
  const std::optional<std::uint32_t> dimension = require_common_dimension(call);
  if (!dimension) return std::nullopt;
  return resolve(substitute_arguments(
      parse_definition(*dimension == 3 ? composite.spatial_definition : composite.definition),
      call));
}

std::optional<std::uint32_t> Resolver::require_common_dimension(const ExpressionSyntax& call) {
  std::vector<std::uint32_t> dimensions;
  for (const ExpressionSyntax& operand : call.operands) {
    const std::optional<ResolvedPlace> place = resolve_place(operand);
    if (place) dimensions.push_back(place->dimension);
  }
  if (dimensions.size() < call.operands.size()) return std::nullopt;
  if (dimensions.front() == dimensions.back()) return dimensions.front();
  context_.report.add(Code::E516, call.span,
                      "one of the places of " + in_backticks(call.span) + " is planar");
  return std::nullopt;
}

std::optional<ExpressionId> Resolver::resolve_dot(const ExpressionSyntax& call) {
  if (!check_arity(call, 1)) return std::nullopt;
  const ExpressionSyntax& operand = call.operands[0];
  const DeclaredName* symbol = context_.symbols.find(operand.text);
  if (operand.kind == SyntaxKind::name && symbol != nullptr &&
      symbol->kind == SymbolKind::rotation) {
    const std::optional<std::uint32_t> velocity = resolve_element(operand, *symbol);
    return velocity ? push_leaf(Opcode::velocity, *velocity, call.span) : std::nullopt;
  }
  const std::optional<ExpressionId> argument = resolve(operand);
  if (!argument) return std::nullopt;
  const Expression& inner = context_.model.expressions[*argument];
  if (is_leaf(inner, Opcode::coordinate)) {
    return push_leaf(Opcode::velocity, context_.model.coordinates[inner.index].velocity, call.span);
  }
  if (is_leaf(inner, Opcode::velocity)) {
    return push_leaf(Opcode::acceleration, inner.index, call.span);
  }
  if (context_.constants[*argument]) return push_number(0, call.span);
  return push(
      {.kind = ExpressionKind::time_derivative, .operands = {*argument}, .span = call.span});
}

std::optional<ExpressionId> Resolver::resolve_momentum(const ExpressionSyntax& call) {
  if (!check_arity(call, 1)) return std::nullopt;
  const ExpressionSyntax& operand = call.operands[0];
  const bool is_name = operand.kind == SyntaxKind::name;
  const DeclaredName* symbol = is_name ? context_.symbols.find(operand.text) : nullptr;
  const bool turns = symbol != nullptr && symbol->kind == SymbolKind::rotation;
  if (turns || (symbol != nullptr && symbol->kind == SymbolKind::coordinate)) {
    const std::optional<std::uint32_t> index = resolve_element(operand, *symbol);
    if (!index) return std::nullopt;
    const std::uint32_t velocity = turns ? *index : context_.model.coordinates[*index].velocity;
    return push_leaf(Opcode::momentum, velocity, call.span);
  }
  if (is_name && context_.symbols.has_failed(operand.text)) return std::nullopt;
  context_.report.add(
      Code::E212, operand.span,
      in_backticks(operand.span) + " is no coordinate, so it has no momentum",
      "`p(NAME)` is dL/d(dot(NAME)) of a coordinate, or of `NAME[k]` of a rotation");
  return std::nullopt;
}

std::optional<ExpressionId> Resolver::resolve_multiplier(const ExpressionSyntax& call) {
  if (!check_arity(call, 1)) return std::nullopt;
  const Span& span = call.operands[0].span;
  const std::vector<Constraint>& all = context_.model.constraints;
  const std::string name(covered_text(span));
  const auto found = std::ranges::find(all, name, &Constraint::name);
  if (found != all.end()) {
    return push_leaf(Opcode::multiplier, static_cast<std::uint32_t>(found - all.begin()),
                     call.span);
  }
  context_.report.add(Reason::unknown_constraint, span, "unknown constraint " + quote_text(name),
                      suggestion(name, column_words(all, &Constraint::name),
                                 all.empty() ? "no constraint is declared before it" : ""));
  return std::nullopt;
}

std::optional<ExpressionId> Resolver::resolve_delta(const ExpressionSyntax& call) {
  if (!check_arity(call, 2)) return std::nullopt;
  const auto i = evaluate_integer(call.operands[0], scope_, context_.report);
  const auto j = evaluate_integer(call.operands[1], scope_, context_.report);
  return i && j ? push_number(*i == *j ? 1 : 0, call.span) : std::nullopt;
}

}  // namespace elgen
