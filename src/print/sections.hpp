// sections: the parts of a page: titles and definitions of outputs, constraints, and recursions
// with named parts. A recursion replaces equations that are too long to read.
//
//     rod (position): (x^2 + y^2)/2 = l^2/2, omega = 10, zeta = 1
//     A a = -gamma - 2 zeta omega r - omega^2 f
//     n_{i} = \sum_{b} (…) + \sum_{j} (…)     a recursion over frames and the bodies they carry
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

/// The documentation of an output, from the output table; for a user's output, from the model.
[[nodiscard]] std::string output_doc(const Model& model, const Function& function);

/// The constraints on accelerations: A a = -gamma, with terms -2 zeta omega r - omega^2 f if the
/// model has gains.
[[nodiscard]] Formula constraint_equation(const Model& model);

/// One line of text per constraint.
[[nodiscard]] std::vector<std::string> constraint_lines(const Model& model);

/// A table of the constraints: multipliers with units, equations, gains.
[[nodiscard]] PageSection constraint_section(const Model& model);

/// True if program.readable[index] is a closed form, for readers, of program.functions[index].
[[nodiscard]] bool has_readable_form(const Program& program, std::size_t index);

/// The sections on frames and their bodies: a table of the frames, angular velocities, then the
/// centre of mass and the kinetic energy of each body. Empty if the model has no frames.
[[nodiscard]] std::vector<PageSection> frame_sections(const Model& model,
                                                      const ReadableDerivation& steps);

/// True if all kinetic energy belongs to bodies and points in frames and to armatures, so that a
/// recursion over the frames gives M and the forces.
[[nodiscard]] bool has_frame_recursion(const Model& model);

/// The sections of the recursion over frames, from the poses of the frames to M.
[[nodiscard]] std::vector<PageSection> recursion_sections(const Model& model);

}  // namespace elgen
