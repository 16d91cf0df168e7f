// cpp_names: which names the emitted C++ keeps for itself.
#pragma once

#include <string>
#include <string_view>

namespace elgen {

/// Whether templates/cpp/header.hpp.mustache needs the name for itself.
[[nodiscard]] bool is_emitted_name(std::string_view name);

/// Whether no namespace can have the name, and so no model.
[[nodiscard]] bool is_taken_outside(std::string_view name);

/// Whether templates/cpp/eigen.hpp.mustache needs the name for itself.
[[nodiscard]] bool is_eigen_name(const std::string& name);

}  // namespace elgen
