// Model expressions -> GiNaC over definitions. The arena lists operands before their users, so no
// recursion is needed: the operands an expression needs are translated in ascending order.
#include "formulate/expressions.hpp"

#include <algorithm>
#include <stdexcept>
#include <unordered_set>

#include "formulate/entities.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// Written-out size from which a part is named: small enough that GiNaC's derivative of one value,
/// and the products of the chain rule, stay small; large enough that `l*sin(q1 + q2)` stays in one
/// piece.
constexpr unsigned largest_inline_size = 10;

ex number(const cln::cl_RA& value) { return GiNaC::numeric(value); }

// Of these GiNaC has no kinked ones.
ex abs(const ex& x) { return elgen_abs(x); }
ex sign(const ex& x) { return elgen_sign(x); }
ex min(const ex& x, const ex& y) { return elgen_min(x, y); }
ex max(const ex& x, const ex& y) { return elgen_max(x, y); }

ex call(FunctionId function, const ex& x, const ex& y) {
  using GiNaC::sin, GiNaC::cos, GiNaC::tan, GiNaC::asin, GiNaC::acos, GiNaC::atan, GiNaC::atan2;
  using GiNaC::sinh, GiNaC::cosh, GiNaC::tanh, GiNaC::exp, GiNaC::log;
  switch (function) {
#define ELGEN_CALL_1(name) name(x)
#define ELGEN_CALL_2(name) name(x, y)
#define ELGEN_FUNCTION(name, arity, use, parity, first, second) \
  case FunctionId::name:                                        \
    return ELGEN_CALL_##arity(name);
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
#undef ELGEN_CALL_1
#undef ELGEN_CALL_2
  }
  return 0;
}

/// entities_in_order() knows everything that is translated.
const ex& defined(const std::optional<ex>& value) {
  if (!value) throw std::logic_error("a named thing of the model is used before it is defined");
  return *value;
}

}  // namespace

Translation::Translation(const Model& model, Lagrangian& lagrangian)
    : model_(model),
      lagrangian_(lagrangian),
      translated_(model.expressions.size()),
      definitions_(model.definitions.size()),
      prescribed_(model.prescribed.size()),
      points_(model.points.size()),
      frames_(model.frames.size()) {}

Result<ex> Translation::operator()(ExpressionId value) {
  std::vector<ExpressionId> needed;
  std::unordered_set<ExpressionId> seen;
  std::vector<ExpressionId> stack{value};
  while (!stack.empty()) {
    const ExpressionId id = stack.back();
    stack.pop_back();
    if (translated_[id].size != 0 || !seen.insert(id).second) continue;
    needed.push_back(id);
    const auto& operands = model_.expressions[id].operands;
    stack.insert(stack.end(), operands.begin(), operands.end());
  }
  std::sort(needed.begin(), needed.end());
  for (const ExpressionId id : needed) {
    try {
      translate(id);
    } catch (const GiNaC::pole_error&) {
      return Diagnostic{Code::E312, model_.expressions[id].span,
                        "`" + to_string(model_, id) + "` divides by zero, whatever the state is"};
    } catch (const std::domain_error&) {
      return Diagnostic{Code::E313, model_.expressions[id].span,
                        "`" + to_string(model_, id) + "` has no value, whatever the state is"};
    }
  }
  return translated_[value].value;
}

ex Translation::value(ExpressionId id) {
  Result<ex> value = (*this)(id);
  if (value) return *value;
  errors_.insert(errors_.end(), value.diagnostics.begin(), value.diagnostics.end());
  return 0;
}

ex Translation::named(ExpressionId id, const std::string& name, Entity origin) {
  return define(lagrangian_.definitions, value(id), {name, origin});
}

ExVector3 Translation::vector(const Vector3& values, const std::string& name, Entity origin) {
  static constexpr std::array<const char*, 3> axes{"_x", "_y", "_z"};
  ExVector3 result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = named(values[i], name + axes[i], origin);
  return result;
}

void Translation::translate(ExpressionId id) {
  if (translated_[id].size != 0) return;
  translated_[id] = small(compose(model_.expressions[id]));
}

Translation::Sized Translation::small(const Sized& sized) {
  if (sized.size <= largest_inline_size) return sized;
  return {define(lagrangian_.definitions, sized.value), 1};
}

Translation::Sized Translation::leaf(const Expression& expression) const {
  const Symbols& symbols = lagrangian_.symbols;
  switch (expression.kind) {
    case ExpressionKind::number:
      return {number(expression.number), 1};
    case ExpressionKind::pi:
      return {GiNaC::Pi, 1};
    case ExpressionKind::time:
      return {symbols.t, 1};
    case ExpressionKind::coordinate:
      return {symbols.q[expression.index], 1};
    case ExpressionKind::rate:
      return {symbols.v[expression.index], 1};
    case ExpressionKind::acceleration:
      return {symbols.a[expression.index], 1};
    case ExpressionKind::input:
      return {symbols.u[expression.index], 1};
    case ExpressionKind::parameter:
      return {symbols.parameters[expression.index], 1};
    case ExpressionKind::prescribed:
      return {defined(prescribed_[expression.index]), 1};
    case ExpressionKind::definition:
      return {defined(definitions_[expression.index]), 1};
    case ExpressionKind::frame_component:
      return {defined(frames_[expression.index / components_per_frame]
                             [expression.index % components_per_frame]),
              1};
    default:
      return {defined(points_[expression.index / 3][expression.index % 3]), 1};
  }
}

