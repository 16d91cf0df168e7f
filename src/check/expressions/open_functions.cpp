// Open functions: declares their names, and reads the expressions that close (replace) them.
#include "check/expressions/open_functions.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/reason.hpp"
#include "check/expressions/values.hpp"
#include "elgen/leaf_names.hpp"
#include "elgen/references.hpp"

namespace elgen {
namespace {

std::vector<const EntrySyntax*> functions_of(const FileSyntax& model) {
  std::vector<const EntrySyntax*> functions;
  for (const EntrySyntax& entry : model.entries) {
    if (entry.name == "function") functions.push_back(&entry);
  }
  return functions;
}

void replace_by_scene(Context& context, const FileSyntax& model, const FileSyntax& scene) {
  std::vector<std::string> names;
  for (const EntrySyntax* function : functions_of(model)) names.push_back(function_name(*function));
  for (const EntrySyntax& entry : scene.entries) {
    if (entry.name != "functions") continue;
    for (const KeySyntax& key : entry.keys) {
      if (std::ranges::find(names, key.key) == names.end()) {
        context.report.add(Reason::unknown_function_key, key.key_span,
                           "unknown function " + quote_text(key.key), suggestion(key.key, names));
      } else {
        context.function_replacements[key.key] = {&key.value, true};
      }
    }
  }
}

void replace_by_sample(Context& context, const EntrySyntax& function) {
  const std::string name = function_name(function);
  if (name.empty() || context.function_replacements.count(name) > 0) return;
  const KeySyntax* sample = function.find("sample");
  if (sample == nullptr) {
    context.report.add(Code::E633, function.find("name")->value.span,
                       quote_text(name) + " is left open, but a run needs its values",
                       "give it a `sample`, or an expression in `[functions]` of a scene");
    return;
  }
  context.function_replacements[name] = {&sample->value, false};
  context.report.add(Code::E634, sample->value.span,
                     quote_text(name) + " is " + in_backticks(sample->value.span) +
                         " here, which is its `sample`");
}

/// Argument indices of the first and second derivatives of a function of n arguments, in the order
/// of declaration.
std::vector<std::vector<std::uint32_t>> derivative_indices(std::uint32_t n) {
  std::vector<std::vector<std::uint32_t>> all;
  for (std::uint32_t i = 0; i < n; ++i) all.push_back({i});
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = i; j < n; ++j) all.push_back({i, j});
  }
  return all;
}

/// "V_12"
std::string derivative_name(const std::string& function, const std::vector<std::uint32_t>& by) {
  std::string name = function + "_";
  for (const std::uint32_t argument : by) name += std::to_string(argument + 1);
  return name;
}

/// The number of arguments in the key `of`, at most max_open_arguments.
std::uint32_t argument_count(const EntrySyntax& entry) {
  const KeySyntax* of = entry.find("of");
  const std::size_t given = of == nullptr ? 0 : of->value.items.size();
  return static_cast<std::uint32_t>(std::min(given, max_open_arguments));
}

std::uint32_t append_open_value(Model& model, std::string name, std::uint32_t function,
                                std::vector<std::uint32_t> by) {
  OpenValue value;
  value.identifier = name;
  value.name = std::move(name);
  value.function = function;
  value.derivative_arguments = std::move(by);
  model.open_values.push_back(std::move(value));
  return static_cast<std::uint32_t>(model.open_values.size() - 1);
}

bool names_closed_derivative(const Context& context, const ExpressionSyntax& expression) {
  if (expression.kind == SyntaxKind::name) {
    const DeclaredName* symbol = context.symbols.find(expression.text);
    if (symbol != nullptr && symbol->kind == SymbolKind::closed_derivative) return true;
  }
  return std::ranges::any_of(expression.operands, [&](const ExpressionSyntax& operand) {
    return names_closed_derivative(context, operand);
  });
}

/// A coordinate, a rate or the time.
using VariableId = std::pair<Opcode, std::uint32_t>;

void add_rates(const Model& model, const Expression& differentiated, std::set<VariableId>& all) {
  for (const ExpressionId id : reachable_expressions(model, differentiated.operands)) {
    const Expression& e = model.expressions[id];
    if (!is_leaf(e, Opcode::coordinate)) continue;
    all.insert({Opcode::velocity, model.coordinates[e.index].velocity});
  }
}

