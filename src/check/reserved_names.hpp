// Which names a model may not give to its entries.
#pragma once

#include <string_view>

namespace elgen::checking {

/// Why the name is reserved ("a C++ keyword"), or empty.
[[nodiscard]] std::string_view reserved_reason(std::string_view name);

/// A letter, then letters, digits and underscores.
[[nodiscard]] bool is_well_formed_name(std::string_view name);

}  // namespace elgen::checking
