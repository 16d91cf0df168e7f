// Small systems that together use every part of a Lagrangian.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "support/models.hpp"

namespace elgen::test {

using NamedText = std::pair<std::string, std::string>;

inline const std::string& cart_pole_text() {
  static const std::string text = model_text("cart_pole", R"toml(
[[coordinate]]
name = "x"
[[coordinate]]
name = "theta"
[parameters]
M = { value = 2, assume = "positive" }
m = { value = "3/10", assume = "positive" }
l = { value = "1/2", assume = "positive" }
g = 9.81
[[point]]
name = "cart"
at = ["x", "0"]
mass = "M"
[[point]]
name = "bob"
at = ["x + l*sin(theta)", "l*cos(theta)"]
mass = "m"
[gravity]
vector = ["0", "-g"]
[[input]]
name = "u"
on = "x"
)toml");
  return text;
}

inline const std::string& chain_text() {
  static const std::string text = model_text("chain", R"toml(
[sizes]
n = 3
[[coordinate]]
for = "i in 1..n"
name = "q[i]"
[parameters]
m = { size = "n", value = 0.2 }
l = { size = "n", value = 0.3 }
g = 9.81
[[point]]
name = "p[0]"
at = ["0", "0"]
[[point]]
for = "i in 1..n"
name = "p[i]"
at = ["x(p[i-1]) + l[i]*sin(q[i])", "y(p[i-1]) - l[i]*cos(q[i])"]
mass = "m[i]"
[gravity]
vector = ["0", "-g"]
)toml");
  return text;
}

/// Prescribed motion, T of degrees 0, 1 and 2 in the rates, V linear in a rate, dissipation, forces
/// on points and coordinates with inputs in definitions, a body with spin, an armature, an output.
inline const std::string& everything_text() {
  static const std::string text = model_text("everything", R"toml(
[[coordinate]]
name = "r"
[[coordinate]]
name = "theta"
armature = "J"
[[prescribed]]
name = "phi"
value = "Omega*t + A*sin(nu*t)"
[parameters]
m = 2
J = { value = "1/7" }
k = 5
b = { value = "1/3" }
c = { value = "2/5" }
Omega = 3
A = { value = "1/4" }
nu = 2
g = 9.81
e = { value = "3/2" }
[define]
slider_rate = "dot(r) + Omega*r*cos(theta)"
drive = "(u - b*dot(theta))/c"
[[point]]
name = "bead"
at = ["r*sin(theta + phi)", "-r*cos(theta + phi)"]
mass = "m"
[[point]]
name = "hook"
at = ["r*cos(phi)", "c"]
[[body]]
name = "wheel"
mass = "m"
com = ["2*r", "c*sin(theta)"]
inertia = "J"
spin = "3*dot(theta) + dot(phi)"
[gravity]
vector = ["0", "-g"]
[energy]
T = "1/2*m*slider_rate^2"
V = "1/2*k*(r - 1)^2 - e*r^2*dot(theta)"
D = "1/2*b*dot(r)^2*(1 + r^2)"
[[input]]
name = "u"
[[input]]
name = "w"
on = "r"
[[force]]
name = "motor"
on = "theta"
value = "drive*cos(r)"
[[force]]
name = "pull"
at = "hook"
from = "bead"
value = ["u*r - b*dot(r)", "e*t"]
[[output]]
name = "tip"
value = ["x(bead)", "r^2*t"]
jacobian = true
)toml");
  return text;
}

inline const std::string& relativistic_text() {
  static const std::string text = model_text("relativistic", R"toml(
[[coordinate]]
name = "x"
[parameters]
m = { value = 2, assume = "positive" }
c = { value = 300, assume = "positive" }
k = 5
[energy]
L = "-m*c^2*sqrt(1 - dot(x)^2/c^2) - 1/2*k*x^2"
)toml");
  return text;
}

inline const std::string& gyroscope_text() {
  static const std::string text = model_text("gyroscope", R"toml(
[[coordinate]]
name = "phi"
[[coordinate]]
name = "theta"
[[coordinate]]
name = "psi"
[parameters]
A = { value = "1/20" }
C = { value = "1/50" }
P = { value = "1/100" }
h = { value = "1/5" }
m = 1
g = 9.81
[[body]]
name = "top"
inertia = ["A", "A", "C", "P", "0", "P/2"]
spin = ["dot(phi)*sin(theta)*sin(psi) + dot(theta)*cos(psi)",
        "dot(phi)*sin(theta)*cos(psi) - dot(theta)*sin(psi)",
        "dot(phi)*cos(theta) + dot(psi)"]
[energy]
V = "m*g*h*cos(theta)"
)toml");
  return text;
}

inline const std::vector<NamedText>& systems() {
  static const std::vector<NamedText> all{{"cart_pole", cart_pole_text()},
                                          {"chain", chain_text()},
                                          {"everything", everything_text()},
                                          {"relativistic", relativistic_text()},
                                          {"gyroscope", gyroscope_text()}};
  return all;
}

}  // namespace elgen::test
