// terminal: what a stream can show.
#pragma once

#include <cstdio>

#include "elgen/page.hpp"

namespace elgen::cli {

[[nodiscard]] bool is_terminal(std::FILE* stream);

/// As wide as the terminal, 80 columns elsewhere. Unicode on a terminal whose locale is UTF-8
/// (LC_ALL, LC_CTYPE, LANG) and which is neither `dumb` nor that of the Linux console.
[[nodiscard]] Screen screen_of(std::FILE* stream);

}  // namespace elgen::cli
