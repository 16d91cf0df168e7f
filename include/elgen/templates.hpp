// Templates as strings of the binary; cmake/EmbedTemplates.cmake writes the definitions.
#pragma once

#include <string>
#include <string_view>

namespace elgen {

/// The template at `path` below templates/, "cpp/header.hpp.mustache"; empty if there is none.
[[nodiscard]] std::string_view embedded_template(std::string_view path);

/// The same, but throws std::logic_error if there is none, so that the first test that uses it
/// fails.
[[nodiscard]] std::string_view template_at(std::string_view path);

/// The path of the partial `{{> name}}` in the template at `path`: the same folder and language.
///
///     cpp/header.hpp.mustache, kinked   ->   cpp/kinked.hpp.mustache
[[nodiscard]] std::string partial_path(std::string_view path, std::string_view name);

}  // namespace elgen
