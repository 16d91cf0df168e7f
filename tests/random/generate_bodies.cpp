// Draws points, bodies and frames.
#include "random/generator.hpp"

namespace elgen::test::random {

/// The angle of a joint: usually a coordinate q, otherwise c + q, c - q, -q, 2 q, q/2 or q_i + q_j.
Expression Generator::angle() {
  const Expression q = draw_.one_of(positions_);
  switch (draw_.below(8)) {
    case 0:
      return q + draw_.constant();
    case 1:
      return -q;
    case 2:
      return draw_.constant() - q;
    case 3:
      return number(2) * q;
    case 4:
      return q + draw_.one_of(positions_);
    case 5:
      return q / number(2);
    default:
      return q;
  }
}

/// A position with components 0, constants, parameters and, if `moving`, coordinates.
std::vector<Expression> Generator::offset(int dimension, bool moving) {
  std::vector<Expression> place;
  for (int axis = 0; axis < dimension; ++axis) {
    const int kind = draw_.below(moving ? 5 : 4);
    if (kind == 0) place.push_back(number(0));
    if (kind == 1 || kind == 2) place.push_back(any_constant());
    if (kind == 3) place.push_back(parameter());
    if (kind == 4) {
      place.push_back(draw_.chance(50) ? draw_.one_of(positions_)
                                       : draw_.one_of(positions_) + any_constant());
    }
  }
  return place;
}

/// Makes a planar chain of point masses on rods or curves. Often a body rotates near a point mass.
void Generator::make_planar() {
  add_coordinates(1 + draw_.below(3));
  Model& model = made_.model;
  const auto links = static_cast<int>(positions_.size());
  for (int i = 0; i < links; ++i) {
    const Expression length = any_constant();
    const Expression turned = draw_.chance(50) ? positions_[static_cast<std::size_t>(i)] : angle();
    std::vector<Expression> at{length * call_of("sin", {turned}),
                               length * call_of("cos", {turned})};
    if (draw_.chance(30)) at[1] = draw_.function_of({positions_[static_cast<std::size_t>(i)]});
    for (int axis = 0; axis < 2 && i > 0; ++axis) {
      auto& entry = at[static_cast<std::size_t>(axis)];
      entry = component(model.points.back().name, axis) + entry;
    }
    model.points.push_back(
        {.name = "P" + std::to_string(i + 1), .at = at, .mass = positive_constant()});
  }
  if (draw_.chance(60)) {
    const std::string carrier = draw_.one_of(model.points).name;
    const Expression spin = rate(angle());
    model.bodies.push_back({.name = "B1",
                            .mass = positive_constant(),
                            .com = {component(carrier, 0) + any_constant(), component(carrier, 1)},
                            .inertia = {positive_constant()},
                            .spin = {spin}});
  }
  if (draw_.chance(70)) model.gravity = {number(0), -any_constant()};
  if (draw_.chance(30)) model.gravity = {any_constant(), any_constant()};
  if (draw_.chance(30)) model.V = any_constant() * draw_.function_of(positions_);
  for (Coordinate& coordinate : model.coordinates) coordinate.armature = positive_constant();
}

/// Makes a model with arrays of n coordinates, parameters and points, and sums over the index.
void Generator::make_array() {
  const int n = 2 + draw_.below(2);
  Model& model = made_.model;
  model.coordinates.push_back({.name = "r", .repeat = n});
  Parameter lengths{.name = "l", .values = {}, .is_array = true};
  Parameter masses{.name = "m", .values = {}, .is_array = true};
  for (int i = 1; i <= n; ++i) {
    positions_.push_back(name("r", std::to_string(i)));
    rates_.push_back(rate(positions_.back()));
    lengths.values.push_back(draw_.positive());
    masses.values.push_back(draw_.positive());
  }
  model.parameters = {lengths, masses};
  const Expression k = made({.kind = NodeKind::index, .text = "k"});
  const Expression r = name("r", "k");
  const Expression in_sum = draw_.chance(50) ? name("l", "k") : name("l", "k") * k;
  const Expression shift = draw_.constant();
  model.points.push_back({.name = "P",
                          .at = {name("l", "i") * call_of("sin", {name("r", "i") + shift}),
                                 sum_over("k", 1, n, in_sum * call_of("cos", {r}))},
                          .mass = name("m", "i"),
                          .repeat = n});
  model.V = sum_over("k", 1, n, any_constant() * raised(r, 2)) +
            any_constant() * draw_.function_of(positions_);
  if (draw_.chance(60)) model.gravity = {number(0), -any_constant()};
  model.coordinates[0].armature = positive_constant();
  if (draw_.chance(60)) {
    model.forces.push_back({.name = "pull",
                            .value = {-any_constant() * rate(name("r", "i")) * name("l", "i")},
                            .on = "r[i]",
                            .repeat = n});
  }
  if (draw_.chance(30)) {
    model.outputs.push_back(
        {.name = "place",
         .value = {component("P", 0, "1"), component("P", 1, std::to_string(n))},
         .has_jacobian = true});
  }
}

/// Draws the rotation of a frame in its parent.
void Generator::turn(Frame& frame) {
  const auto oblique = [&]() -> std::vector<Expression> {
    const Expression one = number(1);
    const Expression zero = number(0);
    switch (draw_.below(4)) {
      case 0:
        return {one, one, one};
      case 1:
        return {zero, draw_.chance(50) ? -one : one, one};
      case 2:
        return {one, one, zero};
      default:
        return {draw_.constant(), draw_.constant(), draw_.rational()};
    }
  };
  const auto mount = [&] { return draw_.chance(40) ? constant_pi() / number(2) : any_constant(); };
  switch (draw_.below(8)) {
    case 0:
      frame.turn = Turn::rotate;
      frame.turns.push_back({.axis = oblique(), .angle = angle()});
      break;
    case 1:
      frame.turn = Turn::rotate;
      frame.turns.push_back({.letter = draw_.below(3), .angle = mount()});
      frame.turns.push_back({.letter = draw_.below(3), .angle = angle()});
      break;
    case 2:
      frame.turn = Turn::rpy;
      frame.numbers = {draw_.constant(), draw_.constant(), draw_.constant()};
      if (draw_.chance(50)) frame.numbers[static_cast<std::size_t>(draw_.below(3))] = angle();
      break;
    case 3:
    case 4:
      frame.turn = draw_.chance(50) ? Turn::dh_standard : Turn::dh_modified;
      frame.numbers = {any_constant(), mount(), any_constant(), angle()};
      if (draw_.chance(25)) frame.numbers[2] = draw_.one_of(positions_);
      break;
    case 5:
      frame.turn = Turn::quaternion;
      frame.numbers = {draw_.constant(), draw_.constant(), draw_.constant(), draw_.constant()};
      break;
    case 6:
      break;
    default:
      frame.turn = Turn::rotate;
      frame.turns.push_back({.letter = draw_.below(3), .angle = angle()});
  }
}

void Generator::add_frame(const std::string& called, const std::string& parent) {
  Frame frame{.name = called, .parent = parent};
  turn(frame);
  const bool is_dh = frame.turn == Turn::dh_standard || frame.turn == Turn::dh_modified;
  if (!is_dh && (draw_.chance(70) || frame.turn == Turn::none)) {
    frame.translate = offset(3, frame.turn == Turn::none || draw_.chance(30));
  }
  made_.model.frames.push_back(frame);
}

/// Adds a body, or sometimes a point mass, to the frame.
void Generator::add_body(const std::string& called, const std::string& frame) {
  if (draw_.chance(25)) {
    made_.model.points.push_back({.name = "P" + called,
                                  .at = offset(3, false),
                                  .mass = positive_constant(),
                                  .frame = frame});
    return;
  }
  Body body{.name = called, .frame = frame};
  if (draw_.chance(85)) body.mass = positive_constant();
  if (draw_.chance(70)) body.com = offset(3, false);
  if (draw_.chance(80) || !body.mass) {
    // The shift from the origin to com subtracts at most m |com|^2 = 30: m <= 10, |com_i| <= 1.
    body.is_about_origin = body.mass && draw_.chance(25);
    for (Expression& entry : body.com) {
      if (body.is_about_origin) entry = draw_.positive() / number(10);
    }
    // The diagonal is at least 4 and the products are at most 1, so the inertia is positive
    // definite.
    const Expression least = number(body.is_about_origin ? 40 : 4);
    for (int i = 0; i < 3; ++i) body.inertia.push_back(least + draw_.positive());
    for (int i = 0; i < 3 && draw_.chance(95); ++i) {
      if (i == 0 && draw_.chance(50)) break;
      body.inertia.push_back(draw_.chance(30) ? number(0) : draw_.positive() / number(10));
    }
    if (body.inertia.size() != 6) body.inertia.resize(3);
  }
  made_.model.bodies.push_back(body);
}

/// Makes a model of bodies on nested frames that rotate and translate. If `turns`, a rotation
/// coordinate turns one of the first two frames.
void Generator::make_spatial(bool turns) {
  add_coordinates(turns ? draw_.below(2) + 1 : 1 + draw_.below(3));
  Model& model = made_.model;
  has_units_ = turns;
  if (turns) model.parameters.push_back({.name = "w", .values = {number(1)}});
  const int frames = 1 + draw_.below(3) + (turns ? 1 : 0);
  const int floating = turns ? draw_.below(2) : -1;
  for (int i = 0; i < frames; ++i) {
    const std::string parent =
        i == 0 ? "world"
               : model.frames[static_cast<std::size_t>(draw_.chance(75) ? i - 1 : draw_.below(i))]
                     .name;
    const std::string called = "F" + std::to_string(i + 1);
    if (i == floating) {
      model.coordinates.push_back({.name = "att", .is_rotation = true});
      model.frames.push_back({.name = called,
                              .parent = parent,
                              .translate = offset(3, draw_.chance(60)),
                              .turn = Turn::rotation,
                              .rotation = "att"});
      add_body("B" + std::to_string(i + 1), called);
      // The rotation needs an inertia about every axis, whatever other bodies the frame has.
      model.bodies.push_back(
          {.name = "rotor",
           .inertia = {positive_constant(), positive_constant(), draw_.positive()},
           .frame = called});
      continue;
    }
    add_frame(called, parent);
    add_body("B" + std::to_string(i + 1), called);
  }
  if (draw_.chance(70)) model.gravity = {number(0), number(0), -any_constant()};
  if (draw_.chance(20)) model.gravity = {any_constant(), any_constant(), any_constant()};
  if (draw_.chance(40)) model.V = any_constant() * draw_.function_of(positions_);
  for (Coordinate& coordinate : model.coordinates) {
    if (!coordinate.is_rotation) coordinate.armature = positive_constant();
  }
}

}  // namespace elgen::test::random
