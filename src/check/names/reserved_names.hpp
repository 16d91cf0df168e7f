// The names of functions, and which names a model may not give to its entries.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/report.hpp"

namespace elgen {

[[nodiscard]] const std::vector<std::string>& function_names();

/// Why the name is reserved ("a C++ keyword"), or empty.
[[nodiscard]] std::string_view reserved_reason(std::string_view name);

/// "`J` is free": a name that could be given in the place of a reserved one, and that is no word of
/// the file.
///
///     I -> J   delta -> delta_1   M_E -> m_e   a__b -> a_b
[[nodiscard]] std::string name_instead(std::string_view name, const Span& span);

/// A letter, then letters, digits and underscores.
[[nodiscard]] bool is_well_formed_name(std::string_view name);

/// False after E205 or E204: a name of the model or of the emitted code must be one, and free.
bool check_name(const std::string& name, const Span& span, Report& report);

}  // namespace elgen
