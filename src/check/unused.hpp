// Names that are declared and never used: mostly what was forgotten, or written in another's place.
#pragma once

#include "context.hpp"

namespace elgen::checking {

/// E522 for parameters in no expression, and for inputs that neither act on a velocity nor stand in
/// an expression. For a model without errors, before anything is locked.
void report_unused(Context& context);

}  // namespace elgen::checking
