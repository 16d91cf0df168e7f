// Differentiates the expressions of energies, and falsifies the results.
#include "random/claims.hpp"

#include <map>
#include <stdexcept>
#include <string>

namespace elgen::test::random {

namespace {

bool is_number(const Expression& e, const char* text) {
  return e->kind == NodeKind::number && e->text == text;
}

/// a + b. Sums and products omit zeros and ones, so that claims stay readable.
Expression sum(const Expression& a, const Expression& b) {
  if (is_number(a, "0")) return b;
  return is_number(b, "0") ? a : a + b;
}

Expression times(const Expression& a, const Expression& b) {
  if (is_number(a, "0") || is_number(b, "1")) return a;
  return is_number(b, "0") || is_number(a, "1") ? b : a * b;
}

/// f'(x) of the functions that occur in energies.
Expression slope(const std::string& function, const Expression& x) {
  const Expression one = number(1);
  if (function == "sin") return call_of("cos", {x});
  if (function == "cos") return -call_of("sin", {x});
  if (function == "exp") return call_of("exp", {x});
  if (function == "sqrt") return one / (number(2) * call_of("sqrt", {x}));
  if (function == "tanh") return one - raised(call_of("tanh", {x}), 2);
  if (function == "atan") return one / (one + raised(x, 2));
  throw std::logic_error("no derivative of " + function);
}

/// The expression with all rates set to zero.
Expression at_rest(const Expression& expression) {
  if (expression->kind == NodeKind::rate) return number(0);
  Node node = *expression;
  for (Expression& operand : node.operands) operand = at_rest(operand);
  return made(std::move(node));
}

/// The expression with definitions substituted for their names.
Expression resolved(const Expression& expression, const std::vector<Named>& definitions) {
  if (expression->kind == NodeKind::name) {
    for (const Named& definition : definitions) {
      if (definition.name == expression->text) return resolved(definition.value, definitions);
    }
  }
  Node node = *expression;
  for (Expression& operand : node.operands) operand = resolved(operand, definitions);
  return made(std::move(node));
}

Expression second_derivative(const Expression& T, const Expression& a, const Expression& b) {
  return derivative(derivative(T, a), b);
}

/// The expression with a flipped sign in the sum of constants at index `countdown` from the left.
Expression with_flipped_sign(const Expression& expression, int& countdown) {
  const bool is_sum =
      expression->kind == NodeKind::addition || expression->kind == NodeKind::subtraction;
  const bool is_zero = is_sum && (is_number(expression->operands[0], "0") ||
                                  is_number(expression->operands[1], "0"));
  if (is_sum && !has_names(expression) && !is_zero && countdown-- == 0) {
    return expression->kind == NodeKind::addition
               ? expression->operands[0] - expression->operands[1]
               : expression->operands[0] + expression->operands[1];
  }
  Node node = *expression;
  for (Expression& operand : node.operands) operand = with_flipped_sign(operand, countdown);
  return made(std::move(node));
}

int flippable_sums(const Expression& expression) {
  int many = 1000000;
  const int start = many;
  const Expression same = with_flipped_sign(expression, many);
  return start - many;
}

/// A scope with a random value and a random rate, both in [1/4, 1), for every name.
class RandomScope : public Scope {
 public:
  explicit RandomScope(Draw& draw) : draw_(draw) {}

  Jet value_of(const std::string& name, const std::string& element) override {
    return drawn(name + "." + element);
  }
  Jet component_of(const std::string& point, const std::string& element, int axis) override {
    return drawn(point + "." + element + "." + std::to_string(axis));
  }
  int dimension_of(const std::string&) override { return 3; }
  Jet now() override { return drawn(""); }
  Vector turning_of(const std::string& frame, const std::string& axes) override {
    const std::string key = "w." + frame + "." + axes;
    return {drawn(key + ".x"), drawn(key + ".y"), drawn(key + ".z")};
  }

 private:
  Draw& draw_;
  std::map<std::string, Jet> values_;

