// annotations: a diagnostic as the services show it that keep repositories.
#pragma once

#include <string>

#include "elgen/diagnostic.hpp"

namespace elgen {

/// A command of a GitHub workflow: `::error file=m.toml,line=2,col=10,title=E201 unknown name::...`
[[nodiscard]] std::string github_command(const Diagnostic& diagnostic);

/// An issue of GitLab's code quality, an object on one line.
[[nodiscard]] std::string gitlab_issue(const Diagnostic& diagnostic,
                                       const std::string& fingerprint);

}  // namespace elgen
