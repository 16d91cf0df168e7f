// Stated numbers: an [[expect]] `at` a state, such as a published table, judged by the oracle.
#pragma once

#include "verify/structure/expectations.hpp"

namespace elgen {

/// A row for each entry, which may be off by `within` of the largest one of its field; E510 at each
/// that is farther off, or has no value.
void check_numbers(ExpectationReport& report, const Expectation& expectation,
                   const Subject& subject);

}  // namespace elgen
