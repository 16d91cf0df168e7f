// taken_name: E701 for what the emitted code keeps for itself.
#pragma once

#include <string>

#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// E701 at the span of what wants the name.
[[nodiscard]] Diagnostic taken_name(const std::string& name, const char* what, const Span& span);

/// The same of a function, where the scene asks for it; nowhere for the scene `full`.
[[nodiscard]] Diagnostic taken_name(const Scene& scene, const Function& function);

}  // namespace elgen
