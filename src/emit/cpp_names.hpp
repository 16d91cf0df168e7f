// cpp_names: which names the emitted C++ keeps for itself, and E701 where a model wants one of
// them.
#pragma once

#include <string>
#include <string_view>

#include "elgen/diagnostic.hpp"
#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// E701 for parameters, functions and namespaces whose name the emitted code needs. Keywords and
/// macros of C++ are no names of a Model or Scene in the first place (E204).
[[nodiscard]] Diagnostics check_names(const Model& model, const Scene& scene,
                                      const Program& program);

/// A temporary's name, with an underscore behind where it would hide something.
[[nodiscard]] std::string cpp_temporary(const std::string& name);

/// "forward_dynamics" -> "ForwardDynamics": the struct a function of several fields returns.
[[nodiscard]] std::string struct_name(const Function& function);

/// True for functions that return a struct: all but those with one field without a name.
[[nodiscard]] bool returns_struct(const Function& function);

/// The namespace the scene asks for; its base name by default.
[[nodiscard]] const std::string& cpp_namespace(const Scene& scene);

/// Parameters that stay run-time parameters: not all of their elements are fixed by the scene.
[[nodiscard]] bool is_emitted(const ParameterArray& array, const Scene& scene);

}  // namespace elgen
