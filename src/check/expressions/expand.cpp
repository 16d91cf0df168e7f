// Expansion: declares all names first, then lists the instances whose expressions are still to be
// resolved.
#include "check/expressions/expand.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "check/expressions/open_functions.hpp"
#include "check/expressions/parameters.hpp"
#include "check/expressions/rotations.hpp"
#include "check/expressions/values.hpp"
#include "check/expressions/wrench_input.hpp"

namespace elgen {
namespace {

/// An array of tables; `add` appends the row of an entry to the Model.
struct EntryDeclarationRule {
  std::string_view entry;
  SymbolKind kind;
  std::uint32_t (*add)(Model& model, const EntrySyntax& entry, const NewName& name);
};

constexpr std::array<EntryDeclarationRule, 11> entry_kinds{{
    {"coordinate", SymbolKind::coordinate,
     [](Model& model, const EntrySyntax& entry, const NewName& name) {
       return append_coordinate(model, make_row<Coordinate>(entry, name));
     }},
    {"function", SymbolKind::open_value, nullptr},  // declare_function() adds the row
    {"prescribed", SymbolKind::prescribed, append_row<&Model::prescribed>},
    {"point", SymbolKind::point, append_row<&Model::points>},
    {"frame", SymbolKind::frame, append_row<&Model::frames>},
    {"body", SymbolKind::body, append_row<&Model::bodies>},
    {"input", SymbolKind::input, append_row<&Model::inputs>},
    {"force", SymbolKind::force, append_row<&Model::forces>},
    {"output", SymbolKind::output, append_row<&Model::outputs>},
    {"constraint", SymbolKind::constraint, append_row<&Model::constraints>},
    {"equilibrium", SymbolKind::equilibrium, append_row<&Model::equilibria>},
}};

const EntryDeclarationRule* find_declaration_rule(std::string_view entry) {
  const auto found = std::ranges::find(entry_kinds, entry, &EntryDeclarationRule::entry);
  return found == entry_kinds.end() ? nullptr : &*found;
}

/// The namespace in which a name of this kind must be unique.
SymbolTable& namespace_of(Context& context, SymbolKind kind) {
  if (kind == SymbolKind::frame) return context.frames;
  return kind == SymbolKind::equilibrium ? context.equilibria : context.symbols;
}

/// Sets the dimension of a point to 2 if `at` has two components, before expressions are resolved.
void set_point_dimension(Model& model, const EntrySyntax& entry, std::uint32_t point) {
  const KeySyntax* at = entry.find("at");
  if (at != nullptr && at->value.items.size() == 2) model.points[point].dimension = 2;
}

class EntryExpander {
 public:
  explicit EntryExpander(Context& context) : context_(context) {}

  void expand_entry(const EntrySyntax& entry) {
    const EntryDeclarationRule* kind = find_declaration_rule(entry.name);
    if (kind == nullptr) return;
    const KeySyntax* repetition = entry.find("for");
    IndexScope scope(context_.sizes);
    if (repetition == nullptr) {
      add_instance(entry, *kind, scope);
      return;
    }
    const std::vector<RangeSyntax> ranges = read_repetition(repetition->value);
    const bool complete = for_each_index_tuple(ranges, scope, context_.report,
                                               [&] { return add_instance(entry, *kind, scope); });
    const KeySyntax* name = entry.find("name");
    if (!complete && name != nullptr) {
      context_.symbols.mark_failed(name->value.expression.text);
      context_.frames.mark_failed(name->value.expression.text);
    }
  }

  void declare_definition(const KeySyntax& key) {
    if (!count_instance(SymbolKind::definition, key.key_span)) return;
    std::vector<NamedExpression>& definitions = context_.model.definitions;
    const auto target = static_cast<std::uint32_t>(definitions.size());
    const NewName name{key.key, {}, key.key_span};
    if (context_.symbols.declare(name, SymbolKind::definition, target, context_.report)) {
      definitions.push_back(make_row<NamedExpression>({}, name));
    }
  }

