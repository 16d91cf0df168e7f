// Walks the nodes of every root and reports each node that introduces a forbidden ingredient. A
// cycle is printed from its first entry in the file.
#include "check/expressions/places.hpp"

#include <algorithm>
#include <array>

#include "elgen/references.hpp"

namespace elgen {
namespace {

struct IngredientRow {
  Ingredient ingredient;
  std::string_view noun;
};

constexpr std::array<IngredientRow, 13> ingredient_table{{
    {uses_momentum, "a momentum"},
    {uses_energy, "the energy function"},
    {uses_multiplier, "a multiplier"},
    {uses_open_derivative, "a derivative of an open function"},
    {uses_open_rate, "an open function of rates"},
    {uses_open_function, "an open function"},
    {uses_acceleration, "a second derivative"},
    {uses_kink, "a function with a kink"},
    {uses_input, "an input"},
    {uses_rate, "a rate"},
    {uses_coordinate, "a coordinate"},
    {uses_time, "time"},
    {uses_parameter, "a parameter"},
}};

constexpr const char* smooth_stand_in = "a smooth approximation is tanh(x/width)";
constexpr const char* momentum_place_hint =
    "it is allowed in `[[expect]]`: in `conserved`, and in outputs that take momenta";
constexpr const char* multiplier_place_hint =
    "it is allowed in an `[[output]]` with `motion = true`, and in `equations` of `[[expect]]`";
constexpr const char* velocity_kind_hint = "equations of rates have `kind = \"velocity\"`";
constexpr const char* varying_mass = "write a variable term in `[energy] T`";
constexpr const char* slope_hint =
    "a `[[function]]` for the slope is allowed here: the rate is slope*dot(argument)";
constexpr const char* slope_in_energy =
    "a `[[function]]` for the slope is allowed in `[energy] T`: the rate is slope*dot(argument)";
constexpr const char* commanded_acceleration =
    "for a commanded acceleration a, omit the coordinate and give each mass the force -m*a";
constexpr const char* acting_input = "an input acts by its key `on`, or in a `[[force]]`";

Code code_of(Ingredient ingredient, const ExpressionRole& place) {
  if (place.error_code == Code::E319 && ingredient == uses_acceleration) return Code::E502;
  if (place.error_code == Code::E319 && ingredient == uses_kink) return Code::E315;
  return place.error_code;
}

/// True if a node has an ingredient that none of its operands has.
bool introduces(const Expression& node, const std::vector<ExpressionTraits>& traits,
                ExpressionId id, Ingredient ingredient) {
  if ((traits[id].ingredients & ingredient) == 0) return false;
  for (const ExpressionId operand : node.operands) {
    if ((traits[operand].ingredients & ingredient) != 0) return false;
  }
  return true;
}

/// Hint: an allowed way to express the intended quantity; "" if there is none.
std::string_view alternative_hint(const ExpressionRole& place, Ingredient ingredient) {
  const bool is_constraint =
      place.noun == place::position_equation || place.noun == place::velocity_equation;
  const bool is_energy =
      place.allowed == place::energy_terms || place.allowed == place::dissipation_terms;
  if (ingredient == uses_kink) return smooth_stand_in;
  if (ingredient == uses_input && is_energy) return acting_input;
  if (ingredient == uses_momentum) return momentum_place_hint;
  if (ingredient == uses_multiplier) return multiplier_place_hint;
  if (is_constraint && ingredient == uses_rate) return velocity_kind_hint;
  if (is_constraint && ingredient == uses_acceleration) return commanded_acceleration;
  if (place.error_code == Code::E506) return varying_mass;
  const bool takes_functions = (place.allowed & uses_open_function) != 0;
  if (takes_functions && ingredient == uses_open_derivative) return slope_hint;
  const bool is_position = place.noun == place::position;
  return is_position && ingredient == uses_open_function ? slope_in_energy : "";
}

void report_ingredient(Context& context, const WrittenExpression& root, const Expression& node,
                       const IngredientRow& row) {
  const bool contains = refers_to_entry(node, NamedKind::definition) ||
                        refers_to_entry(node, NamedKind::point) ||
                        refers_to_entry(node, NamedKind::prescribed);
  std::string message = in_backticks(node.span) + (contains ? " contains " : " is ");
  message += std::string(row.noun) + ", but " + std::string(root.role.noun) + " takes none";
  context.report.add(code_of(row.ingredient, root.role), node.span, std::move(message),
                     std::string(alternative_hint(root.role, row.ingredient)));
}

void check_root(Context& context, const std::vector<ExpressionTraits>& traits,
                WrittenExpression& root) {
  const auto excess =
      static_cast<Ingredients>(traits[root.value].ingredients & ~unsigned{root.role.allowed});
  if (excess == 0) return;
  root.has_forbidden_ingredient = true;
  for (ExpressionId id = root.first; id <= root.value; ++id) {
    const Expression& node = context.model.expressions[id];
    for (const IngredientRow& row : ingredient_table) {
      const bool forbidden = (excess & row.ingredient) != 0;
      if (forbidden && introduces(node, traits, id, row.ingredient)) {
        report_ingredient(context, root, node, row);
      }
    }
  }
}

/// Reports E315 for a time derivative of a function with a kink, and E319 for the time derivative
/// of an acceleration or a multiplier, which the equations do not give. Places that forbid these
/// ingredients are skipped: check_root() reports them there.
void check_rates(Context& context, const std::vector<ExpressionTraits>& traits,
                 WrittenExpression& root) {
  const Ingredients found = traits[root.value].ingredients & root.role.allowed;
  const Ingredients unknowns = found & (uses_acceleration | uses_multiplier);
  if ((found & uses_kink) == 0 && unknowns == 0) return;
  for (ExpressionId id = root.first; id <= root.value; ++id) {
    const Expression& node = context.model.expressions[id];
    if (node.kind != ExpressionKind::time_derivative) continue;
    const bool is_kinked = (traits[id].ingredients & found & uses_kink) != 0;
    const bool is_unknown = (traits[node.operands[0]].ingredients & unknowns) != 0;
    if (!is_kinked && !is_unknown) continue;
    root.has_forbidden_ingredient = true;
    const std::string noun = is_kinked ? "a function with a kink"
                                       : "an acceleration or a multiplier, which the equations of "
                                         "motion do not give";
    context.report.add(is_kinked ? Code::E315 : Code::E319, node.span,
                       in_backticks(node.span) + " is the rate of " + noun,
                       is_kinked ? smooth_stand_in : "");
  }
}

struct NamedSpan {
  std::string name;
  Span span;
};

template <class Row>
NamedSpan make_named_span(const Row& row) {
  return {row.name, row.span};
}

/// The named entry that a node refers to; none if the node is no name.
std::optional<NamedSpan> entry_of_node(const Model& model, const Expression& node) {
  if (node.kind != ExpressionKind::named) return std::nullopt;
  switch (node.named) {
    case NamedKind::definition:
      return make_named_span(model.definitions[node.index]);
    case NamedKind::prescribed:
      return make_named_span(model.prescribed[node.index]);
    case NamedKind::point:
      return make_named_span(model.points[node.index]);
    case NamedKind::body:
      return make_named_span(model.bodies[node.index]);
    case NamedKind::frame:
      return make_named_span(model.frames[node.index]);
  }
  return std::nullopt;
}

}  // namespace

bool check_cycles(Context& context) {
  const Model& model = context.model;
  std::vector<NamedSpan> cycle;
  for (const ExpressionId id : find_cycle(model)) {
    if (auto name = entry_of_node(model, model.expressions[id])) cycle.push_back(*std::move(name));
  }
  if (cycle.empty()) return true;
  const auto earlier = [](const NamedSpan& a, const NamedSpan& b) {
    return a.span.begin < b.span.begin;
  };
  std::rotate(cycle.begin(), std::ranges::min_element(cycle, earlier), cycle.end());
  std::string text;
  for (const NamedSpan& entry : cycle) text += entry.name + " -> ";
  const auto& [first, span] = cycle.front();
  context.report.add(Code::E206, span,
                     quote_text(first) + " is defined by itself: " + text + first);
  return false;
}

void check_ingredients(Context& context, const std::vector<ExpressionTraits>& traits) {
  for (WrittenExpression& root : context.roots) {
    check_root(context, traits, root);
    check_rates(context, traits, root);
  }
}

}  // namespace elgen
