// The names of functions, and the names that a model may not give to its entries.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/report.hpp"

namespace elgen {

[[nodiscard]] std::vector<std::string> function_names();

/// Why the name is reserved ("a C++ keyword"); "" if it is free.
[[nodiscard]] std::string_view reserved_reason(std::string_view name);

/// The hint "`J` is free" for the reserved `name`. The substitute, J, is not reserved and does not
/// occur in the file.
///
///     I -> J   delta -> delta_1   M_E -> m_e   a__b -> a_b
[[nodiscard]] std::string free_name_hint(std::string_view name, const Span& span);

/// True for a letter followed by letters, digits and underscores.
[[nodiscard]] bool is_well_formed_name(std::string_view name);

/// True if a name of the model or of the emitted code is well-formed and not reserved; false after
/// E205 or E204.
bool check_name(const std::string& name, const Span& span, Report& report);

}  // namespace elgen
