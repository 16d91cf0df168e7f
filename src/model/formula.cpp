// formula: where brackets stand; expressions of a Model, operand by operand.
#include "model/formula.hpp"

#include <cln/integer.h>
#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.hpp"
#include "elgen/leaf_names.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

/// Brackets grow with content that is taller than a line.
std::string in_brackets(const Spelling& spelling, const std::string& text) {
  const bool is_tall = spelling.is_two_dimensional && (text.find("\\frac") != std::string::npos ||
                                                       text.find("\\sqrt") != std::string::npos);
  return is_tall ? fmt::format("\\left( {} \\right)", text) : fmt::format("({})", text);
}

/// Side by side, factors keep apart where one could be read into the other.
std::string side_by_side(const Formula& before, const std::string& after) {
  const bool is_word = before.head.starts_with("\\mathrm") || after.starts_with("\\mathrm");
  return is_word || is_digit(after.front()) ? " \\cdot " : " ";
}

bool is_no_call(const Formula& factor) { return factor.tail.empty(); }

/// So that no factor is read as a part of their arguments.
std::vector<Formula> functions_last(std::vector<Formula> factors) {
  std::stable_partition(factors.begin(), factors.end(), is_no_call);
  return factors;
}

/// How a product holds together, by its first operand.
Binding signed_as(const Formula& first) {
  return first.binding == Binding::negation ? Binding::negation : Binding::product;
}

std::string joined(const std::vector<Formula>& arguments) {
  std::string list;
  for (const Formula& argument : arguments) list += (list.empty() ? "" : ", ") + argument.text();
  return list;
}

/// 9.81, but not 1/2 and 2/5: numbers too long for a fraction, of which the denominator has the
/// factor 5 of a decimal number.
bool is_decimal(const cln::cl_RA& value) {
  constexpr int longest = 16;
  const cln::cl_I denominator = cln::denominator(value);
  const bool is_short = cln::numerator(value) <= longest && denominator <= longest;
  return !is_short && cln::zerop(cln::mod(denominator, 5)) && exact_decimal(value) &&
         exact_text(value).find('e') == std::string::npos;
}

/// log1p(x), expm1(x) and hypot(x, y) as they are read: log(1 + x), e^x - 1, the root of a sum of
/// squares.
Formula as_read(const Spelling& spelling, FunctionId function,
                const std::vector<Formula>& arguments) {
  const Formula& x = arguments.front();
  const Formula one{"1"};
  if (function == FunctionId::log1p) {
    return call(spelling, FunctionId::log, {sum(spelling, {{one}, {x}})});
  }
  if (function == FunctionId::expm1) {
    return sum(spelling, {{call(spelling, FunctionId::exp, {x})}, {one, true}});
  }
  const Formula two{"2"};
  return square_root(spelling, sum(spelling, {{power(spelling, x, two)},
                                              {power(spelling, arguments.back(), two)}}));
}

std::string filled(std::string_view holes, const std::string& first,
                   const std::string& second = {}) {
  return fmt::format(fmt::runtime(holes), first, second);
}

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

Formula at_least(const Spelling& spelling, const Formula& formula, Binding least) {
  return formula.binding < least ? Formula{in_brackets(spelling, formula.text())} : formula;
}

Formula negated(const Spelling& spelling, const Formula& operand) {
  return {"-" + at_least(spelling, operand, Binding::product).text(), Binding::negation};
}

Formula sum(const Spelling& spelling, const std::vector<Summand>& terms) {
  const auto& [first, is_subtracted] = terms.front();
  const Formula start = is_subtracted ? negated(spelling, first) : first;
  if (terms.size() == 1) return start;
  std::string text = start.text();
  for (std::size_t i = 1; i < terms.size(); ++i) {
    text += terms[i].is_subtracted ? " - " : " + ";
    text += at_least(spelling, terms[i].term, Binding::product).text();
  }
  return {text, Binding::sum};
}

