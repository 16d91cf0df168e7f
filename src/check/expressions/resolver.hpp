// Resolver: converts the syntax of an expression to nodes of the Model's arena.
#pragma once

#include <cln/rational.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/names/context.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

inline constexpr std::string_view degrees_hint = "angles are in rad: 30 degrees are `30*pi/180`";

/// Hint on a rate or acceleration: "a rate is written `dot(theta)`" for theta_dot and v_theta.
/// `written` is the name with its index. "" if no coordinate has the base name.
[[nodiscard]] std::string rate_hint(const std::string& name, std::string_view written,
                                    const SymbolTable& symbols);

/// Resolves names, expands sums and components of points, folds exact constants, and reports
/// constants without a value. Every node keeps its span in the file, so leaves are not shared.
///
///     sum(i, 1, 2, m[i]*x[i])   ->   add(multiply(m[1], x[1]), multiply(m[2], x[2]))
///     v2(P)                     ->   add(power(dot(P.x), 2), power(dot(P.y), 2))
///     p(x)                      ->   the momentum dL/d(dot(x)), a leaf
class Resolver {
 public:
  /// `allowed`: the ingredients that the place allows. If the place allows the energy, the name `E`
  /// denotes the energy.
  Resolver(Context& context, IndexScope& scope, Ingredients allowed = 0)
      : context_(context), scope_(scope), allowed_(allowed) {}

  /// Appends the nodes of an expression and returns its last node; none after an error. Operands
  /// precede their users, and the nodes of one call are consecutive.
  std::optional<ExpressionId> resolve(const ExpressionSyntax& expression);

  /// The index in the Model of `name` or `name[i]`. E208 for a missing or superfluous index; the
  /// error `absent` if no element has this index.
  std::optional<std::uint32_t> resolve_element(const ExpressionSyntax& name,
                                               const DeclaredName& symbol,
                                               Code absent = Code::E207);

  /// The declaration of a name of this kind; null after E201. `has_form`: true if `name` has the
  /// syntax of a name of this kind.
  const DeclaredName* require_declaration(const ExpressionSyntax& name, SymbolKind kind,
                                          bool has_form, std::string_view shown);

  /// A function defined in the model language.
  struct CompositeFunction {
    std::string_view name;
    std::size_t arity;
    std::string_view definition;
    std::string_view spatial_definition;
  };

 private:
  using Operands = std::vector<ExpressionId>;

  std::optional<ExpressionId> push(Expression expression);
  std::optional<ExpressionId> push_number(const cln::cl_RA& number, const Span& span);
  std::optional<ExpressionId> push_leaf(Opcode kind, std::uint32_t index, const Span& span);
  std::optional<Operands> resolve_operands(const std::vector<ExpressionSyntax>& expressions);
  bool check_node_limit(const Span& span);
  void report_failure(const ConstantFailure& failure, const Expression& node);

  std::optional<ExpressionId> resolve_operation(const ExpressionSyntax& operation);
  std::optional<ExpressionId> resolve_power(const ExpressionSyntax& power);
  std::optional<cln::cl_RA> resolve_exponent(const ExpressionSyntax& exponent);
  bool check_exponent(const cln::cl_RA& exponent, const Span& span);

  std::optional<ExpressionId> resolve_name(const ExpressionSyntax& name);
  std::optional<ExpressionId> resolve_symbol(const ExpressionSyntax& name,
                                             const DeclaredName& symbol);
  std::optional<ExpressionId> report_unknown_name(const ExpressionSyntax& name);
  [[nodiscard]] bool is_energy(const ExpressionSyntax& name) const;
  void report_hidden_energy(const ExpressionSyntax& name, const DeclaredName& symbol);

  std::optional<ExpressionId> resolve_call(const ExpressionSyntax& call);
  std::optional<ExpressionId> resolve_function(const ExpressionSyntax& call, FunctionId function);
  std::optional<ExpressionId> resolve_stumpff(const ExpressionSyntax& call);
  std::optional<ExpressionId> resolve_composite(const ExpressionSyntax& call,
                                                const CompositeFunction& composite);
  std::optional<ExpressionId> resolve_dot(const ExpressionSyntax& call);
  std::optional<ExpressionId> resolve_momentum(const ExpressionSyntax& call);
  std::optional<ExpressionId> resolve_multiplier(const ExpressionSyntax& call);
  std::optional<ExpressionId> resolve_sum(const ExpressionSyntax& call);
  std::optional<ExpressionId> resolve_delta(const ExpressionSyntax& call);

  /// An entry with a position. The component `first` of the entry is the x of the position.
  struct ResolvedPlace {
    NamedKind kind = NamedKind::point;
    std::uint32_t index = 0;
    std::uint32_t first = 0;
    std::uint32_t dimension = 3;
  };
  struct ResolvedFrame {
    std::uint32_t index = 0;
    bool is_world = true;
  };
  std::optional<ResolvedPlace> resolve_place(const ExpressionSyntax& name);
  void report_unknown_place(const ExpressionSyntax& name, const DeclaredName* symbol);
  std::optional<ResolvedFrame> resolve_frame(const ExpressionSyntax& name);
  bool check_axis(const ExpressionSyntax& call, std::uint32_t dimension, bool is_angular);
  std::optional<ExpressionId> replace_shared_zero(ExpressionId id, const Span& span);
  std::optional<ExpressionId> resolve_component(const ExpressionSyntax& call);
  std::optional<ExpressionId> resolve_velocity(const ExpressionSyntax& call);
  std::optional<ExpressionId> resolve_angular_velocity(const ExpressionSyntax& call);
  std::optional<ExpressionId> resolve_axis(const ExpressionSyntax& call);

  std::optional<std::uint32_t> require_common_dimension(const ExpressionSyntax& call);
  bool check_arity(const ExpressionSyntax& call, std::size_t arity);

  Context& context_;
  IndexScope& scope_;
  Ingredients allowed_;
  std::uint64_t steps_ = 0;
};

}  // namespace elgen