  Number between() { return Number(25 + draw_.below(75)) / 100; }
  Jet drawn(const std::string& key) {
    const auto found = values_.find(key);
    if (found != values_.end()) return found->second;
    const Jet value = between();
    return values_[key] = value + Jet(between()) * Jet::infinitesimal(time_infinitesimal);
  }
};

/// True if the expressions differ at a random point, so that they are different functions.
bool differ(const Expression& a, const Expression& b, Draw& draw) {
  static const Number rounding("1e-60");  // relative, with 80 digits
  RandomScope point(draw);
  const Number x = evaluated(a, point).value();
  const Number y = evaluated(b, point).value();
  return abs(x - y) > rounding * (abs(x) + abs(y));
}

}  // namespace

Expression derivative(const Expression& expression, const Expression& by) {
  const Node& node = *expression;
  if (printed(expression) == printed(by)) return number(1);
  if (node.operands.empty() || node.kind == NodeKind::rate) return number(0);
  if (!has_names(expression)) return number(0);
  const Expression& a = node.operands[0];
  const Expression da = derivative(a, by);
  if (node.kind == NodeKind::negation) return is_number(da, "0") ? da : -da;
  if (node.kind == NodeKind::call) return times(slope(node.text, a), da);
  if (node.kind == NodeKind::power) {
    const Expression rest = node.first == 2 ? a : raised(a, node.first - 1);
    return times(times(number(node.first), rest), da);
  }
  const Expression& b = node.operands[1];
  const Expression db = derivative(b, by);
  const Expression minus_db = is_number(db, "0") ? db : -db;
  switch (node.kind) {
    case NodeKind::addition:
      return sum(da, db);
    case NodeKind::subtraction:
      return sum(da, minus_db);
    case NodeKind::multiplication:
      return sum(times(da, b), times(a, db));
    case NodeKind::division: {
      const Expression whole = is_number(da, "0") ? da : da / b;
      return is_number(db, "0") ? whole : sum(whole, times(a, minus_db) / raised(b, 2));
    }
    default:
      throw std::logic_error("no derivative");
  }
}

std::vector<Claim> true_claims(const Model& model) {
  const bool is_energies = model.T && model.points.empty() && model.bodies.empty() &&
                           model.frames.empty() && model.prescribed.empty();
  if (!is_energies || !model.V) return {};
  const Expression T = resolved(model.T, model.definitions);
  const Expression V = at_rest(resolved(model.V, model.definitions));
  Claim mass{"mass_matrix", {}};
  Claim gravity{"gravity", {}};
  for (const Coordinate& row : model.coordinates) {
    mass.rows.emplace_back();
    const Expression row_rate = rate(name(row.name));
    for (const Coordinate& column : model.coordinates) {
      Expression entry = at_rest(second_derivative(T, row_rate, rate(name(column.name))));
      if (row.armature && row.name == column.name) entry = sum(entry, row.armature);
      mass.rows.back().push_back(entry);
    }
    gravity.rows.push_back({derivative(V, name(row.name))});
  }
  return {mass, gravity, {"potential_energy", {{V}}}};
}

std::vector<Claim> falsified(std::vector<Claim> claims, Draw& draw) {
  Claim& claim = claims[static_cast<std::size_t>(draw.below(static_cast<int>(claims.size())))];
  auto& row = claim.rows[static_cast<std::size_t>(draw.below(static_cast<int>(claim.rows.size())))];
  Expression& entry = row[static_cast<std::size_t>(draw.below(static_cast<int>(row.size())))];
  const int places = flippable_sums(entry);
  int countdown = places > 0 ? draw.below(places) : 0;
  const Expression other = with_flipped_sign(entry, countdown);
  // A flipped sign before a zero, or in a factor that cancels, does not change the value.
  const bool turns = places > 0 && differ(entry, other, draw);
  entry = turns ? other : entry + call_of("cos", {number(1)}) / number(1000);
  return claims;
}

}  // namespace elgen::test::random