Formula product(const Spelling& spelling, const std::vector<Formula>& factors) {
  if (factors.size() == 1) return factors.front();
  if (spelling.is_two_dimensional && !std::ranges::is_partitioned(factors, is_no_call)) {
    return product(spelling, functions_last(factors));
  }
  // Only the first factor may be a quotient, or carry a sign, without brackets.
  std::string text = at_least(spelling, factors.front(), Binding::negation).text();
  for (std::size_t i = 1; i < factors.size(); ++i) {
    const std::string next = at_least(spelling, factors[i], Binding::power).text();
    text += spelling.is_two_dimensional ? side_by_side(factors[i - 1], next)
                                        : std::string(spelling.times);
    text += next;
  }
  return {text, signed_as(factors.front())};
}

Formula quotient(const Spelling& spelling, const Formula& above, const Formula& below) {
  if (spelling.is_two_dimensional) {
    return {filled(spelling.quotient, above.text(), below.text()), Binding::power};
  }
  return {filled(spelling.quotient, at_least(spelling, above, Binding::negation).text(),
                 at_least(spelling, below, Binding::power).text()),
          signed_as(above)};
}

Formula power(const Spelling& spelling, const Formula& base, const Formula& exponent) {
  const bool is_stacked = spelling.is_two_dimensional;
  const std::string raised =
      (is_stacked ? exponent : at_least(spelling, exponent, Binding::atom)).text();
  if (!base.tail.empty()) {
    return {filled(spelling.power, base.head, raised), Binding::power, base.tail};
  }
  std::string text = at_least(spelling, base, Binding::atom).text();
  const bool has_exponent =
      is_stacked && base.binding == Binding::atom && text.find('^') != std::string::npos;
  if (has_exponent) text = fmt::format("{{{}}}", text);
  return {filled(spelling.power, text, raised), Binding::power};
}

Formula square_root(const Spelling& spelling, const Formula& radicand) {
  return {filled(spelling.root, radicand.text()),
          spelling.is_two_dimensional ? Binding::power : Binding::atom};
}

Formula call(const Spelling& spelling, FunctionId function, const std::vector<Formula>& arguments) {
  const bool is_stumpff = function == FunctionId::stumpff;
  const std::string_view own = is_stumpff ? name_of_order(arguments.back().text()) : "";
  if (!spelling.is_two_dimensional) {
    return own.empty() ? called(function_row(function).name, arguments)
                       : called(own, {arguments.front()});
  }
  const bool is_written_out = function == FunctionId::log1p || function == FunctionId::expm1 ||
                              function == FunctionId::hypot;
  if (is_written_out) return as_read(spelling, function, arguments);
  if (!own.empty()) {
    return {fmt::format("\\mathrm{{{}}}", own), Binding::power,
            in_brackets(spelling, arguments.front().text())};
  }
  const std::string list = joined(arguments);
  if (function == FunctionId::abs) return {fmt::format("\\left| {} \\right|", list)};
  const Formula& first = arguments.front();
  const bool is_alone = first.binding == Binding::atom && first.tail.empty();
  const bool is_fraction = first.binding == Binding::power && list.starts_with("\\frac");
  const bool is_command = function != FunctionId::sign;
  const bool stands_free = is_command && arguments.size() == 1 && (is_alone || is_fraction);
  return {std::string(function_row(function).latex), Binding::power,
          stands_free ? " " + list : in_brackets(spelling, list)};
}

Formula called(std::string_view name, const std::vector<Formula>& arguments) {
  return {fmt::format("{}({})", name, joined(arguments))};
}

Formula number(const Spelling& spelling, const cln::cl_RA& value) {
  if (cln::minusp(value)) return negated(spelling, number(spelling, -value));
  const cln::cl_I denominator = cln::denominator(value);
  if (denominator == 1) return {integer_text(cln::numerator(value))};
  if (spelling.is_two_dimensional && is_decimal(value)) return {exact_text(value)};
  return quotient(spelling, {integer_text(cln::numerator(value))}, {integer_text(denominator)});
}

Formula formula_of(const Model& model, ExpressionId expression, const Spelling& spelling,
                   const std::function<Formula(ExpressionId)>& name) {
  return Printer(model, spelling, name).print(expression);
}

std::string to_string(const Model& model, ExpressionId expression) {
  const auto name = [&model](ExpressionId id) {
    return Formula{name_in_model(model, model.expressions[id])};
  };
  return formula_of(model, expression, model_spelling, name).text();
}

}  // namespace elgen
