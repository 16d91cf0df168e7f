// stamp: the hash of its own text that a file carries.
#pragma once

#include <string>
#include <string_view>

namespace elgen {

/// Sixteen zeros, where a file will state the hash of its own text.
[[nodiscard]] std::string_view blank_hash();

/// Replaces the blank body hash by the hash of `text`, which is taken with the blank in place.
/// The places it may stand in are those body_hash() looks at.
[[nodiscard]] std::string stamped(std::string text);

}  // namespace elgen
