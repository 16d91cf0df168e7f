// Context: what the parts of check share while a Model is being built.
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

/// The ingredients of an expression are bits: first the kinds of leaves, then the others.
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

/// Where an expression stands: what it may be made of, and which error says that it may not.
struct Place {
  std::string_view noun;  ///< "a position"
  Ingredients allowed = 0;
  Code otherwise = Code::E319;
  bool is_force = false;  ///< messages say N*m, not J
};

/// One expression of the file in the arena: the nodes [first, value], its place and its unit. Nodes
/// that check adds itself are in none of them: neither their place nor their units are judged.
struct WrittenExpression {
  ExpressionId first = 0;
  ExpressionId value = 0;
  Place place = {};
  std::optional<Unit> unit = {};  ///< that the place asks for; none: any
  bool misplaced = false;      ///< made of what its place does not take; its unit is not judged too
  bool plain_numbers = false;  ///< it names nothing: its numbers are in the unit of its place
};

/// The first node of every arena: the number 0, for what is absent (the z of a planar point) or
/// could not be resolved. It has no root, so nothing is ever said about it.
inline constexpr ExpressionId no_expression = 0;

/// `min` and `max` of a parameter; either may be given alone.
struct ParameterBounds {
  std::optional<cln::cl_R> minimum = {};
  std::optional<cln::cl_R> maximum = {};
};

/// The expression that takes the place of an open function.
struct Closure {
  const ValueSyntax* value = nullptr;
  bool is_of_scene = false;  ///< otherwise it is the model's own sample
};

/// An expression that a function left open may be, and the arguments of the function.
struct FunctionExpression {
  std::vector<ExpressionId> arguments = {};
  ExpressionId value = no_expression;
};

struct Context {
  explicit Context(const Limits& the_limits) : limits(the_limits) { (void)append({}); }

  /// Adds a node; one whose value is an exact number becomes that: 1/2 + 1/3 -> 5/6, sqrt(4) -> 2.
  /// The failure of a constant without a value.
  std::optional<ConstantFailure> append(Expression node) {
    std::vector<Expression>& arena = model.expressions;
    const Span span = node.span;
    arena.push_back(std::move(node));
    if (const auto failure = constants.append(arena)) return failure;
    const std::optional<cln::cl_R> value = constants[last()];
    if (value && is_rational(*value)) {
      arena.back() = {.number = cln::the<cln::cl_RA>(*value), .span = span};
    }
    return std::nullopt;
  }

  /// The node that was added last.
  [[nodiscard]] ExpressionId last() const {
    return static_cast<ExpressionId>(model.expressions.size() - 1);
  }

  /// Forgets the nodes from `size` on.
  void truncate(std::size_t size) {
    model.expressions.resize(size);
    constants.truncate(size);
  }

  const Limits& limits;
  Report report = {};
  Sizes sizes = {};
  DeclaredNames symbols = {};
  DeclaredNames frames =
      {};  ///< frames have names of their own: a body may be called like its frame
  DeclaredNames equilibria = {};                              ///< likewise
  std::map<std::string, Closure, std::less<>> closures = {};  ///< by name of the function
  std::map<std::string, FunctionExpression, std::less<>> function_expressions = {};  ///< likewise
  Model model = {};
  Constants constants = {};
  /// Expression nodes (and steps to resolve one expression) before E908.
  std::uint64_t node_limit = limits.derived_nodes;
  bool beyond_limits = false;  ///< E906, E907 or E908 was reported; nothing more is resolved
  bool has_units = true;       ///< the model declares a unit other than 1
  /// The number of components of most vectors of the model, or of the first one.
  std::uint32_t dimension = 0;
  bool is_planar = false;     ///< most vectors have two components, known before any is read
  Span model_span = {};       ///< the header `[model]`
  Span lagrangian_span = {};  ///< the key `L`
  std::vector<WrittenExpression> roots = {};
  std::vector<ParameterBounds> bounds = {};                ///< by parameter array
  std::vector<std::optional<Unit>> prescribed_units = {};  ///< as declared, by prescribed function
};

}  // namespace elgen
