// What to write instead of a character the language does not have.
#pragma once

#include <string>

namespace elgen {

/// "write `pi`" for U+03C0, "write `-`" for U+2212 …; empty where there is nothing to suggest.
[[nodiscard]] std::string replacement_hint(char32_t character);

}  // namespace elgen