  std::vector<EntryInstance> take_instances() { return std::move(instances_); }

 private:
  /// Counts one instance. False after E906 or E907, if a limit is exceeded.
  bool count_instance(SymbolKind kind, const Span& span) {
    const bool is_coordinate = kind == SymbolKind::coordinate;
    const std::uint64_t limit =
        is_coordinate ? context_.limits.coordinates : context_.limits.definitions;
    if (++(is_coordinate ? coordinates_ : definitions_) <= limit) return true;
    if (!std::exchange(context_.is_beyond_limits, true)) {
      context_.report.add(is_coordinate ? Code::E906 : Code::E907, span,
                          "more than " + std::to_string(limit) +
                              (is_coordinate ? " coordinates" : " entries after repetition"));
    }
    return false;
  }

  /// Adds one instance of an entry. False if the expansion should stop.
  bool add_instance(const EntrySyntax& entry, const EntryDeclarationRule& kind,
                    const IndexScope& scope) {
    NewName name;
    name.span = entry.span;
    const KeySyntax* key = entry.find("name");
    if (key != nullptr && !read_new_name(key->value, scope, name)) return false;
    if (!count_instance(kind.kind, name.span)) return false;
    if (is_rotation(entry)) {
      return add_declared_instance(entry, scope, declare_rotation(context_, entry, name));
    }
    if (is_wrench_input(entry)) {
      return add_declared_instance(entry, scope, declare_wrench_input(context_, entry, name));
    }
    if (kind.kind == SymbolKind::open_value) {
      return add_declared_instance(entry, scope, declare_function(context_, entry, name));
    }
    const std::uint32_t target = kind.add(context_.model, entry, name);
    if (kind.kind == SymbolKind::point) set_point_dimension(context_.model, entry, target);
    instances_.push_back({&entry, scope, target});
    return key == nullptr ||
           namespace_of(context_, kind.kind).declare(name, kind.kind, target, context_.report);
  }

  /// Adds the instance `target` of an entry whose names are declared; false if the declaration
  /// failed and `target` is none.
  bool add_declared_instance(const EntrySyntax& entry, const IndexScope& scope,
                             const std::optional<std::uint32_t>& target) {
    if (target) {
      instances_.push_back({&entry, scope, *target});
    }
    return target.has_value();
  }

  bool read_new_name(const ValueSyntax& value, const IndexScope& scope, NewName& name) {
    name.base = value.expression.text;
    name.span = value.span;
    if (value.expression.operands.empty()) return true;
    name.index = evaluate_integer(value.expression.operands.front(), scope, context_.report);
    return name.index.has_value();
  }

  Context& context_;
  std::vector<EntryInstance> instances_;
  std::uint64_t coordinates_ = 0;
  std::uint64_t definitions_ = 0;  ///< all instances except coordinates
};

/// Reports E203 for a running index that would hide a name of the model.
void check_indices(Context& context, const EntrySyntax& entry) {
  const KeySyntax* repetition = entry.find("for");
  if (repetition == nullptr) return;
  for (const RangeSyntax& range : read_repetition(repetition->value)) {
    if (const DeclaredName* symbol = context.symbols.find(range.index)) {
      context.report.add({Code::E203, range.index_span,
                          "the running index " + quote_text(range.index) + " is also " +
                              with_article(symbol_noun(symbol->kind)),
                          "", symbol->span, "declared here"});
    }
  }
}

}  // namespace

std::vector<EntryInstance> expand_entries(Context& context, const FileSyntax& syntax) {
  EntryExpander expander(context);
  for (const EntrySyntax& entry : syntax.entries) {
    for (const KeySyntax& key : entry.keys) {
      if (entry.name == "parameters") {
        declare_parameter(context, key);
      } else if (entry.name == "define") {
        expander.declare_definition(key);
      }
    }
    expander.expand_entry(entry);
  }
  // Indices are checked last, because now all names are known.
  for (const EntrySyntax& entry : syntax.entries) check_indices(context, entry);
  return expander.take_instances();
}

}  // namespace elgen
