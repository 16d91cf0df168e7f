// stamp: contents -> the 16-digit hashes that files carry (xxh3, 64 bits, seed 0).
#pragma once

#include <string>
#include <string_view>

namespace elgen {

/// 16 hexadecimal digits.
[[nodiscard]] std::string content_hash(std::string_view text);

/// The first 8 of them, for names.
[[nodiscard]] std::string short_hash(std::string_view text);

/// Sixteen zeros, where a file will state the hash of its own text.
[[nodiscard]] std::string_view blank_hash();

/// Replaces the blank body hash by the hash of `text`, which is taken with the blank in place.
/// The places it may stand in are those body_hash() looks at.
[[nodiscard]] std::string stamped(std::string text);

}  // namespace elgen
