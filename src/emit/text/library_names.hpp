// library_names: what <cmath> and what it includes declare outside of namespace std, so that no
// namespace can have the name.
//
//     system -> true      roundf -> true      cart_pole -> false
#pragma once

#include <string_view>

namespace elgen {

/// Of the C and POSIX libraries: mathematics, <stdlib.h>, and types that end in _t.
[[nodiscard]] bool is_library_name(std::string_view name);

}  // namespace elgen
