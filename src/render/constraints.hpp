// constraints: the equations that a model obeys, as they were typed, and what their multipliers do.
//
//     rod (position): (x^2 + y^2)/2 = l^2/2, omega = 10, zeta = 1
//     A a = -gamma - 2 zeta omega r - omega^2 f
#pragma once

#include <string>
#include <vector>

#include "elgen/render.hpp"

namespace elgen {

/// The second rates of positions and the rates of velocities, in both notations: gains stand there
/// where the model has some.
[[nodiscard]] EquationOfMotion constraint_equation(const Model& model);

/// "N", of the i-th multiplier; empty where it is not known.
[[nodiscard]] std::string multiplier_unit(const Model& model, std::size_t i);

/// One line of text for each constraint.
[[nodiscard]] std::vector<std::string> constraint_lines(const Model& model);

/// A table of them: multipliers with their units, equations, gains.
[[nodiscard]] SheetOutput constraint_section(const Model& model);

}  // namespace elgen
