// Context: state that the readers and checks of this folder share while a Model is being built.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/report.hpp"
#include "check/names/constants.hpp"
#include "check/names/integers.hpp"
#include "check/names/symbols.hpp"
#include "elgen/limits.hpp"
#include "elgen/model.hpp"
#include "elgen/syntax.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {

/// Each ingredient of an expression is one bit: first the kinds of leaves, then other properties.
[[nodiscard]] constexpr std::uint32_t ingredient_bit(LeafKind kind) {
  return std::uint32_t{1} << static_cast<unsigned>(kind);
}
[[nodiscard]] constexpr std::uint32_t other_ingredient_bit(unsigned number) {
  return std::uint32_t{1} << (leaf_kind_count + number);
}

enum Ingredient : std::uint32_t {
  uses_coordinate = ingredient_bit(LeafKind::coordinate),
  uses_rate = ingredient_bit(LeafKind::velocity),
  uses_acceleration = ingredient_bit(LeafKind::acceleration),
  uses_input = ingredient_bit(LeafKind::input),
  uses_time = ingredient_bit(LeafKind::time),
  uses_parameter = ingredient_bit(LeafKind::parameter),
  uses_open_function = ingredient_bit(LeafKind::open_value),
  uses_momentum = ingredient_bit(LeafKind::momentum),
  uses_energy = ingredient_bit(LeafKind::energy),  ///< the energy function
  uses_multiplier = ingredient_bit(LeafKind::multiplier),
  uses_kink = other_ingredient_bit(0),
  uses_open_rate = other_ingredient_bit(1),        ///< an open function of rates
  uses_open_derivative = other_ingredient_bit(2),  ///< a derivative or rate of an open function
};
using Ingredients = std::uint32_t;

/// The context of an expression in the file: the ingredients that the expression may have, and the
/// error for any other ingredient.
struct ExpressionRole {
  std::string_view noun;  ///< "a position"
  Ingredients allowed = 0;
  Code error_code = Code::E319;
  bool is_force = false;  ///< messages give the unit N*m, not J
};

/// One expression of the file: its nodes [first, value] in the arena, its place and its unit. Nodes
/// that check itself appends belong to no WrittenExpression, so their place and unit are not
/// checked.
struct WrittenExpression {
  ExpressionId first = 0;
  ExpressionId value = 0;
  ExpressionRole role = {};
  std::optional<Unit> unit = {};  ///< expected by the place; none: any unit
  bool has_forbidden_ingredient =
      false;                     ///< contains a forbidden ingredient; its unit is not checked
  bool is_in_role_unit = false;  ///< its numbers are in the unit of its place
};

/// The first node of every arena: the number 0. It replaces an absent value (the z of a planar
/// point) and an expression with an error. It is no root, so no error is ever reported about it.
inline constexpr ExpressionId no_expression = 0;

/// `min` and `max` of a parameter; either may be absent.
struct ParameterBounds {
  std::optional<cln::cl_R> minimum = {};
  std::optional<cln::cl_R> maximum = {};
};

/// The expression that replaces an open function.
struct FunctionReplacement {
  const ValueSyntax* value = nullptr;
  bool is_of_scene = false;  ///< false: the model's own sample
};

/// The arguments of a [[function]], and the expression of its sample or of the scene.
struct FunctionExpression {
  std::vector<ExpressionId> arguments = {};
  ExpressionId value = no_expression;
};

struct Context {
  explicit Context(const Limits& the_limits) : limits(the_limits) { (void)append_node({}); }

  /// Appends a node. An exact constant is folded to a number: 1/2 + 1/3 -> 5/6, sqrt(4) -> 2.
  /// Returns the failure of a constant that has no value.
  std::optional<ConstantFailure> append_node(Expression node) {
    std::vector<Expression>& arena = model.expressions;
    const Span span = node.span;
    arena.push_back(std::move(node));
    if (const auto failure = constants.evaluate_next(arena)) return failure;
    const std::optional<cln::cl_R> value = constants[last_node()];
    if (value && is_rational(*value)) {
      arena.back() = {.number = cln::the<cln::cl_RA>(*value), .span = span};
    }
    return std::nullopt;
  }

  [[nodiscard]] ExpressionId last_node() const {
    return static_cast<ExpressionId>(model.expressions.size() - 1);
  }

  /// Removes the nodes from index `size` on.
  void truncate(std::size_t size) {
    model.expressions.resize(size);
    constants.truncate(size);
  }

  const Limits& limits;
  Report report = {};
  Sizes sizes = {};
  SymbolTable symbols = {};
  SymbolTable frames = {};      ///< a separate namespace: a body may have the name of its frame
  SymbolTable equilibria = {};  ///< a separate namespace
  /// By function name.
  std::map<std::string, FunctionReplacement, std::less<>> function_replacements = {};
  /// By function name.
  std::map<std::string, FunctionExpression, std::less<>> function_expressions = {};
  Model model = {};
  ConstantValues constants = {};
  /// Largest number of nodes, and of steps to resolve one expression; beyond it E908.
  std::uint64_t node_limit = limits.derived_nodes;
  bool is_beyond_limits = false;  ///< after E906, E907 or E908: no more expressions are resolved
  bool has_units = true;          ///< the model declares a unit other than 1
  /// Number of components of most vectors of the model; without a majority, of the first vector.
  std::uint32_t dimension = 0;
  bool is_planar = false;     ///< most vectors have two components; known before the first is read
  Span model_span = {};       ///< the header `[model]`
  Span lagrangian_span = {};  ///< the key `L`
  std::vector<WrittenExpression> roots = {};
  std::vector<ParameterBounds> bounds = {};  ///< by parameter array
  /// Declared units, by prescribed function.
  std::vector<std::optional<Unit>> prescribed_units = {};
};

}  // namespace elgen
