// The output `step`: by which method.
#pragma once

#include "check/names/report.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// Sets the method of a request for `step`. `method`: what its entry says; null where it says none.
/// E103 where the output takes no method, E105 where it needs one, E620 where there is no such one.
void read_step_method(const KeySyntax* method, OutputRequest& output, Report& report);

}  // namespace elgen
