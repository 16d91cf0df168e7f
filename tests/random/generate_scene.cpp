// Draws scenes: locked coordinates, fixed parameters, and options of emission.
#include "random/generator.hpp"

namespace elgen::test::random {

/// Locks a coordinate, and perhaps a rotation at a constant; at least one coordinate stays free.
void Generator::add_locks(Scene& scene) {
  std::vector<std::string> lockable;
  for (const Expression& q : positions_) lockable.push_back(printed(q));
  bool has_rotation = false;
  for (const Coordinate& coordinate : made_.model.coordinates) {
    has_rotation = has_rotation || coordinate.is_rotation;
  }
  if (lockable.size() + (has_rotation ? 1 : 0) < 2) return;
  const std::string held = draw_.one_of(lockable);
  const Expression t = time();
  const Expression values[] = {draw_.constant(), number(0), draw_.constant() * t,
                               draw_.constant() * call_of("sin", {draw_.constant() * t}),
                               call_of("cos", {draw_.constant()}) + raised(t, 2) / number(3)};
  scene.locks.push_back({held, {values[draw_.below(5)]}, draw_.chance(50)});
  if (has_rotation && lockable.size() > 1 && draw_.chance(30)) {
    scene.locks.push_back({"att",
                           {draw_.constant(), draw_.constant(), draw_.constant(), draw_.constant()},
                           draw_.chance(50)});
  }
}

void Generator::add_fixed(Scene& scene) {
  if (draw_.chance(25)) {
    scene.fixes_all = true;
    return;
  }
  if (has_units_) scene.fixed.push_back({"w", number(1)});
  for (const Parameter& parameter : made_.model.parameters) {
    if (!parameter.is_array && parameter.name != "w" && draw_.chance(40)) {
      scene.fixed.push_back({parameter.name, draw_.positive()});
    }
  }
}

void Generator::add_emission(Scene& scene) {
  scene.is_c99 = draw_.chance(30);
  scene.has_eigen = !scene.is_c99 && draw_.chance(40);
  scene.is_float = draw_.chance(25);
  scene.is_column_major = draw_.chance(30);
  if (draw_.chance(15)) scene.form = "recursive";
  scene.has_lone_sines = draw_.chance(30);
}

void Generator::add_scene() {
  Scene& scene = made_.scene;
  if (!scene.is_present && !draw_.chance(45)) return;
  scene.is_present = true;
  if (scene.order == 0 && draw_.chance(50)) add_locks(scene);
  if (draw_.chance(50)) add_fixed(scene);
  add_emission(scene);
}

}  // namespace elgen::test::random
