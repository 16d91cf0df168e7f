// Substitutes all definitions into an expression, and tests at exact points whether an expression
// vanishes. Derivation avoids this simple but expensive method.
#pragma once

#include <vector>

#include "elgen/lagrangian.hpp"

namespace elgen::test {

/// `value` with every definition substituted.
inline GiNaC::ex written_out(const Definitions& definitions, GiNaC::ex value) {
  GiNaC::exmap known;
  for (const Definition& definition : definitions.list) {
    known[definition.symbol] = definition.value.subs(known, GiNaC::subs_options::no_pattern);
  }
  return value.subs(known, GiNaC::subs_options::no_pattern);
}

/// True if |`difference`| <= 1e-45 at three points in 60-digit arithmetic. The points are small
/// rationals, so the compared values are between 1 and 1e6. The tolerance 1e-45 is far above
/// rounding errors and far below the effect of any mistake.
inline bool vanishes(const GiNaC::ex& difference, const std::vector<GiNaC::ex>& symbols) {
  GiNaC::Digits = 60;
  for (int sample = 0; sample < 3; ++sample) {
    GiNaC::exmap point;
    int seed = 7 + 11 * sample;
    for (const GiNaC::ex& symbol : symbols) {
      point[symbol] = GiNaC::numeric(1 + seed % 13, 17);
      seed += 5;
    }
    const GiNaC::ex at_point = difference.subs(point, GiNaC::subs_options::no_pattern).evalf();
    if (!GiNaC::is_a<GiNaC::numeric>(at_point)) return false;
    const GiNaC::numeric size = GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(at_point));
    if (size > GiNaC::pow(GiNaC::numeric(10), GiNaC::numeric(-45))) return false;
  }
  return true;
}

}  // namespace elgen::test
