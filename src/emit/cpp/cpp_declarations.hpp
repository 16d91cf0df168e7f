// cpp_declarations: what a Model declares (names, units, ranges, parameters) -> values of template
// holes.
#pragma once

#include "elgen/model.hpp"
#include "emit/text/layout.hpp"
#include "render/fill_template.hpp"

namespace elgen {

/// Names, units, ranges and limits of coordinates and inputs: type, count, name, value.
[[nodiscard]] TemplateData declarations(const Model& model);

/// Members of Parameters, with their defaults.
[[nodiscard]] std::vector<Member> declared_parameters(const Model& model,
                                                      const std::vector<ParameterArray>& arrays);

/// Whether a member is made by detail::filled: an array parameter with one value for all elements.
[[nodiscard]] bool has_filled_array(const Model& model, const std::vector<ParameterArray>& arrays);

}  // namespace elgen
