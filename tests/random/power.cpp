// The generalised force on a velocity: power of all forces and inputs per unit of this velocity.
#include <algorithm>
#include <stdexcept>

#include "random/motion.hpp"

namespace elgen::test::random {

namespace {

/// The name and component of the rate `on`: ("attitude", 1) for "attitude[2]" of a rotation, and
/// (`on`, 0) for other coordinates.
std::pair<std::string, std::size_t> rate_named(const Layout& layout, const std::string& on) {
  const auto bracket = on.find('[');
  if (bracket == std::string::npos) return {on, 0};
  const bool is_rotation =
      std::any_of(layout.places.begin(), layout.places.end(), [&](const Layout::Place& place) {
        return place.is_rotation && place.name == on.substr(0, bracket);
      });
  if (!is_rotation) return {on, 0};
  return {on.substr(0, bracket), std::stoul(on.substr(bracket + 1)) - 1};
}

}  // namespace

Jet Motion::power_of(const Force& force, unsigned direction) {
  Vector value = evaluated(force.value, *this);
  for (Jet& entry : value) entry = entry.without(time_infinitesimal).without(direction);
  if (!force.on.empty()) {
    std::string on = force.on;
    if (force.repeat > 0)
      on.replace(on.find("[i]"), 3, "[" + std::to_string(indices.at("i")) + "]");
    const auto [name, component] = rate_named(layout_, on);
    return value[0] * v_[layout_.place(name).v + component].along(direction);
  }
  const std::string axes = !force.in.empty()      ? force.in
                           : !force.frame.empty() ? force.frame
                                                  : "world";
  if (axes != "world") value = product(pose_of(axes).R, value);
  const auto power = [&](const std::string& name) {
    Vector rate;
    if (force.at.empty()) {
      rate = spin_of(name);
    } else {
      for (const Jet& x : position_of(name, "")) rate.push_back(x.along(time_infinitesimal));
    }
    for (Jet& entry : rate) entry = entry.along(direction);
    for (Jet& entry : value) entry = entry.without(time_infinitesimal).without(direction);
    return dot(value, rate);
  };
  const Jet acting = power(force.at.empty() ? force.frame : force.at);
  return force.from.empty() ? acting : acting - power(force.from);
}

Jet Motion::force_along(unsigned direction) {
  Jet sum;
  for (const Force& force : system_.model.forces) {
    for (int i = 1; i <= std::max(force.repeat, 1); ++i) {
      if (force.repeat > 0) indices["i"] = i;
      sum += power_of(force, direction);
      indices.clear();
    }
  }
  for (std::size_t k = 0; k < system_.model.inputs.size(); ++k) {
    const Input& input = system_.model.inputs[k];
    if (input.on.empty()) continue;
    const auto [name, component] = rate_named(layout_, input.on);
    sum += u_[k] * v_[layout_.place(name).v + component].along(direction);
  }
  return sum;
}

}  // namespace elgen::test::random
