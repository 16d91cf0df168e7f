// An arm of two links that carries a sensor of a milligram: every term of the sensor is small.
#pragma once

#include <string>

namespace elgen::test {

inline const std::string& arm_with_sensor_text() {
  static const std::string text = R"toml(format = 1

[model]
name = "arm"

[[coordinate]]
name = "q1"
unit = "rad"
range = [-3, 3]
rate_range = [-5, 5]

[[coordinate]]
name = "q2"
unit = "rad"
range = [-2, 2]
rate_range = [-8, 8]

[parameters]
m1 = { value = 1, unit = "kg" }
m2 = { value = 0.5, unit = "kg", min = 0.4, max = 0.6 }
ms = { value = 1e-6, unit = "kg" }
l1 = { value = 0.5, unit = "m" }
l2 = { value = 0.4, unit = "m" }
h = { value = 0.1, unit = "m" }
g = { value = 9.81, unit = "m/s^2" }

[[point]]
name = "elbow"
at = ["l1*sin(q1)", "-l1*cos(q1)"]
mass = "m1"

[[point]]
name = "tip"
at = ["x(elbow) + l2*sin(q1 + q2)", "y(elbow) - l2*cos(q1 + q2)"]
mass = "m2"

[[point]]
name = "sensor"
at = ["x(tip) + h*cos(q1 + q2)", "y(tip) + h*sin(q1 + q2)"]
mass = "ms"

[gravity]
vector = ["0", "-g"]

[[input]]
name = "u1"
unit = "N*m"
on = "q1"
)toml";
  return text;
}

/// Everything that `drop_below` reduces.
inline std::string scene_of_sensor(const std::string& more) {
  return R"toml(format = 1
model = "arm.toml"
name = "light"

[outputs]
mass_matrix = true
coriolis_matrix = true
velocity_force = true
gravity = true
potential_energy = true
drift = true
dissipation = true
applied_force = true
bias = true
momentum = true
kinetic_energy = true
total_energy = true
energy_function = true
input_matrix = true
inverse_dynamics = true
dynamics = true
)toml" + more;
}

}  // namespace elgen::test
