// Templates as strings of the binary; the definitions are written by cmake/EmbedTemplates.cmake.
#pragma once

#include <string>
#include <string_view>

namespace elgen {

/// The template at `path` below templates/, "cpp/header.hpp.mustache"; empty if there is none.
[[nodiscard]] std::string_view embedded_template(std::string_view path);

/// The same; throws std::logic_error if there is none, so that the first test that asks fails.
[[nodiscard]] std::string_view template_at(std::string_view path);

/// The path of what `{{> name}}` stands for in the template at `path`: of its folder and language.
///
///     cpp/header.hpp.mustache, kinked   ->   cpp/kinked.hpp.mustache
[[nodiscard]] std::string template_beside(std::string_view path, std::string_view name);

}  // namespace elgen
