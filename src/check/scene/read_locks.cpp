// Locks: `[lock] NAME = { value, reaction }`, NAME a coordinate ("q[2]") or a rotation.
#include "check/scene/read_locks.hpp"

#include <algorithm>

#include "check/expressions/node_builder.hpp"
#include "check/expressions/places.hpp"
#include "check/expressions/values.hpp"

namespace elgen {
namespace {

template <class List>
auto find_named(const List& list, std::string_view name) {
  return std::find_if(list.begin(), list.end(), [&](const auto& row) { return row.name == name; });
}

class LockReader {
 public:
  explicit LockReader(Context& context)
      : context_(context), values_(context, Scope(context.sizes)) {}

  void read(const KeySyntax& key) {
    const Model& model = context_.model;
    const KeySyntax* value = key.value.find("value");
    const KeySyntax* reaction = key.value.find("reaction");
    if (value == nullptr) return;  // reported when the file was parsed
    Lock lock;
    lock.span = key.key_span;
    lock.reaction = reaction != nullptr && reaction->value.boolean;
    if (const auto rotation = find_named(model.rotations, key.key);
        rotation != model.rotations.end()) {
      lock.coordinate = rotation->first_coordinate;
      lock.velocity = rotation->first_velocity;
      lock.is_rotation = true;
      lock.values = quaternion(value->value);
    } else if (const auto coordinate = find_named(model.coordinates, key.key);
               coordinate != model.coordinates.end() && !coordinate->rotation) {
      lock.coordinate = static_cast<std::uint32_t>(coordinate - model.coordinates.begin());
      lock.velocity = coordinate->velocity;
      lock.values = {function_of_time(value->value, *coordinate)};
    } else {
      report_unknown(key);
      return;
    }
    context_.model.locks.push_back(std::move(lock));
  }

 private:
  ExpressionId function_of_time(const ValueSyntax& value, const Coordinate& coordinate) {
    if (value.kind == ValueKind::list) {
      context_.report.add({Code::E615, value.span, "a list, but the coordinate is one number", "",
                           coordinate.span, in_backticks(coordinate.name) + " is declared here"});
      return no_expression;
    }
    const Place place{"the value of a lock", place::of_time};
    return values_.scene_value(value, {place, coordinate.unit});
  }

  /// Scaled to length 1: every stage may rely on it.
  std::vector<ExpressionId> quaternion(const ValueSyntax& value) {
    std::vector<ExpressionId> components(quaternion_size, no_expression);
    if (value.kind != ValueKind::list || value.items.size() != quaternion_size) {
      refuse(value.span, in_backticks(value.span) + " is not a quaternion [w, x, y, z]");
      return components;
    }
    bool is_zero = true;
    for (std::size_t i = 0; i < quaternion_size; ++i) {
      const auto number = values_.constant(value.items[i]);
      if (!number) return components;
      is_zero = is_zero && cln::zerop(*number);
      components[i] = values_.root(value.items[i], {{"a quaternion", place::constants_only}});
    }
    if (is_zero) {
      refuse(value.span, "a quaternion of length 0 has no direction");
      return components;
    }
    NodeBuilder nodes(context_, value.span);
    std::vector<ExpressionId> squares;
    for (const ExpressionId component : components) {
      squares.push_back(nodes.power(component, 2));
    }
    const ExpressionId length = nodes.power(nodes.add(squares), cln::cl_RA(1) / 2);
    for (ExpressionId& component : components) component = nodes.divide(component, length);
    return components;
  }

  void report_unknown(const KeySyntax& key) {
    const DeclaredNames& symbols = context_.symbols;
    const DeclaredName* symbol = symbols.find(key.key);
    if (symbol != nullptr && symbol->kind == SymbolKind::coordinate && symbol->is_array) {
      context_.report.add(
          Code::E208, key.key_span,
          in_backticks(key.key) + " needs an index: " + elements_of(key.key, *symbol));
      return;
    }
    context_.report.add(
        Code::E612, key.key_span, "unknown coordinate " + in_backticks(key.key),
        symbols.suggest(key.key, symbols.names({SymbolKind::coordinate, SymbolKind::rotation})));
  }

  void refuse(const Span& span, const std::string& message) {
    context_.report.add(Code::E615, span, message);
  }

  Context& context_;
  ValueReader values_;
};

std::size_t locked_velocities(const Model& model) {
  std::size_t count = 0;
  for (const Lock& lock : model.locks) count += lock.velocity_count();
  return count;
}

}  // namespace

void read_locks(Context& context, const FileSyntax* scene) {
  const EntrySyntax* entry = find_entry(scene, "lock");
  if (entry == nullptr) return;
  LockReader reader(context);
  for (const KeySyntax& key : entry->keys) reader.read(key);
  std::vector<Lock>& locks = context.model.locks;
  std::sort(locks.begin(), locks.end(),
            [](const Lock& a, const Lock& b) { return a.velocity < b.velocity; });
  if (!locks.empty() && locked_velocities(context.model) == context.model.velocities.size()) {
    context.report.add(Code::E615, entry->span, "every coordinate is locked, so nothing moves");
  }
}

}  // namespace elgen
