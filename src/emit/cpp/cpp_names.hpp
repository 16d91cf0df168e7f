// cpp_names: names that the emitted C++ reserves.
#pragma once

#include <string>
#include <string_view>

namespace elgen {

/// True if templates/cpp/header.hpp.mustache uses the name.
[[nodiscard]] bool is_emitted_name(std::string_view name);

/// True for `std` and for names of C and POSIX: no namespace, and so no model, can have them.
[[nodiscard]] bool is_reserved_by_system(std::string_view name);

/// True if templates/cpp/eigen.hpp.mustache uses the name.
[[nodiscard]] bool is_eigen_name(const std::string& name);

}  // namespace elgen
