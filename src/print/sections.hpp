// sections: titles and definitions, constraints, and the named parts that replace equations which
// are too long to read.
//
//     rod (position): (x^2 + y^2)/2 = l^2/2, omega = 10, zeta = 1
//     A a = -gamma - 2 zeta omega r - omega^2 f
//     n_{i} = \sum_{b} (…) + \sum_{j} (…)              of frames, and the bodies that they carry
#pragma once

#include <string>
#include <vector>

#include "elgen/page.hpp"

namespace elgen {

struct Heading {
  Formula symbol = {};      ///< "M"
  Formula definition = {};  ///< "M = d^2 L/dv^2"; may be empty
};

[[nodiscard]] Heading heading(const Model& model, const Function& function);

/// One sentence: the table's, or the model's own about its outputs.
[[nodiscard]] std::string output_doc(const Model& model, const Function& function);

/// The second rates of positions and the rates of velocities: gains stand there where the model has
/// some.
[[nodiscard]] Formula constraint_equation(const Model& model);

/// One line of text for each constraint.
[[nodiscard]] std::vector<std::string> constraint_lines(const Model& model);

/// A table of them: multipliers with their units, equations, gains.
[[nodiscard]] PageSection constraint_section(const Model& model);

/// Whether functions[index] has a closed form that is written for a reader.
[[nodiscard]] bool has_readable_form(const Program& program, std::size_t index);

/// Whether all kinetic energy is that of bodies and points in frames, and of armatures: then the
/// recursion over frames says what M and the forces are.
[[nodiscard]] bool moves_in_frames(const Model& model);

/// That recursion, from the poses of the frames to M.
[[nodiscard]] std::vector<PageSection> named_parts(const Model& model);

}  // namespace elgen