Translation::Sized Translation::compose(const Expression& expression) {
  const auto operand = [&](std::size_t i) { return translated_[expression.operands[i]]; };
  switch (expression.kind) {
    case ExpressionKind::negate:
      return {-operand(0).value, operand(0).size};
    case ExpressionKind::add:
      return sum(expression.operands);
    case ExpressionKind::multiply:
      return product(expression.operands);
    case ExpressionKind::divide:
      return {operand(0).value / operand(1).value, operand(0).size + operand(1).size + 1};
    case ExpressionKind::power:
      return {GiNaC::pow(operand(0).value, number(expression.number)), operand(0).size + 1};
    case ExpressionKind::function:
      return function(expression);
    case ExpressionKind::time_derivative:
      return {define(lagrangian_.definitions, (*along_motion_)(operand(0).value)), 1};
    default:
      return leaf(expression);
  }
}

Translation::Sized Translation::function(const Expression& expression) {
  const Sized x = translated_[expression.operands[0]];
  const Sized y = expression.operands.size() > 1 ? translated_[expression.operands[1]] : Sized{};
  return {call(expression.function, x.value, y.value), x.size + y.size + 1};
}

/// Long sums become a tree of short ones, so that each definition stays small.
Translation::Sized Translation::sum(const std::vector<ExpressionId>& operands) {
  std::vector<Sized> terms;
  for (const ExpressionId id : operands) terms.push_back(translated_[id]);
  while (true) {
    std::vector<Sized> shorter;
    Sized group{0, 0};
    for (const Sized& term : terms) {
      if (group.size != 0 && group.size + term.size > largest_inline_size) {
        shorter.push_back(group);
        group = {0, 0};
      }
      group = {group.value + term.value, group.size + term.size};
    }
    shorter.push_back(group);
    if (shorter.size() == 1) return shorter.front();
    for (Sized& part : shorter) part = {define(lagrangian_.definitions, part.value), 1};
    terms = std::move(shorter);
  }
}

Translation::Sized Translation::product(const std::vector<ExpressionId>& operands) {
  Sized result{1, 0};
  for (const ExpressionId id : operands) {
    const Sized& factor = translated_[id];
    if (result.size != 0 && result.size + factor.size > largest_inline_size)
      result = small({result.value, largest_inline_size + 1});
    result = {result.value * factor.value, result.size + factor.size};
  }
  return result;
}

Diagnostics Translation::define_named() {
  along_motion_.emplace(lagrangian_.definitions, motion_seeds(lagrangian_.symbols), "_dot");
  for (const Entity& entity : entities_in_order(model_)) {
    Diagnostics errors = define_entity(entity);
    if (!errors.empty()) return errors;
  }
  return {};
}

Diagnostics Translation::define_point(std::uint32_t index) {
  static constexpr std::array<const char*, 3> axes{"_x", "_y", "_z"};
  const Point& point = model_.points[index];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Result<ex> value = (*this)(point.at[axis]);
    if (!value) return value.diagnostics;
    points_[index][axis] = define(lagrangian_.definitions, *value,
                                  {point.identifier + axes[axis], {EntityKind::point, index}});
  }
  return {};
}

/// R as link_R11 …, the origin as link_x …
Diagnostics Translation::define_frame(std::uint32_t index) {
  static constexpr std::array<const char*, components_per_frame> suffixes{
      "_R11", "_R12", "_R13", "_R21", "_R22", "_R23", "_R31", "_R32", "_R33", "_x", "_y", "_z"};
  const std::string& name = model_.frames[index].identifier;
  for (std::uint32_t k = 0; k < components_per_frame; ++k) {
    const Result<ex> value = (*this)(component_of_frame(model_, components_per_frame * index + k));
    if (!value) return value.diagnostics;
    frames_[index][k] =
        define(lagrangian_.definitions, *value, {name + suffixes[k], {EntityKind::frame, index}});
  }
  return {};
}

Diagnostics Translation::define_entity(const Entity& entity) {
  if (entity.kind == EntityKind::point) return define_point(entity.index);
  if (entity.kind == EntityKind::frame) return define_frame(entity.index);
  const bool is_definition = entity.kind == EntityKind::definition;
  const NamedExpression& named =
      (is_definition ? model_.definitions : model_.prescribed)[entity.index];
  const Result<ex> value = (*this)(named.value);
  if (!value) return value.diagnostics;
  (is_definition ? definitions_ : prescribed_)[entity.index] =
      define(lagrangian_.definitions, *value, {named.identifier, entity});
  return {};
}

ex constant_value(const Model& model, ExpressionId value) {
  Lagrangian scratch;
  const Result<ex> translated = Translation(model, scratch)(value);
  if (!translated) throw std::domain_error("the constant has no value");
  ex result = *translated;
  const std::vector<Definition>& parts = scratch.definitions.list;
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    result = result.subs(part->symbol == part->value);
  }
  return result;
}

}  // namespace elgen
