// Prints expressions of a Model in the model language, with as few brackets as keep the tree:
//
//     multiply(1/2, add(a, negate(b)))   ->   1/2*(a - b)
#include "base/formula.hpp"
#include "elgen/leaf_names.hpp"
#include "elgen/model.hpp"

namespace elgen {
namespace {

class Printer {
 public:
  explicit Printer(const Model& model) : model_(model) {}

  [[nodiscard]] Formula print(ExpressionId id) const {
    const Expression& node = model_.expressions[id];
    switch (node.kind) {
      case ExpressionKind::number:
        return number(spelling_, node.number);
      case ExpressionKind::negate:
        return negated(spelling_, at_least(spelling_, print(node.operands[0]), Binding::power));
      case ExpressionKind::add:
        return total(node);
      case ExpressionKind::multiply:
        return product(spelling_, operands(node));
      case ExpressionKind::divide:
        return quotient(spelling_, print(node.operands[0]), print(node.operands[1]));
      case ExpressionKind::power:
        if (node.number == cln::cl_RA(1) / 2) return called("sqrt", operands(node));
        return power(spelling_, print(node.operands[0]), number(spelling_, node.number));
      case ExpressionKind::function:
        return call(spelling_, node.function, operands(node));
      case ExpressionKind::time_derivative:
        return called("dot", operands(node));
      default:
        return {leaf(node)};
    }
  }

 private:
  [[nodiscard]] std::string leaf(const Expression& node) const {
    switch (node.kind) {
      case ExpressionKind::pi:
        return "pi";
      case ExpressionKind::prescribed:
        return model_.prescribed[node.index].name;
      case ExpressionKind::definition:
        return model_.definitions[node.index].name;
      case ExpressionKind::point_component:
        return std::string(1, "xyz"[node.index % 3]) + "(" + model_.points[node.index / 3].name +
               ")";
      case ExpressionKind::frame_component:
        return frame_component(node.index);
      default:
        return leaf_text(model_, node.leaf, node.index);
    }
  }

  /// A model does not write them.
  [[nodiscard]] std::string frame_component(std::uint32_t index) const {
    const std::string& name = model_.frames[index / components_per_frame].name;
    const std::uint32_t k = index % components_per_frame;
    return k < 9 ? "R(" + name + ")[" + std::to_string(k / 3 + 1) + "," +
                       std::to_string(k % 3 + 1) + "]"
                 : std::string(1, "xyz"[k - 9]) + "(" + name + ")";
  }

  [[nodiscard]] std::vector<Formula> operands(const Expression& node) const {
    std::vector<Formula> all;
    for (const ExpressionId operand : node.operands) all.push_back(print(operand));
    return all;
  }

  [[nodiscard]] Formula total(const Expression& node) const {
    std::vector<Summand> terms;
    for (const ExpressionId operand : node.operands) {
      const Expression& term = model_.expressions[operand];
      const bool is_number = term.kind == ExpressionKind::number && cln::minusp(term.number);
      if (!terms.empty() && term.kind == ExpressionKind::negate) {
        terms.push_back({print(term.operands[0]), true});
      } else if (!terms.empty() && is_number) {
        terms.push_back({number(spelling_, -term.number), true});
      } else {
        terms.push_back({at_least(spelling_, print(operand), Binding::negation)});
      }
    }
    return sum(spelling_, terms);
  }

  const Model& model_;
  const Spelling& spelling_ = model_spelling();
};

}  // namespace

bool eliminates_last_first(const Model& model) {
  std::vector<bool> carries(model.frames.size(), false);
  for (const Frame& frame : model.frames) {
    if (!frame.parent) continue;
    if (carries[*frame.parent]) return true;
    carries[*frame.parent] = true;
  }
  return false;
}

ExpressionId component_of_frame(const Model& model, std::uint32_t index) {
  const Frame& frame = model.frames[index / components_per_frame];
  const std::uint32_t k = index % components_per_frame;
  return k < 9 ? frame.rotation[k] : frame.origin[k - 9];
}

std::string to_string(const Model& model, ExpressionId expression) {
  return Printer(model).print(expression).text();
}

}  // namespace elgen
