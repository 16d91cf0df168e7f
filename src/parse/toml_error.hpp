// What toml++ says of a malformed file, as a Diagnostic.
#pragma once

#include <cstdint>
#include <string_view>

#include "elgen/diagnostic.hpp"

namespace elgen {

/// `description` is that of toml++, `offset` the byte it points at. E101; E109 for a decimal that
/// TOML itself cannot hold.
[[nodiscard]] Diagnostic toml_error(const SourceText& source, std::uint32_t offset,
                                    std::string_view description);

/// Whether the text of a token is a decimal number as TOML writes it: `-1_000`, `+0.5e-3`.
[[nodiscard]] bool is_decimal_token(std::string_view token);

}  // namespace elgen
