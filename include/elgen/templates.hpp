// Templates as strings of the binary; the definitions are written by cmake/EmbedTemplates.cmake.
#pragma once

#include <string_view>

namespace elgen {

/// The template at `path` below templates/, "cpp/header.hpp.mustache"; empty if there is none.
[[nodiscard]] std::string_view embedded_template(std::string_view path);

}  // namespace elgen
