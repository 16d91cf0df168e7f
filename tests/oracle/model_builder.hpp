// Builds Models from short texts, so that tests do not depend on the file format.
//
// Expressions: + - * / ^ ( ), the functions of functions.def, sqrt, ddt(e) for de/dt, components
// x(P) y(P) z(P) of a point P, t, pi, and names. The coordinate `x` has the rate `x_d` and the
// acceleration `x_dd`. Exponents are `^2`, `^-1`, `^(1/2)`.
#pragma once

#include <cln/rational_io.h>
#include <cln/real.h>

#include <cctype>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "elgen/model.hpp"
#include "support/text.hpp"

namespace elgen::test {

/// The exact value of a decimal or a fraction: "-1.5e-8", "1/3".
inline cln::cl_RA exact(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos)
    return exact(text.substr(0, slash)) / exact(text.substr(slash + 1));
  const std::size_t e = text.find_first_of("eE");
  std::string digits = text.substr(0, e);
  long exponent = e == std::string::npos ? 0 : std::stol(text.substr(e + 1));
  const std::size_t dot = digits.find('.');
  if (dot != std::string::npos) {
    exponent -= static_cast<long>(digits.size() - dot - 1);
    digits.erase(dot, 1);
  }
  const cln::cl_RA mantissa = cln::cl_I(digits.c_str());
  return mantissa * cln::expt(cln::cl_RA(10), cln::cl_I(exponent));
}

class ModelBuilder {
 public:
  Model model;

  ModelBuilder& coordinate(const std::string& name, const std::string& unit_text = "") {
    Coordinate c;
    c.name = c.identifier = name;
    c.unit_text = unit_text;
    const std::uint32_t index = append_coordinate(model, c);
    const std::uint32_t rate = model.coordinates[index].velocity;
    names_[name] = leaf_node(Opcode::coordinate, index);
    names_[name + "_d"] = leaf_node(Opcode::velocity, rate);
    names_[name + "_p"] = leaf_node(Opcode::momentum, rate);
    names_[name + "_dd"] = leaf_node(Opcode::acceleration, rate);
    return *this;
  }

  /// Quaternion `name_w` to `name_z`, angular velocity `name1_d` to `name3_d`.
  ModelBuilder& rotation(const std::string& name) {
    Rotation r;
    r.name = r.identifier = name;
    const Rotation& added = model.rotations[append_rotation(model, r)];
    for (std::uint32_t i = 0; i < quaternion_size; ++i) {
      const std::uint32_t index = added.first_coordinate + i;
      names_[model.coordinates[index].name] = leaf_node(Opcode::coordinate, index);
    }
    for (std::uint32_t i = 0; i < axis_count; ++i) {
      const std::uint32_t index = added.first_velocity + i;
      names_[name + std::to_string(i + 1) + "_d"] = leaf_node(Opcode::velocity, index);
    }
    return *this;
  }

  ModelBuilder& parameter(const std::string& name, const std::string& value) {
    Parameter p;
    p.name = p.identifier = name;
    p.value = exact(value);
    names_[name] = leaf_node(Opcode::parameter, model.parameters.size());
    model.parameters.push_back(p);
    return *this;
  }

  ModelBuilder& input(const std::string& name, std::optional<std::uint32_t> on = {}) {
    Input u;
    u.name = u.identifier = name;
    u.velocity = on;
    names_[name] = leaf_node(Opcode::input, model.inputs.size());
    model.inputs.push_back(u);
    return *this;
  }

  ModelBuilder& definition(const std::string& name, const std::string& value) {
    return named(model.definitions, NamedKind::definition, name, value);
  }

  ModelBuilder& prescribed(const std::string& name, const std::string& value) {
    return named(model.prescribed, NamedKind::prescribed, name, value);
  }

