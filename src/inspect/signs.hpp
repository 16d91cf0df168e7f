// E524, for whoever has a sample of M at hand.
#pragma once

#include "elgen/diagnostic.hpp"
#include "inspect/samples.hpp"

namespace elgen {

/// Nothing where M is positive definite or singular there, or a mass is negative.
[[nodiscard]] Diagnostics negative_kinetic_energy(const Inspected& subject,
                                                  const MassSample& sample);

}  // namespace elgen
