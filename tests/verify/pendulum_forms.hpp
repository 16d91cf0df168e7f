// V = m g l (1 - cos th) of a pendulum, in ways that keep its digits and ways that do not.
#pragma once

#include "verify/systems.hpp"

namespace elgen::test::pendulum_forms {

inline const std::string head =
    "parameters m l g\ncoordinates th\nfunction potential_energy\n  0 = parameter m\n"
    "  1 = parameter l\n  2 = parameter g\n  3 = coordinate th\n  4 = multiply 0 1\n"
    "  5 = multiply 4 2\n";
inline const std::string cosine =
    head +
    "  6 = cos 3\n  7 = constant 1\n  8 = subtract 7 6\n  9 = multiply 5 8\n"
    "  result 1 1 = 9\n";
/// 2 sin(th/2)^2
inline const std::string half_angle =
    head +
    "  6 = constant 1/2\n  7 = multiply 6 3\n  8 = sin 7\n  9 = multiply 8 8\n"
    "  10 = add 9 9\n  11 = multiply 5 10\n  result 1 1 = 11\n";
/// m l g tanh(th), as friction goes with a rate.
inline const std::string friction = head + "  6 = tanh 3\n  7 = multiply 5 6\n  result 1 1 = 7\n";

/// Whose one output is the potential energy, as `text` writes it.
inline System written_as(const std::string& text) {
  ModelBuilder builder;
  builder.coordinate("th", "rad").parameter("m", "2").parameter("l", "0.75").parameter("g", "9.81");
  builder.point("bob", {"l*sin(th)", "l - l*cos(th)"}, "m").gravity({"0", "-g"});
  return system_of(builder.model, text);
}

}  // namespace elgen::test::pendulum_forms
