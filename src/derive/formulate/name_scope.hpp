// NameScope: while a NameScope exists, new definitions are named after a kind and a frame, for
// readers of the emitted code.
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
      : meaning_(definitions.meaning), outer_meaning_(definitions.meaning) {
    if (!meaning_.kind.empty() && !kind.empty()) meaning_.kind += "_";
    meaning_.kind += kind;
    if (!frame.empty()) meaning_.frame = frame;
  }
  NameScope(const NameScope&) = delete;
  NameScope& operator=(const NameScope&) = delete;
  ~NameScope() { meaning_ = std::move(outer_meaning_); }

 private:
  ValueMeaning& meaning_;
  ValueMeaning outer_meaning_;
};

}  // namespace elgen
