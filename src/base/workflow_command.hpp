// WorkflowCommand: a line by which a program tells GitHub Actions where to show a message.
//
//     ::warning file=models/a.toml,line=3,col=7,title=elgen diff::[gravity] vector[2]%3A -g -> g
#pragma once

#include <string>
#include <string_view>

#include "elgen/source_text.hpp"

namespace elgen {

struct WorkflowCommand {
  std::string_view level = "notice";  ///< "notice", "warning" or "error"
  Span place = {};
  std::string title = {};
  std::string message = {};
};

/// Escaped as GitHub wants it, with its line end.
[[nodiscard]] std::string text_of(const WorkflowCommand& command);

}  // namespace elgen
