// Model expressions -> GiNaC over definitions. Operands and named references are translated before
// the expression that uses them.
#include "derive/formulate/expressions.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "elgen/lagrangian.hpp"
#include "elgen/references.hpp"
#include "numbers/enclosed_number.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// An expression above this size becomes a definition. This keeps GiNaC's derivatives of one value
/// and the products of the chain rule small. The limit is large enough to keep `l*sin(q1 + q2)` in
/// one expression.
constexpr unsigned largest_inline_size = 10;

constexpr std::array<const char*, 3> axes{"_x", "_y", "_z"};

ex to_ginac(const cln::cl_RA& value) { return GiNaC::numeric(value); }

/// GiNaC's functions under their names in the table of functions. The namespace separates them from
/// functions of the same names that compute numbers.
namespace ginac_calls {

using GiNaC::sqrt;
#define ELGEN_WRAPPER_1(name) \
  ex name(const ex& x) { return elgen_##name(x); }
#define ELGEN_WRAPPER_2(name) \
  ex name(const ex& x, const ex& y) { return elgen_##name(x, y); }
#define ELGEN_FUNCTION(name, arity) using GiNaC::name;
#define ELGEN_STANDARD_FUNCTION(name, arity) ELGEN_WRAPPER_##arity(name)
#define ELGEN_OWN_FUNCTION(name, arity) ELGEN_WRAPPER_##arity(name)
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
#undef ELGEN_WRAPPER_1
#undef ELGEN_WRAPPER_2

ex call(FunctionId function, const ex& x, const ex& y) {
  switch (function) {
#define ELGEN_CALL_1(name) name(x)
#define ELGEN_CALL_2(name) name(x, y)
#define ELGEN_FUNCTION(name, arity) \
  case FunctionId::name:            \
    return ELGEN_CALL_##arity(name);
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
#undef ELGEN_CALL_1
#undef ELGEN_CALL_2
  }
  return 0;
}

/// The derivative of a function with respect to x (`argument` = 0) or y (`argument` = 1). check()
/// allows functions with kinks only in forces, which are not differentiated; so a kinked function
/// here is an internal error.
ex slope(FunctionId function, const ex& x, const ex& y, unsigned argument) {
  if (is_kinked(function)) throw std::logic_error("derivative of a kinked function");
  const ex f = call(function, x, y);
  const ex one = 1;
  switch (function) {
#define ELGEN_DERIVATIVES(name, arity, first, second) \
  case FunctionId::name:                              \
    return argument == 0 ? ex(first) : ex(second);
#include "base/function_derivatives.def"
#undef ELGEN_DERIVATIVES
  }
  return 0;
}

}  // namespace ginac_calls

template <FunctionId function>
ex slope_1(const ex& x, unsigned argument) {
  return ginac_calls::slope(function, x, x, argument);
}
template <FunctionId function>
ex slope_2(const ex& x, const ex& y, unsigned argument) {
  return ginac_calls::slope(function, x, y, argument);
}

/// The exact value of a call with rational arguments, if it is known; else `held`, the call itself.
/// Calls with kinks are not evaluated here, because Graph evaluates them.
ex evaluate_exactly(FunctionId function, const ex& x, const ex& y, const ex& held) {
  const bool is_known = x.info(GiNaC::info_flags::rational) && y.info(GiNaC::info_flags::rational);
  if (is_kinked(function) || !is_known) return held;
  const auto exact = [](const ex& operand) {
    return cln::the<cln::cl_RA>(GiNaC::ex_to<GiNaC::numeric>(operand).to_cl_N());
  };
  const auto value = exact_function_value(function, exact(x), exact(y));
  return value ? to_ginac(*value) : held;
}

#define ELGEN_EVALUATED_1(name)                                              \
  ex evaluated_##name(const ex& x) {                                         \
    return evaluate_exactly(FunctionId::name, x, x, elgen_##name(x).hold()); \
  }
#define ELGEN_EVALUATED_2(name)                                                 \
  ex evaluated_##name(const ex& x, const ex& y) {                               \
    return evaluate_exactly(FunctionId::name, x, y, elgen_##name(x, y).hold()); \
  }
#define ELGEN_FUNCTION(name, arity)
#define ELGEN_STANDARD_FUNCTION(name, arity) ELGEN_EVALUATED_##arity(name)
#define ELGEN_OWN_FUNCTION(name, arity) ELGEN_EVALUATED_##arity(name)
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
#undef ELGEN_EVALUATED_1
#undef ELGEN_EVALUATED_2

/// Inserts a digit into ascending digits: (1, 2) -> 12 and (2, 1) -> 12. Digit k stands for one
/// differentiation with respect to argument k.
int insert_digit(int digits, int digit) {
  const int last = digits % 10;
  return last <= digit ? digits * 10 + digit : insert_digit(digits / 10, digit) * 10 + last;
}

int to_integer(const ex& number) { return GiNaC::ex_to<GiNaC::numeric>(number).to_int(); }

// The first three operands are numbers, so GiNaC calls this only for the other operands.
// NOLINTNEXTLINE(readability-function-size): GiNaC passes every operand by itself.
ex open_slope(const ex& first, const ex& count, const ex& digits, const ex& x1, const ex& x2,
              const ex& x3, const ex& x4, unsigned operand) {
  const int by = static_cast<int>(operand) - 2;
  return elgen_open(first, count, insert_digit(to_integer(digits), by), x1, x2, x3, x4);
}

}  // namespace

ExpressionTranslator::ExpressionTranslator(const Model& model, Lagrangian& lagrangian)
    : model_(model), lagrangian_(lagrangian), translated_values_(model.expressions.size()) {}

/// Translates the references of `id` before `id`. Iterative, because chains of references are long.
ex ExpressionTranslator::value(ExpressionId id) {
  if (!errors_.empty()) return 0;
  std::vector<ExpressionId> stack{id};
  const auto is_done = [this](ExpressionId each) { return translated_values_[each].size != 0; };
  while (!stack.empty()) {
    const ExpressionId next = stack.back();
    const std::size_t size = stack.size();
    const std::vector<ExpressionId> parts = references(model_, next);
    std::remove_copy_if(parts.rbegin(), parts.rend(), std::back_inserter(stack), is_done);
    if (stack.size() > size) continue;
    stack.pop_back();
    if (!is_done(next) && !translate(next)) return 0;
  }
  return translated_values_[id].value;
}

bool ExpressionTranslator::translate(ExpressionId id) {
  const auto refuse = [&](Code code, const std::string& what) {
    errors_.push_back({code, model_.expressions[id].span,
                       "`" + to_string(model_, id) + "` " + what + ", whatever the state is"});
    return false;
  };
  try {
    translated_values_[id] = define_if_large(translate_operation(model_.expressions[id]));
    return true;
  } catch (const GiNaC::pole_error&) {
    return refuse(Code::E312, "divides by zero");
  } catch (const std::domain_error&) {
    return refuse(Code::E313, "has no value");
  }
}

ex ExpressionTranslator::define_value(ExpressionId id, const std::string& name, Entity origin) {
  return define(lagrangian_.definitions, value(id), {name, origin});
}

ExVector3 ExpressionTranslator::define_vector(const Vector3& values, const std::string& name,
                                              Entity origin) {
  ExVector3 result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = define_value(values[i], name + axes[i], origin);
  return result;
}

ExpressionTranslator::SizedExpression ExpressionTranslator::define_if_large(
    const SizedExpression& sized) {
  if (sized.size <= largest_inline_size) return sized;
  return {define(lagrangian_.definitions, sized.value), 1};
}

ExpressionTranslator::SizedExpression ExpressionTranslator::translate_leaf(
    const Expression& expression) const {
  if (expression.kind == ExpressionKind::number) return {to_ginac(expression.number), 1};
  if (expression.kind == ExpressionKind::pi) return {GiNaC::Pi, 1};
  return {leaf_of(lagrangian_.symbols, expression.leaf, expression.index), 1};
}

ExpressionTranslator::SizedExpression ExpressionTranslator::translate_operation(
    const Expression& expression) {
  const auto operand = [&](std::size_t i) { return translated_values_[expression.operands[i]]; };
  switch (expression.kind) {
    case ExpressionKind::negate:
      return {-operand(0).value, operand(0).size};
    case ExpressionKind::add:
      return translate_sum(expression.operands);
    case ExpressionKind::multiply:
      return translate_product(expression.operands);
    case ExpressionKind::divide:
      return {operand(0).value / operand(1).value, operand(0).size + operand(1).size + 1};
    case ExpressionKind::power:
      return {GiNaC::pow(operand(0).value, to_ginac(expression.number)), operand(0).size + 1};
    case ExpressionKind::function:
      return translate_call(expression);
    case ExpressionKind::time_derivative:
      return {define(lagrangian_.definitions, (*motion_rate_)(operand(0).value)), 1};
    case ExpressionKind::named:
      return define_component(expression);
    default:
      return is_leaf(expression, Opcode::open_value) ? translate_open_value(expression)
                                                     : translate_leaf(expression);
  }
}

/// A call of an open function. The size is 1 for any arguments, because lower imports the call as a
/// leaf without arguments.
ExpressionTranslator::SizedExpression ExpressionTranslator::translate_open_value(
    const Expression& expression) const {
  const OpenValue& value = model_.open_values[expression.index];
  std::array<ex, max_open_arguments> x{};
  for (std::size_t i = 0; i < expression.operands.size(); ++i) {
    x[i] = translated_values_[expression.operands[i]].value;
  }
  int digits = 0;
  for (const std::uint32_t argument : value.derivative_arguments) {
    digits = insert_digit(digits, static_cast<int>(argument) + 1);
  }
  const std::uint32_t first = find_open_value(model_, value.function, {}).value_or(0);
  const auto count = static_cast<unsigned>(expression.operands.size());
  return {elgen_open(first, count, digits, x[0], x[1], x[2], x[3]), 1};
}

ExpressionTranslator::SizedExpression ExpressionTranslator::translate_call(
    const Expression& expression) {
  const SizedExpression x = translated_values_[expression.operands[0]];
  const SizedExpression y = expression.operands.size() > 1
                                ? translated_values_[expression.operands[1]]
                                : SizedExpression{};
  return {ginac_calls::call(expression.function, x.value, y.value), x.size + y.size + 1};
}

/// Splits a long sum into a tree of short sums, so that each definition stays small.
ExpressionTranslator::SizedExpression ExpressionTranslator::translate_sum(
    const std::vector<ExpressionId>& operands) {
  std::vector<SizedExpression> terms;
  for (const ExpressionId id : operands) terms.push_back(translated_values_[id]);
  while (true) {
    std::vector<SizedExpression> shorter;
    SizedExpression group{0, 0};
    for (const SizedExpression& term : terms) {
      if (group.size != 0 && group.size + term.size > largest_inline_size) {
        shorter.push_back(group);
        group = {0, 0};
      }
      group = {group.value + term.value, group.size + term.size};
    }
    shorter.push_back(group);
    if (shorter.size() == 1) return shorter.front();
    for (SizedExpression& part : shorter) part = {define(lagrangian_.definitions, part.value), 1};
    terms = std::move(shorter);
  }
}

ExpressionTranslator::SizedExpression ExpressionTranslator::translate_product(
    const std::vector<ExpressionId>& operands) {
  SizedExpression result{1, 0};
  for (const ExpressionId id : operands) {
    const SizedExpression& factor = translated_values_[id];
    if (result.size != 0 && result.size + factor.size > largest_inline_size)
      result = define_if_large({result.value, largest_inline_size + 1});
    result = {result.value * factor.value, result.size + factor.size};
  }
  return result;
}

/// The definition of a named entry. The components of a frame `link` are named link_R11 …
/// (rotation), link_x … (origin), link_wx … (angular velocity in world axes) and link_spin_x …
/// (angular velocity in the axes of the frame).
ExpressionTranslator::SizedExpression ExpressionTranslator::define_component(
    const Expression& expression) {
  static constexpr std::array<const char*, components_per_frame> suffixes{
      "_R11", "_R12", "_R13", "_R21", "_R22", "_R23", "_R31",    "_R32",    "_R33",
      "_x",   "_y",   "_z",   "_wx",  "_wy",  "_wz",  "_spin_x", "_spin_y", "_spin_z"};
  const ExpressionId value = *value_of_name(model_, expression);
  const auto defined = [&](const std::string& name, Entity origin) {
    return SizedExpression{define_value(value, name, origin), 1};
  };
  const std::uint32_t i = expression.index;
  const std::uint32_t k = expression.component;
  switch (expression.named) {
    case NamedKind::definition:
      return defined(model_.definitions[i].identifier, {EntityKind::definition, i});
    case NamedKind::prescribed:
      return defined(model_.prescribed[i].identifier, {EntityKind::prescribed, i});
    case NamedKind::point:
      return defined(model_.points[i].identifier + axes[k], {EntityKind::point, i});
    case NamedKind::body:
      return defined(model_.bodies[i].identifier + axes[k], {EntityKind::body, i});
    case NamedKind::frame:
      break;
  }
  return defined(model_.frames[i].identifier + suffixes[k], {EntityKind::frame, i});
}

void ExpressionTranslator::define_named_entries() {
  motion_rate_.emplace(lagrangian_.definitions, motion_seeds(lagrangian_.symbols), "_dot");
  const auto define_rows = [&](const std::vector<NamedExpression>& rows, EntityKind kind) {
    for (std::uint32_t i = 0; i < rows.size(); ++i) {
      (void)define_value(rows[i].value, rows[i].identifier, {kind, i});
    }
  };
  define_rows(model_.definitions, EntityKind::definition);
  define_rows(model_.prescribed, EntityKind::prescribed);
  for (std::uint32_t i = 0; i < model_.points.size(); ++i) {
    const Point& point = model_.points[i];
    if (point.local && !model_.approximation) continue;
    (void)define_vector(point.position, point.identifier, {EntityKind::point, i});
  }
  for (const ExpressionId id :
       reachable_expressions(model_, filter_roots(model_, is_force_value))) {
    Expression entry = model_.expressions[id];
    if (!refers_to_entry(entry, NamedKind::frame)) continue;
    // The components of the pose: rotation and origin.
    for (entry.component = 0; entry.component < frame_angular_velocity; ++entry.component) {
      (void)define_component(entry);
    }
  }
}

std::optional<std::uint32_t> open_value_number(const ex& value) {
  const int first = to_integer(value.op(0));
  const int count = to_integer(value.op(1));
  const int digits = to_integer(value.op(2));
  // The leaves of a function V: V itself, the first derivatives V_1 to V_n, then the upper triangle
  // of the second derivatives, row by row.
  const int i = digits / 10;
  const int j = digits % 10;
  if (i >= 10) return std::nullopt;
  const int above = (i - 1) * count - (i - 1) * (i - 2) / 2;
  const int number = i == 0 ? first + j : first + count + above + j - i + 1;
  return static_cast<std::uint32_t>(number);
}

ex constant_value(const Model& model, ExpressionId value) {
  Lagrangian scratch;
  ExpressionTranslator translation(model, scratch);
  ex result = translation.value(value);
  if (!translation.errors().empty()) throw std::domain_error("the constant has no value");
  const std::vector<Definition>& parts = scratch.definitions.list;
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    result = result.subs(part->symbol == part->value);
  }
  return result;
}

REGISTER_FUNCTION(elgen_open, derivative_func(open_slope))
// GiNaC sorts calls by the order of registration, so the order of rows in the table determines the
// order of terms.
#define ELGEN_REGISTERED(name, arity) \
  REGISTER_FUNCTION(elgen_##name,     \
                    eval_func(evaluated_##name).derivative_func(slope_##arity<FunctionId::name>))
#define ELGEN_FUNCTION(name, arity)
#define ELGEN_STANDARD_FUNCTION ELGEN_REGISTERED
#define ELGEN_OWN_FUNCTION ELGEN_REGISTERED
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
#undef ELGEN_REGISTERED

}  // namespace elgen
