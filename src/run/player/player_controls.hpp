// player_controls: the sliders, buttons and choices of a page.
#pragma once

#include "base/fill_template.hpp"
#include "elgen/pipeline.hpp"
#include "elgen/simulate.hpp"

namespace elgen {

/// Sets the holes for them in the template of the page.
void set_controls(TemplateData& data, const CheckedModel& checked, const Program& program,
                  const Products& read);

/// A text within quotes of HTML.
[[nodiscard]] std::string attribute_text(const std::string& text);

}  // namespace elgen
