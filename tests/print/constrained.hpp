// Systems with constraints: a mass on a rod with coordinates x and y, and an upright disc that
// rolls on a plane.
#pragma once

#include <string>

#include "support/models.hpp"

namespace elgen::test {

inline std::string rod_text() {
  return model_text("pendulum", R"toml([[coordinate]]
name = "x"
unit = "m"
start = { value = 0.6 }
[[coordinate]]
name = "y"
unit = "m"
start = { value = -0.8 }
[parameters]
m = { value = 1, unit = "kg", assume = "positive" }
l = { value = 1, unit = "m" }
g = { value = 9.81, unit = "m/s^2" }
omega = { value = 10, unit = "1/s" }
[energy]
T = "1/2*m*(dot(x)^2 + dot(y)^2)"
V = "m*g*y"
[[constraint]]
name = "rod"
equation = "(x^2 + y^2)/2 = l^2/2"
stabilise = { omega = "2*omega", zeta = 1 }
doc = "massless"
)toml");
}

/// Goldstein, Poole, Safko, Classical Mechanics, 3rd ed., section 1.3.
inline std::string disc_text() {
  return model_text("disc", R"toml([[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[[coordinate]]
name = "phi"
[[coordinate]]
name = "psi"
[parameters]
m = 2
R = 0.3
A = 0.09
J = 0.05
[energy]
T = "1/2*m*(dot(x)^2 + dot(y)^2) + 1/2*A*dot(phi)^2 + 1/2*J*dot(psi)^2"
[[input]]
name = "tau"
on = "phi"
[[constraint]]
name = "roll"
kind = "velocity"
equation = ["dot(x) = R*cos(psi)*dot(phi)", "dot(y) = R*sin(psi)*dot(phi)"]
)toml");
}

}  // namespace elgen::test
