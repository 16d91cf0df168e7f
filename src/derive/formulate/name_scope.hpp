// NameScope: while it exists, new definitions are named after a kind and a frame, for readers of
// the emitted code.
//
//     const NameScope wrench(definitions, "wrench", "link5");       // wrench_link5
//     { const NameScope moment(definitions, "moment"); … }          // wrench_moment_link5
#pragma once

#include <string>
#include <utility>

#include "elgen/lagrangian.hpp"

namespace elgen {

class NameScope {
 public:
  /// `kind` is appended to the kind of the enclosing NameScope. If `frame` is empty, the frame of
  /// the enclosing NameScope is kept.
  NameScope(Definitions& definitions, const std::string& kind, const std::string& frame = {})
      : wording_(definitions.meaning), around_(definitions.meaning) {
    if (!wording_.kind.empty() && !kind.empty()) wording_.kind += "_";
    wording_.kind += kind;
    if (!frame.empty()) wording_.frame = frame;
  }
  NameScope(const NameScope&) = delete;
  NameScope& operator=(const NameScope&) = delete;
  ~NameScope() { wording_ = std::move(around_); }

 private:
  ValueMeaning& wording_;
  ValueMeaning around_;
};

}  // namespace elgen
