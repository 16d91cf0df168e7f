// annotations: a diagnostic as GitHub shows it.
#pragma once

#include <string>

#include "elgen/diagnostic.hpp"

namespace elgen {

/// A command of a GitHub workflow: `::error file=m.toml,line=2,col=10,title=E201 unknown name::...`
[[nodiscard]] std::string github_command(const Diagnostic& diagnostic);

}  // namespace elgen
