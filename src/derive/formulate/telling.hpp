// Telling: during its lifetime, definitions are named by kind and frame, for readers of the code.
//
//     const Telling wrench(definitions, "wrench", "link5");       // wrench_link5
//     { const Telling moment(definitions, "moment"); … }          // wrench_moment_link5
#pragma once

#include <string>
#include <utility>

#include "elgen/lagrangian.hpp"

namespace elgen {

class Telling {
 public:
  /// `kind` is appended to the kind of the enclosing Telling; an empty `frame` keeps its frame.
  Telling(Definitions& definitions, const std::string& kind, const std::string& frame = {})
      : wording_(definitions.wording), around_(definitions.wording) {
    if (!wording_.kind.empty() && !kind.empty()) wording_.kind += "_";
    wording_.kind += kind;
    if (!frame.empty()) wording_.frame = frame;
  }
  Telling(const Telling&) = delete;
  Telling& operator=(const Telling&) = delete;
  ~Telling() { wording_ = std::move(around_); }

 private:
  Wording& wording_;
  Wording around_;
};

}  // namespace elgen
