// Templates as strings in the binary; cmake/EmbedTemplates.cmake generates their definitions.
#pragma once

#include <string>
#include <string_view>

namespace elgen {

/// The template at `path` below templates/, for example "cpp/header.hpp.mustache"; empty if it does
/// not exist.
[[nodiscard]] std::string_view embedded_template(std::string_view path);

/// The template at `path`. Throws std::logic_error if it does not exist.
[[nodiscard]] std::string_view require_template(std::string_view path);

/// The path of the partial `{{> name}}` in the template at `path`: the same folder and language.
///
///     cpp/header.hpp.mustache, kinked   ->   cpp/kinked.hpp.mustache
[[nodiscard]] std::string partial_path(std::string_view path, std::string_view name);

}  // namespace elgen
