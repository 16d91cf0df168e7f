// What is noted of units where nothing is wrong with them.
#pragma once

#include "check/names/context.hpp"

namespace elgen {

/// E405: the first value that names nothing, and how many more there are.
void note_plain_numbers(Context& context);

/// E520: names of what has no unit, each once, and where the first of them is declared.
void note_missing_units(Context& context);

}  // namespace elgen
