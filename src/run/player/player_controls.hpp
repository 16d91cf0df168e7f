// player_controls: the sliders and choices of a page.
#pragma once

#include "base/fill_template.hpp"
#include "elgen/pipeline.hpp"
#include "elgen/simulate.hpp"

namespace elgen {

/// Sets the variables of `data` for groups of sliders, phase planes and paces.
void set_controls(TemplateData& data, const CheckedModel& checked, const Program& program);

/// The options of the page's tolerance; `chosen` is one of them, and selected.
[[nodiscard]] TemplateData tolerance_choices(double chosen);

/// Escapes a text for use in a quoted HTML attribute.
[[nodiscard]] std::string html_attribute_text(const std::string& text);

}  // namespace elgen
