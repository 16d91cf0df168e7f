// player_controls: the sliders of a page.
#pragma once

#include <string>

#include "base/fill_template.hpp"
#include "elgen/pipeline.hpp"

namespace elgen {

/// Groups of sliders: of the start, its rates, inputs without laws, and parameters.
[[nodiscard]] TemplateData slider_groups(const CheckedModel& checked, const Program& program);

/// Escapes a text for use in a quoted HTML attribute.
[[nodiscard]] std::string html_attribute_text(const std::string& text);

}  // namespace elgen
