// Draws prescribed motion, dissipation, inputs, forces and outputs.
#include "random/generator.hpp"

namespace elgen::test::random {

void Generator::add_prescribed() {
  if (!draw_.chance(25)) return;
  const Expression t = clock();
  const Expression functions[] = {
      draw_.constant() * t, draw_.constant() * call_of("sin", {draw_.constant() * t}),
      draw_.constant() + raised(t, 2) / number(4), call_of("exp", {-t}) * draw_.constant()};
  made_.model.prescribed.push_back({"drive", functions[draw_.below(4)]});
  const Expression drive = name("drive");
  Model& model = made_.model;
  if (!model.frames.empty()) {
    Frame& frame =
        model.frames[static_cast<std::size_t>(draw_.below(static_cast<int>(model.frames.size())))];
    if (frame.turn == Turn::rotate && draw_.chance(60)) {
      frame.turns[0].angle = frame.turns[0].angle + drive;
    } else {
      if (frame.translate.empty() && frame.turn != Turn::dh_standard &&
          frame.turn != Turn::dh_modified)
        frame.translate = {number(0), drive, number(0)};
    }
  } else if (!model.points.empty() && model.points[0].repeat == 0) {
    model.points[0].at[0] = model.points[0].at[0] + drive;
  } else if (model.T && draw_.chance(50)) {
    model.T = model.T + positive_constant() / number(2) * raised(draw_.one_of(rates_) + drive, 2);
  }
  const Expression term = draw_.function_of(positions_) * drive;
  if (model.L)
    model.L = model.L + term;
  else
    model.V = model.V ? model.V + term : term;
}

void Generator::add_dissipation() {
  if (!draw_.chance(40)) return;
  Expression D = positive_constant() / number(2) * raised(draw_.one_of(rates_), 2);
  if (draw_.chance(40))
    D = D + positive_constant() * raised(draw_.one_of(rates_) - draw_.one_of(rates_), 2);
  made_.model.D = D;
}

void Generator::add_inputs() {
  const int count = draw_.below(3);
  for (int i = 1; i <= count; ++i) {
    const std::string called = "u" + std::to_string(i);
    const Expression& on = draw_.one_of(positions_);
    const bool acts = made_.scene.order > 0 || draw_.chance(60);
    made_.model.inputs.push_back({called, acts ? printed(on) : ""});
    // Without `on` an input acts only through a force that names it.
    if (!acts) {
      made_.model.forces.push_back({.name = "drive_" + called,
                                    .value = {draw_.function_of(positions_) * name(called)},
                                    .on = printed(draw_.one_of(positions_))});
    }
  }
}

/// A force component: affine in the inputs, or any function of the state.
Expression Generator::force_size() {
  const Expression constant = any_constant();
  const Expression v = draw_.one_of(rates_);
  const Expression q = draw_.one_of(positions_);
  if (!made_.model.frames.empty() && draw_.chance(15)) {
    const std::string frame = draw_.one_of(made_.model.frames).name;
    const std::string axes = draw_.chance(50) ? draw_.one_of(made_.model.frames).name : "";
    return constant * turning(frame, axes, draw_.below(3));
  }
  switch (draw_.below(7)) {
    case 0:
      return -constant * call_of("tanh", {v / draw_.positive()});
    case 1:
      return constant * call_of("abs", {v}) * v;
    case 2:
      return constant * call_of("max", {q, v});
    case 3:
      return constant * call_of("sign", {v});
    case 4:
      return constant * call_of("cos", {q}) + any_constant() * call_of("sin", {clock()});
    case 5:
      if (!made_.model.inputs.empty()) {
        const Input* input = nullptr;
        const auto drawn = [&] {
          input = &draw_.one_of(made_.model.inputs);
          return name(input->name);
        };
        const Expression driven = draw_.function_of(positions_) * drawn();
        if (input->on.empty()) return driven;  // only an input without `on` may be named by a force
      }
      return constant * q;
    default:
      return constant * draw_.function_of(positions_) * v;
  }
}

void Generator::add_force(int index) {
  Model& model = made_.model;
  const std::string called = "force_" + std::to_string(index);
  const bool has_points = !model.points.empty() && model.points[0].repeat == 0;
  if (has_points && draw_.chance(50)) {
    const Point& at = draw_.one_of(model.points);
    Force force{.name = called, .value = {}, .at = at.name};
    for (std::size_t i = 0; i < at.at.size(); ++i) {
      force.value.push_back(draw_.chance(30) ? number(0) : force_size());
    }
    const Point& other = draw_.one_of(model.points);
    if (other.name != at.name) force.from = other.name;
    if (at.at.size() == 3 && draw_.chance(40)) force.in = draw_.one_of(model.frames).name;
    model.forces.push_back(force);
    return;
  }
  if (!model.frames.empty() && draw_.chance(60)) {
    const std::string frame = draw_.one_of(model.frames).name;
    Force force{.name = called, .value = {force_size(), number(0), force_size()}, .frame = frame};
    const std::string other = draw_.one_of(model.frames).name;
    if (other != frame) force.from = other;
    if (draw_.chance(30)) force.in = "world";
    model.forces.push_back(force);
    return;
  }
  model.forces.push_back(
      {.name = called, .value = {force_size()}, .on = printed(draw_.one_of(positions_))});
}

void Generator::add_forces() {
  const int count = draw_.below(3);
  for (int i = 1; i <= count; ++i) add_force(i);
}

void Generator::add_outputs() {
  Model& model = made_.model;
  if (draw_.chance(25)) {
    model.outputs.push_back({.name = "measured",
                             .value = {draw_.function_of(positions_) * any_constant(),
                                       any_constant() - draw_.function_of(positions_)},
                             .has_jacobian = draw_.chance(60)});
  }
  if (!model.frames.empty() && draw_.chance(35)) {
    model.outputs.push_back({.name = "tip",
                             .frame = draw_.one_of(model.frames).name,
                             .in_frame_axes = draw_.chance(40),
                             .has_jacobian = draw_.chance(70)});
  }
}

}  // namespace elgen::test::random
