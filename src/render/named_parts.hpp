// named_parts: a summary that replaces equations which are too long to read.
//
//     force_link7_3 = m7*(c7x*motion_link7_8 + …)      on the page of text, each once
//     n_{i} = \sum_{b} (…) + \sum_{j} (…)              on sheets: frames, and what they carry
#pragma once

#include <string>
#include <vector>

#include "elgen/render.hpp"

namespace elgen {

/// Whether functions[index] has a closed form that is written for a reader.
[[nodiscard]] bool has_readable_form(const Program& program, std::size_t index);

/// Functions as one: what they compute alike is computed once. Their fields follow one another.
[[nodiscard]] Function united(const Program& program, const std::vector<std::size_t>& functions);

/// As temporary_names, but in the place of hashes stands whose part of what kind a value is: of a
/// frame its place or motion, or the inertia or force of all that it carries.
[[nodiscard]] std::vector<std::string> part_names(const Model& model, const Scene& scene,
                                                  const Program& program, const Function& function);

/// Whether all kinetic energy is that of bodies and points in frames, and of armatures: then the
/// recursion over frames says what M and the forces are.
[[nodiscard]] bool moves_in_frames(const Model& model);

/// That recursion, from the poses of the frames to M.
[[nodiscard]] std::vector<SheetOutput> named_parts(const Model& model);

/// LaTeX: the output by those that its definition names; empty where there is no such.
[[nodiscard]] std::string definition_by_others(const Model& model, const Function& function);

}  // namespace elgen
