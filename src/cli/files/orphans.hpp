// orphans: files of ours that nothing generates any more.
#pragma once

#include <string>
#include <vector>

#include "cli/files/output_files.hpp"
#include "elgen/scene.hpp"

namespace elgen::cli {

/// In the folders of `files` what is ours and not among them. Elsewhere below `directory` the
/// folders whose sidecar names a model or scene that is not there, or one of `sources`, which is
/// written under another name.
[[nodiscard]] std::vector<FileDifference> orphans(const std::string& directory,
                                                  const EmittedFiles& files,
                                                  const std::vector<SourcePaths>& sources);

}  // namespace elgen::cli
