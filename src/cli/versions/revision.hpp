// revision: the models and scenes of a revision of git, as files.
#pragma once

#include <filesystem>
#include <string>

#include "elgen/diagnostic.hpp"

namespace elgen::cli {

/// Unpacks the files NAME.toml and NAME.equations.json of a revision of this repository into a
/// folder; the path from the root of the repository to the current folder. E713: git does not have
/// it, or is not there.
[[nodiscard]] Result<std::string> unpack_revision(const std::string& revision,
                                                  const std::filesystem::path& folder);

}  // namespace elgen::cli
