// formula: converts expressions to formulas, node by node, with the names of the model and the
// fewest brackets that preserve the tree.
#include <fmt/format.h>

#include "elgen/leaf_names.hpp"
#include "model/symbols.hpp"

namespace elgen {
namespace {

class FormulaMaker {
 public:
  FormulaMaker(const Model& model, const std::function<Formula(ExpressionId)>& name)
      : model_(model), name_(name) {}

  [[nodiscard]] Formula operator()(ExpressionId id) const {
    const auto typed = model_.original_expressions.find(id);
    const Expression& node =
        typed == model_.original_expressions.end() ? model_.expressions[id] : typed->second;
    switch (node.kind) {
      case ExpressionKind::number:
        return number_formula(node.number);
      case ExpressionKind::negate:
        return negative_of(group(operand(node, 0)));
      case ExpressionKind::add:
        return sum_of_terms(node);
      case ExpressionKind::multiply:
        return product_of(operands(node));
      case ExpressionKind::divide:
        return quotient_of(operand(node, 0), operand(node, 1));
      case ExpressionKind::power:
        return node.number == cln::cl_RA(1) / 2
                   ? root_of(operand(node, 0))
                   : power_of(operand(node, 0), number_formula(node.number));
      case ExpressionKind::function:
        return call_of(node.function, operands(node));
      default:
        return name_(id);
    }
  }

 private:
  [[nodiscard]] Formula operand(const Expression& node, std::size_t i) const {
    return (*this)(node.operands[i]);
  }

  [[nodiscard]] Formulas operands(const Expression& node) const {
    Formulas all;
    for (const ExpressionId operand : node.operands) all.push_back((*this)(operand));
    return all;
  }

  /// A sum. Every negative term except the first is subtracted, without brackets.
  [[nodiscard]] Formula sum_of_terms(const Expression& node) const {
    Formulas terms;
    for (const ExpressionId operand : node.operands) {
      const Expression& term = model_.expressions[operand];
      const bool is_negative = !terms.empty() && term.kind == ExpressionKind::negate &&
                               !model_.original_expressions.contains(operand);
      terms.push_back(is_negative ? negative_of((*this)(term.operands[0])) : (*this)(operand));
    }
    return sum_of(std::move(terms));
  }

  const Model& model_;
  const std::function<Formula(ExpressionId)>& name_;
};

/// The text of component k of a frame `name`: "axis(F, 2, 3)", "x(F)", "wx(F)"; "wx(F, F)" for
/// Frame::recursive_spin.
std::string frame_component_name(const std::string& name, std::uint32_t k) {
  const std::string axis(1, "xyz"[k % 3]);
  if (k >= frame_recursive_spin) return fmt::format("w{}({}, {})", axis, name, name);
  if (k >= frame_angular_velocity) return fmt::format("w{}({})", axis, name);
  if (k >= frame_origin) return fmt::format("{}({})", axis, name);
  return fmt::format("axis({}, {}, {})", name, k / 3 + 1, k % 3 + 1);
}

std::string named_node_text(const Model& model, const Expression& node) {
  const auto component_of = [&node](const std::string& name) {
    return std::string(1, "xyz"[node.component]) + "(" + name + ")";
  };
  switch (node.named) {
    case NamedKind::prescribed:
      return model.prescribed[node.index].name;
    case NamedKind::definition:
      return model.definitions[node.index].name;
    case NamedKind::point:
      return component_of(model.points[node.index].name);
    case NamedKind::body:
      return component_of(model.bodies[node.index].name);
    case NamedKind::frame:
      return frame_component_name(model.frames[node.index].name, node.component);
  }
  return {};
}

std::string node_text(const Model& model, const Expression& node) {
  switch (node.kind) {
    case ExpressionKind::pi:
      return "pi";
    case ExpressionKind::named:
      return named_node_text(model, node);
    case ExpressionKind::time_derivative:
      return "dot(" + to_string(model, node.operands[0]) + ")";
    default:
      return leaf_text(model, node.leaf, node.index);
  }
}

}  // namespace

Formula formula_of(const Model& model, ExpressionId expression,
                   const std::function<Formula(ExpressionId)>& name) {
  return FormulaMaker(model, name)(expression);
}

std::string to_string(const Model& model, ExpressionId expression) {
  const auto name = [&model](ExpressionId id) {
    return name_formula(node_text(model, model.expressions[id]));
  };
  return text_of(formula_of(model, expression, name));
}

}  // namespace elgen
