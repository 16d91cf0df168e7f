// content_hash: contents -> 16 digits (xxh3, 64 bits, seed 0).
#pragma once

#include <string>
#include <string_view>

namespace elgen {

/// 16 hexadecimal digits.
[[nodiscard]] std::string content_hash(std::string_view text);

/// The first 8 of them, for names.
[[nodiscard]] std::string short_hash(std::string_view text);

}  // namespace elgen
