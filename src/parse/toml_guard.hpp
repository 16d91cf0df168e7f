// A look at a TOML file before toml++ reads it: what would overflow its stack.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace elgen {

inline constexpr std::size_t most_key_parts = 100;

/// Where a dotted key of more than most_key_parts parts goes too far. toml++ limits nested values
/// but not `a.b.c…`, which it frees recursively.
[[nodiscard]] std::optional<std::size_t> find_endless_key(std::string_view text);

}  // namespace elgen
