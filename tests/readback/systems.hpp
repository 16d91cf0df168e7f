// Small models that between them have everything a header can say.
#pragma once

#include <string>

namespace elgen::test {

/// Two coordinates, an array of parameters, constants of every kind, atan2, a quotient, kinks, an
/// output and its Jacobian.
inline const std::string& wide_text() {
  static const std::string text = R"toml(format = 1
[model]
name = "wide"
[sizes]
n = 2
[[coordinate]]
name = "x"
unit = "m"
range = [-2, 2]
[[coordinate]]
name = "theta"
unit = "rad"
[parameters]
M = { value = 1.1, unit = "kg", doc = "cart" }
m = { value = 0.1, unit = "kg" }
l = { value = "1/3", unit = "m" }
g = { value = 9.81, unit = "m/s^2" }
k = { value = [0.7, 2], size = "n", unit = "N*s/m" }
b = { value = "0.3", unit = "N*m*s" }
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
[[force]]
on = "x"
value = "-k[1]*dot(x) - 0.7*k[2]*abs(dot(x)) - sqrt(2)*pi*max(k[1], k[2])*sign(dot(x))*dot(x)/3"
[[force]]
on = "theta"
value = "-b*dot(theta)"
[[input]]
name = "u"
unit = "N"
on = "x"
[[output]]
name = "sight"
value = ["atan2(x + l*sin(theta), l*cos(theta) + 2*l)", "x/l"]
jacobian = true
)toml";
  return text;
}

}  // namespace elgen::test
