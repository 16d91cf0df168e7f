// library_names: what the headers of C and POSIX declare outside of namespace std, so that no
// namespace can have the name.
//
//     system -> true      roundf -> true      cart_pole -> false
#pragma once

#include <string_view>

namespace elgen {

/// Whether POSIX keeps the name for types: it ends in _t.
[[nodiscard]] bool is_reserved_type(std::string_view name);

/// Of the C and POSIX libraries: mathematics, <stdlib.h>, <unistd.h>, `main`, and reserved types.
[[nodiscard]] bool is_library_name(std::string_view name);

}  // namespace elgen
