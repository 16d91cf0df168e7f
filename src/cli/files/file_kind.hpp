// file_kind: what stands at a path, in words.
#pragma once

#include <sys/stat.h>

#include <string_view>

namespace elgen::cli {

/// "a folder", "a device", …; empty for a regular file.
[[nodiscard]] std::string_view special_kind(mode_t mode);

}  // namespace elgen::cli
