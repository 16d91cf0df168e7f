// header_data: EmissionInput -> the values of the holes that the headers of every language have:
// stamp, counts, introduction, table of operations, and the functions with their documentation.
#pragma once

#include <string>
#include <string_view>

#include "emit/code/dialect.hpp"
#include "emit/text/emission_input.hpp"
#include "emit/text/fill_template.hpp"

namespace elgen {

/// Sections `kinks` and `regular` are there where sign, min or max, and pivots are.
[[nodiscard]] TemplateData header_data(const EmissionInput& input, const Dialect& dialect);

/// A template that stands on a line of its own in another one, which ends the line.
[[nodiscard]] std::string partial(std::string_view path);

}  // namespace elgen
