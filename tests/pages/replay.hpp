// Replays a fence of a page. Depending on the kind of the fence, writes the file, runs the
// commands, compares the output of the commands, or compares the excerpt with the written file.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "pages/page.hpp"
#include "support/shell.hpp"

namespace elgen::test {

/// Runs a command of a page in the folder of the page's files.
using Runner = std::function<Outcome(const std::string& command)>;

/// Replays a fence. `folder` contains the files that the commands read and write.
void replay(const Fence& fence, const std::filesystem::path& folder, const Runner& run);

}  // namespace elgen::test