/// The variables on which the expression `root` depends. For d/dt e, these are the rates of the
/// coordinates in e and, if `include_rate_arguments`, the coordinates in e: d/dt x^2 depends on x,
/// but d/dt x does not.
std::set<VariableId> find_dependencies(const Model& model, ExpressionId root,
                                       bool include_rate_arguments) {
  constexpr LeafSet kinds = Opcode::coordinate | Opcode::velocity | Opcode::time;
  std::set<VariableId> all;
  std::set<ExpressionId> seen;
  std::vector<ExpressionId> left{root};
  while (!left.empty()) {
    const ExpressionId id = left.back();
    left.pop_back();
    if (!seen.insert(id).second) continue;
    const Expression& e = model.expressions[id];
    const bool is_rate = e.kind == ExpressionKind::time_derivative;
    if (e.kind == ExpressionKind::leaf && kinds.has_any(e.leaf)) all.insert({e.leaf, e.index});
    if (is_rate) add_rates(model, e, all);
    if (is_rate && !include_rate_arguments) continue;
    for (const ExpressionId part : references(model, id)) left.push_back(part);
  }
  return all;
}

}  // namespace

std::string function_name(const EntrySyntax& function) {
  const KeySyntax* name = function.find("name");
  return name == nullptr ? "" : name->value.expression.text;
}

void read_function_replacements(Context& context, const FileSyntax& model, const FileSyntax* scene,
                                const SceneOptions& options) {
  if (scene != nullptr) replace_by_scene(context, model, *scene);
  if (!options.purpose.samples_open_functions) return;
  for (const EntrySyntax* function : functions_of(model)) replace_by_sample(context, *function);
}

const FunctionReplacement* find_function_replacement(const Context& context,
                                                     const EntrySyntax& function) {
  const auto found = context.function_replacements.find(function_name(function));
  return found == context.function_replacements.end() ? nullptr : &found->second;
}

std::optional<std::uint32_t> declare_function(Context& context, const EntrySyntax& entry,
                                              const NewName& name) {
  if (name.index) {
    context.report.add(Code::E205, name.span,
                       quote_text(name.text()) + " has an index, but an open function has none");
    context.symbols.mark_failed(name.base);
    return std::nullopt;
  }
  const bool is_closed = find_function_replacement(context, entry) != nullptr;
  Model& model = context.model;
  const std::uint32_t target = is_closed ? append_row<&Model::definitions>(model, entry, name)
                                         : append_row<&Model::functions>(model, entry, name);
  if (!is_closed) model.functions[target].arguments = {no_expression};
  const auto declare = [&](const std::string& text, SymbolKind kind, std::uint32_t number) {
    return context.symbols.declare({text, {}, name.span}, kind, number, context.report);
  };
  const std::uint32_t number = is_closed ? target : append_open_value(model, name.base, target, {});
  bool is_declared =
      declare(name.base, is_closed ? SymbolKind::definition : SymbolKind::open_value, number);
  for (const std::vector<std::uint32_t>& by : derivative_indices(argument_count(entry))) {
    const std::string text = derivative_name(name.base, by);
    // A refused function is reported once; its derivatives are not reported as unknown names.
    if (!is_declared) context.symbols.mark_failed(text);
    is_declared = is_declared && (is_closed ? declare(text, SymbolKind::closed_derivative, 0)
                                            : declare(text, SymbolKind::open_derivative,
                                                      append_open_value(model, text, target, by)));
  }
  if (!is_declared) return std::nullopt;
  return target;
}

void check_function_expressions(Context& context) {
  const Model& model = context.model;
  for (const auto& [name, function] : context.function_expressions) {
    std::set<VariableId> known;
    for (const ExpressionId argument : function.arguments) {
      known.merge(find_dependencies(model, argument, true));
    }
    const Span& span = model.expressions[function.value].span;
    for (const VariableId& read : find_dependencies(model, function.value, false)) {
      if (known.count(read) > 0 || function.arguments.empty()) continue;
      context.report.add(Code::E319, span,
                         in_backticks(span) + " depends on " +
                             quote_text(leaf_text(model, read.first, read.second)) +
                             ", but no argument of " + quote_text(name) + " does",
                         "`of` lists every argument of the function");
    }
  }
}

bool uses_closed_derivative(const Context& context, const ValueSyntax& value) {
  return names_closed_derivative(context, value.expression) ||
         std::ranges::any_of(
             value.items,
             [&](const ValueSyntax& item) { return uses_closed_derivative(context, item); }) ||
         std::ranges::any_of(value.entries, [&](const KeySyntax& key) {
           return uses_closed_derivative(context, key.value);
         });
}

}  // namespace elgen
