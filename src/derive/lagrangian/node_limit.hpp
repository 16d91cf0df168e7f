// E908 of what is derived: one message for the definitions of derive and the nodes of lower.
#pragma once

#include <fmt/format.h>

#include <cstdint>

#include "elgen/scene.hpp"

namespace elgen {

[[nodiscard]] inline Diagnostic too_many_nodes(const OutputRequest& request, std::uint64_t limit) {
  return {Code::E908, request.span,
          fmt::format("`{}` takes more than {} derived nodes", request.name, limit),
          "raised by --limit derived_nodes=N"};
}

}  // namespace elgen