  ModelBuilder& point(const std::string& name, const std::vector<std::string>& at,
                      const std::string& mass = "") {
    Point p;
    p.name = p.identifier = name;
    p.dimension = static_cast<std::uint32_t>(at.size());
    p.position = padded(at);
    if (!mass.empty()) p.mass = expression(mass);
    points_[name] = static_cast<std::uint32_t>(model.points.size());
    model.points.push_back(p);
    return *this;
  }

  ModelBuilder& gravity(const std::vector<std::string>& vector) {
    model.gravity = padded(vector);
    return *this;
  }

  ModelBuilder& T(const std::string& text) { return set(model.energies.T, text); }
  ModelBuilder& V(const std::string& text) { return set(model.energies.V, text); }
  ModelBuilder& D(const std::string& text) { return set(model.energies.D, text); }
  ModelBuilder& L(const std::string& text) { return set(model.energies.L, text); }

  ModelBuilder& force_on(std::uint32_t velocity, const std::string& value) {
    Force f;
    f.velocity = velocity;
    f.value = {expression(value)};
    model.forces.push_back(f);
    return *this;
  }

  ModelBuilder& force_at(const std::string& point, const std::vector<std::string>& value,
                         const std::string& from = "") {
    Force f;
    f.point = points_.at(point);
    if (!from.empty()) f.reaction_point = points_.at(from);
    const auto components = padded(value);
    f.value.assign(components.begin(), components.end());
    model.forces.push_back(f);
    return *this;
  }

  /// Adds the constraint `value` = 0, on positions if `is_position`, otherwise on velocities.
  ModelBuilder& constraint(const std::string& value, bool is_position = true) {
    Constraint c;
    c.name = c.identifier = "c" + std::to_string(model.constraints.size() + 1);
    c.value = expression(value);
    c.is_position = is_position;
    model.constraints.push_back(c);
    return *this;
  }

  /// Sets the stabilisation gains of the last constraint.
  ModelBuilder& stabilised(const std::string& omega, const std::string& zeta) {
    model.constraints.back().omega = expression(omega);
    model.constraints.back().zeta = expression(zeta);
    return *this;
  }

  ModelBuilder& output(const std::vector<std::string>& values) {
    UserOutput output;
    for (const std::string& value : values) output.values.push_back(expression(value));
    model.outputs.push_back(output);
    return *this;
  }

  std::array<ExpressionId, 3> padded(const std::vector<std::string>& components) {
    std::array<ExpressionId, 3> ids{};
    for (std::size_t c = 0; c < 3; ++c) {
      ids[c] = expression(c < components.size() ? components[c] : "0");
    }
    return ids;
  }

  ExpressionId expression(const std::string& text) {
    rest_ = text;
    return sum();
  }

 private:
  static Expression leaf_node(Opcode kind, std::size_t index) {
    return {.kind = ExpressionKind::leaf, .leaf = kind, .index = static_cast<std::uint32_t>(index)};
  }

  ModelBuilder& set(std::optional<ExpressionId>& energy, const std::string& text) {
    energy = expression(text);
    return *this;
  }

  ModelBuilder& named(std::vector<NamedExpression>& list, NamedKind kind, const std::string& name,
                      const std::string& value) {
    NamedExpression entry;
    entry.name = entry.identifier = name;
    entry.value = expression(value);
    names_[name] = {.kind = ExpressionKind::named,
                    .named = kind,
                    .index = static_cast<std::uint32_t>(list.size())};
    list.push_back(entry);
    return *this;
  }

  ExpressionId add(Expression e) {
    model.expressions.push_back(std::move(e));
    return static_cast<ExpressionId>(model.expressions.size() - 1);
  }

  ExpressionId node(ExpressionKind kind, std::vector<ExpressionId> operands) {
    Expression e;
    e.kind = kind;
    e.operands = std::move(operands);
    return add(std::move(e));
  }

