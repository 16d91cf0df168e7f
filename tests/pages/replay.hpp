// Does what a fence of a page says: writes its file, runs its commands, compares what they print
// and write.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "pages/page.hpp"
#include "support/shell.hpp"

namespace elgen::test {

/// Runs a command of a page where the page's files are.
using Runner = std::function<Outcome(const std::string& command)>;

/// `folder`: of the files that the commands read and write.
void replay(const Fence& fence, const std::filesystem::path& folder, const Runner& run);

}  // namespace elgen::test
