// Prints expressions of a Model in the model language, with as few brackets as keep the tree:
//
//     multiply(1/2, add(a, negate(b)))   ->   1/2*(a - b)
#include <cln/integer.h>

#include <array>

#include "base/number_text.hpp"
#include "elgen/model.hpp"

namespace elgen {
namespace {

/// How tightly an operator binds; operands that bind less tightly get brackets.
enum class Binding : std::uint8_t { sum, product, power, atom };

struct Printed {
  std::string text;
  Binding binding = Binding::atom;
};

std::string within(const Printed& operand, Binding needed) {
  return operand.binding < needed ? "(" + operand.text + ")" : operand.text;
}

class Printer {
 public:
  explicit Printer(const Model& model) : model_(model) {}

  [[nodiscard]] Printed print(ExpressionId id) const {
    const Expression& node = model_.expressions[id];
    switch (node.kind) {
      case ExpressionKind::number:
        return number(node.number);
      case ExpressionKind::negate:
        return {"-" + within(print(node.operands[0]), Binding::power), Binding::sum};
      case ExpressionKind::add:
        return sum(node);
      case ExpressionKind::multiply:
        return product(node);
      case ExpressionKind::divide:
        return {within(print(node.operands[0]), Binding::product) + "/" +
                    within(print(node.operands[1]), Binding::power),
                Binding::product};
      case ExpressionKind::power:
        return power(node);
      case ExpressionKind::function:
        return call(std::string(function_row(node.function).name), node);
      case ExpressionKind::time_derivative:
        return call("dot", node);
      default:
        return {leaf(node), Binding::atom};
    }
  }

 private:
  [[nodiscard]] std::string leaf(const Expression& node) const {
    switch (node.kind) {
      case ExpressionKind::pi:
        return "pi";
      case ExpressionKind::coordinate:
        return model_.coordinates[node.index].name;
      case ExpressionKind::rate:
        return "dot(" + model_.velocities[node.index].name + ")";
      case ExpressionKind::acceleration:
        return "dot(dot(" + model_.velocities[node.index].name + "))";
      case ExpressionKind::input:
        return model_.inputs[node.index].name;
      case ExpressionKind::parameter:
        return model_.parameters[node.index].name;
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
        return "t";
    }
  }

  /// For dumps; a model does not write them.
  [[nodiscard]] std::string frame_component(std::uint32_t index) const {
    const std::string& name = model_.frames[index / components_per_frame].name;
    const std::uint32_t k = index % components_per_frame;
    return k < 9 ? "R(" + name + ")[" + std::to_string(k / 3 + 1) + "," +
                       std::to_string(k % 3 + 1) + "]"
                 : std::string(1, "xyz"[k - 9]) + "(" + name + ")";
  }

  static bool is_negative(const Expression& term) {
    return term.kind == ExpressionKind::number && cln::minusp(term.number);
  }

  static Printed number(const cln::cl_RA& value) {
    const bool is_integer = cln::denominator(value) == 1;
    if (cln::minusp(value)) {
      return {number_text(value), Binding::sum};
    }
    return {number_text(value), is_integer ? Binding::atom : Binding::product};
  }

  [[nodiscard]] Printed sum(const Expression& node) const {
    std::string text;
    for (const ExpressionId operand : node.operands) {
      const Expression& term = model_.expressions[operand];
      if (term.kind == ExpressionKind::negate && !text.empty()) {
        text += " - " + within(print(term.operands[0]), Binding::product);
      } else if (is_negative(term) && !text.empty()) {
        text += " - " + number_text(-term.number);
      } else {
        text += (text.empty() ? "" : " + ") + within(print(operand), Binding::product);
      }
    }
    return {text, Binding::sum};
  }

  [[nodiscard]] Printed product(const Expression& node) const {
    std::string text;
    for (const ExpressionId operand : node.operands) {
      // Only the first factor may be a quotient without brackets: a/b*c is (a/b)*c.
      const bool negated = model_.expressions[operand].kind == ExpressionKind::negate;
      const Binding first = negated ? Binding::sum : Binding::product;
      const Binding needed = text.empty() ? first : Binding::power;
      text += (text.empty() ? "" : "*") + within(print(operand), needed);
    }
    return {text, Binding::product};
  }

  [[nodiscard]] Printed power(const Expression& node) const {
    const Printed base = print(node.operands[0]);
    if (node.number == cln::cl_RA(1) / 2) {
      return {"sqrt(" + base.text + ")", Binding::atom};
    }
    const std::string exponent = within(number(node.number), Binding::atom);
    return {within(base, Binding::atom) + "^" + exponent, Binding::power};
  }

  [[nodiscard]] Printed call(const std::string& name, const Expression& node) const {
    std::string arguments;
    for (const ExpressionId operand : node.operands) {
      arguments += (arguments.empty() ? "" : ", ") + print(operand).text;
    }
    return {name + "(" + arguments + ")", Binding::atom};
  }

  const Model& model_;
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
  return Printer(model).print(expression).text;
}

}  // namespace elgen