  bool take(char c) {
    while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

  template <class Accept>
  std::string token(const Accept& accept) {
    take(' ');
    std::size_t n = 0;
    while (n < rest_.size() && accept(n)) ++n;
    const std::string word(rest_.substr(0, n));
    rest_.remove_prefix(n);
    return word;
  }

  ExpressionId sum() {
    std::vector<ExpressionId> terms{product()};
    for (;;) {
      if (take('+')) {
        terms.push_back(product());
      } else if (take('-')) {
        terms.push_back(node(ExpressionKind::negate, {product()}));
      } else {
        return terms.size() == 1 ? terms[0] : node(ExpressionKind::add, terms);
      }
    }
  }

  ExpressionId product() {
    if (take('-')) return node(ExpressionKind::negate, {product()});
    ExpressionId result = power();
    for (;;) {
      if (take('*')) {
        result = node(ExpressionKind::multiply, {result, power()});
      } else if (take('/')) {
        result = node(ExpressionKind::divide, {result, power()});
      } else {
        return result;
      }
    }
  }

  ExpressionId power() {
    const ExpressionId base = atom();
    if (!take('^')) return base;
    const bool bracket = take('(');
    const std::string digits = token([this, bracket](std::size_t n) {
      return std::isdigit(rest_[n]) != 0 || rest_[n] == '-' || (bracket && rest_[n] == '/');
    });
    if (bracket) take(')');
    return power_of(base, exact(digits));
  }

  ExpressionId power_of(ExpressionId base, const cln::cl_RA& exponent) {
    const ExpressionId id = node(ExpressionKind::power, {base});
    model.expressions[id].number = exponent;
    return id;
  }

  ExpressionId atom() {
    if (take('(')) {
      const ExpressionId inner = sum();
      take(')');
      return inner;
    }
    take(' ');
    if (std::isdigit(rest_.front()) != 0) return number();
    const std::string word = token([this](std::size_t n) {
      return std::isalnum(rest_[n]) != 0 || rest_[n] == '_' || rest_[n] == '[' || rest_[n] == ']';
    });
    return take('(') ? call(word) : leaf(word);
  }

  ExpressionId number() {
    const std::string digits = token([this](std::size_t n) {
      const char c = rest_[n];
      const bool sign = n > 0 && (c == '-' || c == '+') && rest_[n - 1] == 'e';
      return std::isdigit(c) != 0 || c == '.' || c == 'e' || sign;
    });
    const ExpressionId id = node(ExpressionKind::number, {});
    model.expressions[id].number = exact(digits);
    return id;
  }

  ExpressionId leaf(const std::string& word) {
    if (word == "t") return add(leaf_node(Opcode::time, 0));
    return add(word == "pi" ? Expression{.kind = ExpressionKind::pi} : names_.at(word));
  }

  ExpressionId call(const std::string& word) {
    const std::string axes = "xyz";
    if (word.size() == 1 && mentions(axes, word)) {
      const std::string point = token([this](std::size_t n) { return rest_[n] != ')'; });
      take(')');
      Expression e;
      e.kind = ExpressionKind::named;
      e.named = NamedKind::point;
      e.index = points_.at(point);
      e.component = static_cast<std::uint32_t>(axes.find(word));
      return add(e);
    }
    std::vector<ExpressionId> arguments{sum()};
    while (take(',')) arguments.push_back(sum());
    take(')');
    if (word == "sqrt") return power_of(arguments[0], exact("1/2"));
    if (word == "ddt") return node(ExpressionKind::time_derivative, arguments);
    const ExpressionId id = node(ExpressionKind::function, arguments);
    for (const FunctionRow& row : function_table()) {
      if (row.name == word) model.expressions[id].function = row.id;
    }
    return id;
  }

  std::string_view rest_ = {};
  std::map<std::string, Expression> names_ = {{"E", leaf_node(Opcode::energy, 0)}};
  std::map<std::string, std::uint32_t> points_ = {};
};

}  // namespace elgen::test
