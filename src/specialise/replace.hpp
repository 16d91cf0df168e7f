// replace: values for leaves, everywhere in a Lagrangian.
#pragma once

#include "formulate/chain_rule.hpp"

namespace elgen {

/// Every energy, force, frame and output over new definitions; the old ones stay in the list,
/// unreached.
void replace(Lagrangian& lagrangian, const Seeds& values);

}  // namespace elgen
