// Claims: the last lines of a page of equilibria: for which parameters they are exact, when they
// exist, and whether they are all.
#pragma once

#include "analyse/page.hpp"

namespace elgen {

/// "exact for all values of the parameters; stability at the parameters' values; theta modulo 2*pi"
[[nodiscard]] Printed scope_of(const Model& model, const Equilibria& equilibria);

/// "these are all at the parameters' values (proved)"
[[nodiscard]] Printed claim_of(const Model& model, const Equilibria& equilibria);

}  // namespace elgen
