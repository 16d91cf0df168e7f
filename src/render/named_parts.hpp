// named_parts: a summary that replaces equations which are too long to read.
//
//     moment_link7_y = c7x*inertial_link7_z + …        on the page of text, each once
//     n_{i} = \sum_{b} (…) + \sum_{j} (…)              on sheets: frames, and what they carry
#pragma once

#include <string>
#include <vector>

#include "elgen/render.hpp"

namespace elgen {

/// Whether functions[index] has a closed form that is written for a reader.
[[nodiscard]] bool has_readable_form(const Program& program, std::size_t index);

/// Whether all kinetic energy is that of bodies and points in frames, and of armatures: then the
/// recursion over frames says what M and the forces are.
[[nodiscard]] bool moves_in_frames(const Model& model);

/// That recursion, from the poses of the frames to M.
[[nodiscard]] std::vector<SheetOutput> named_parts(const Model& model);

/// LaTeX: the output by those that its definition names; empty where there is no such.
[[nodiscard]] std::string definition_by_others(const Model& model, const Function& function);

}  // namespace elgen
