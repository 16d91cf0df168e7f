// The output `step`: by which method.
#pragma once

#include "check/names/report.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// Sets method and iterations of a request for `step`, by the table of its entry; any other value
/// says nothing. E103 where the output takes no method, E105 where it needs one, E620 where there
/// is no such one, E626 where it does not iterate, or not so often.
void read_step(const ValueSyntax& entry, OutputRequest& output, Report& report);

}  // namespace elgen
