// Prints expressions of a Model in the model language, with as few brackets as keep the tree:
//
//     multiply(1/2, add(a, negate(b)))   ->   1/2*(a - b)
#include "model/print.hpp"

#include "elgen/leaf_names.hpp"

namespace elgen {
namespace {

class Printer {
 public:
  Printer(const Model& model, const Spelling& spelling,
          const std::function<Formula(ExpressionId)>& name)
      : model_(model), spelling_(spelling), name_(name) {}

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
        if (node.number == cln::cl_RA(1) / 2) {
          return square_root(spelling_, print(node.operands[0]));
        }
        return power(spelling_, print(node.operands[0]), number(spelling_, node.number));
      case ExpressionKind::function:
        return call(spelling_, node.function, operands(node));
      default:
        return name_(id);
    }
  }

 private:
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
  const Spelling& spelling_;
  const std::function<Formula(ExpressionId)>& name_;
};

/// A model does not write them.
std::string name_of_component(const Model& model, std::uint32_t index) {
  const std::string& name = model.frames[index / components_per_frame].name;
  const std::uint32_t k = index % components_per_frame;
  return k < 9 ? "R(" + name + ")[" + std::to_string(k / 3 + 1) + "," + std::to_string(k % 3 + 1) +
                     "]"
               : std::string(1, "xyz"[k - 9]) + "(" + name + ")";
}

std::string name_in_model(const Model& model, const Expression& node) {
  switch (node.kind) {
    case ExpressionKind::pi:
      return "pi";
    case ExpressionKind::prescribed:
      return model.prescribed[node.index].name;
    case ExpressionKind::definition:
      return model.definitions[node.index].name;
    case ExpressionKind::point_component:
      return std::string(1, "xyz"[node.index % 3]) + "(" + model.points[node.index / 3].name + ")";
    case ExpressionKind::frame_component:
      return name_of_component(model, node.index);
    case ExpressionKind::time_derivative:
      return "dot(" + to_string(model, node.operands[0]) + ")";
    default:
      return leaf_text(model, node.leaf, node.index);
  }
}

}  // namespace

Formula formula_of(const Model& model, ExpressionId expression, const Spelling& spelling,
                   const std::function<Formula(ExpressionId)>& name) {
  return Printer(model, spelling, name).print(expression);
}

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
  const auto name = [&model](ExpressionId id) {
    return Formula{name_in_model(model, model.expressions[id])};
  };
  return formula_of(model, expression, model_spelling(), name).text();
}

}  // namespace elgen
