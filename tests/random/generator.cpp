// Draws coordinates, parameters and energies, and assembles models.
#include "random/generator.hpp"

namespace elgen::test::random {

Generator::Generator(std::uint64_t seed) : draw_(seed * 0x9E3779B97F4A7C15U + 1, seed % 2 == 1) {
  made_.model.name = "random_" + std::to_string(seed);
}

void Generator::add_coordinates(int count) {
  for (int i = 1; i <= count; ++i) {
    const std::string called = "q" + std::to_string(i);
    made_.model.coordinates.push_back({.name = called});
    positions_.push_back(name(called));
    rates_.push_back(rate(name(called)));
  }
}

/// A positive parameter, a new one in half of the cases.
Expression Generator::parameter() {
  auto& parameters = made_.model.parameters;
  if (parameters.empty() || (draw_.chance(50) && parameters.size() < 12)) {
    const std::string called = "p" + std::to_string(parameters.size() + 1);
    parameters.push_back({.name = called, .values = {draw_.positive()}});
    return name(called);
  }
  const Parameter& known = draw_.one_of(parameters);
  return known.is_array ? name(known.name, "1") : name(known.name);
}

Expression Generator::any_constant() { return draw_.chance(40) ? parameter() : draw_.constant(); }

Expression Generator::positive_constant() {
  return draw_.chance(50) ? parameter() : draw_.positive();
}

/// 1/2 c (v_1 + f_2(q) v_2 + ...)^2 with c > 0, which is never negative.
Expression Generator::squared_sum() {
  Expression sum = rates_[0];
  for (std::size_t i = 1; i < rates_.size(); ++i) {
    sum = sum + draw_.function_of(positions_) * rates_[i];
  }
  return positive_constant() / number(2) * raised(sum, 2);
}

/// Makes a model of T and V, sometimes with terms linear in the rates.
void Generator::make_energies() {
  add_coordinates(1 + draw_.below(3));
  Model& model = made_.model;
  Expression T = squared_sum();
  for (const Expression& v : rates_) {
    const Expression mass = draw_.chance(40)
                                ? positive_constant() + raised(draw_.function_of(positions_), 2)
                                : positive_constant();
    T = T + mass / number(2) * raised(v, 2);
  }
  if (draw_.chance(30))
    T = T + any_constant() * draw_.function_of(positions_) * draw_.one_of(rates_);
  model.T = T;
  add_terms();
}

/// Adds a potential energy: functions of q with constant factors. Some factors are definitions.
void Generator::add_terms() {
  Model& model = made_.model;
  const int count = 1 + draw_.below(3);
  for (int i = 0; i < count; ++i) {
    Expression factor = any_constant();
    if (draw_.chance(25)) {
      const std::string called = "d" + std::to_string(model.definitions.size() + 1);
      model.definitions.push_back({called, factor + any_constant()});
      factor = name(called);
    }
    const Expression term = factor * draw_.function_of(positions_);
    model.V = model.V ? (draw_.chance(70) ? model.V + term : model.V - term) : term;
  }
  if (draw_.chance(25)) {  // a velocity-dependent potential
    model.V = model.V + any_constant() * draw_.function_of(positions_) * draw_.one_of(rates_);
  }
}

/// Makes a model of L. Each rate adds fourth powers and square roots to L in some cases.
void Generator::make_lagrangian() {
  add_coordinates(1 + draw_.below(2));
  Expression L = squared_sum();
  for (const Expression& v : rates_) {
    L = L + positive_constant() / number(2) * raised(v, 2);
    if (draw_.chance(50)) L = L + draw_.positive() * raised(v, 4);
    if (draw_.chance(20)) L = L + draw_.positive() * call_of("sqrt", {number(1) + raised(v, 2)});
  }
  L = L - any_constant() * draw_.function_of(positions_);
  made_.model.L = L + any_constant() * draw_.function_of(positions_) * draw_.one_of(rates_);
}

/// Makes a model for approximations: q = 0 is an equilibrium for all values of the parameters.
void Generator::make_quiet() {
  add_coordinates(1 + draw_.below(3));
  Model& model = made_.model;
  Expression T = squared_sum();
  for (const Expression& v : rates_) {
    T = T + (positive_constant() + raised(call_of("sin", {draw_.one_of(positions_)}), 2)) /
                number(2) * raised(v, 2);
  }
  model.T = T;
  for (const Expression& q : positions_) {
    const Expression other = draw_.one_of(positions_);
    const Expression wells[] = {call_of("cos", {any_constant() * q}),
                                raised(q, 2),
                                raised(q, 3),
                                call_of("exp", {-raised(q - other, 2)}),
                                call_of("sqrt", {number(1) + raised(q, 2)}),
                                call_of("sin", {q}) * call_of("tanh", {other})};
    const Expression term = any_constant() * wells[draw_.below(6)];
    model.V = model.V ? model.V + term : term;
  }
  Scene& scene = made_.scene;
  scene.is_present = true;
  scene.order = 1 + draw_.below(4);
  for (const Coordinate& coordinate : model.coordinates) {
    scene.about.push_back({coordinate.name, number(0)});
  }
}

/// w t if the model has units, otherwise t. The parameter w has no declared unit.
Expression Generator::clock() { return has_units_ ? name("w") * time() : time(); }

/// The product w `constant`, which has an unknown unit. 0 and expressions with names are unchanged.
Expression Generator::without_unit(const Expression& constant) const {
  const bool is_zero = printed(constant) == "0";
  return is_zero || has_names(constant) ? constant : name("w") * constant;
}

/// Multiplies constant masses, lengths, inertias and gravity by w, which has no declared unit. Bare
/// numbers would be unit errors in a model with a rotation.
void Generator::leave_units_out() {
  const auto all = [&](std::vector<Expression>& list) {
    for (Expression& expression : list) expression = without_unit(expression);
  };
  Model& model = made_.model;
  for (Frame& frame : model.frames) {
    all(frame.translate);
    const bool is_dh = frame.turn == Turn::dh_standard || frame.turn == Turn::dh_modified;
    for (std::size_t i = 0; is_dh && i < 4; i += 2) {
      frame.numbers[i] = without_unit(frame.numbers[i]);
    }
  }
  for (Point& point : model.points) {
    all(point.at);
    if (point.mass) point.mass = without_unit(point.mass);
  }
  for (Body& body : model.bodies) {
    all(body.com);
    all(body.inertia);
    if (body.mass) body.mass = without_unit(body.mass);
  }
  all(model.gravity);
}

System Generator::system() {
  const int kind = draw_.below(20);
  if (kind < 4)
    make_energies();
  else if (kind < 6)
    make_lagrangian();
  else if (kind < 9)
    make_planar();
  else if (kind < 11)
    make_array();
  else if (kind < 16)
    make_spatial(false);
  else if (kind < 18)
    make_spatial(true);
  else
    make_quiet();
  if (made_.scene.order == 0) add_prescribed();
  add_dissipation();
  add_inputs();
  if (made_.scene.order == 0) add_forces();
  add_outputs();
  if (has_units_) leave_units_out();
  add_scene();
  return made_;
}

}  // namespace elgen::test::random
