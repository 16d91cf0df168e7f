// readable: the shortest way to write a closed form.
//
// Candidates: multiple angles, and sin^2 or cos^2 turned into the other, each with common factors
// collected; and the entry as it was derived, where that is short and loses no digits: what cancels
// on paper is not written. Shortest is what has the fewest signs and calls; on a tie the earlier
// one. A form collected by rates, or by rates and coordinates, as textbooks do, is preferred while
// it is little longer. The code is judged by the readable form, so that a shorter one is emitted
// only where it is as precise.
#pragma once

#include <optional>

#include "choose/rounding_errors.hpp"
#include "elgen/closed_forms.hpp"
#include "lower/graph/rebuild.hpp"

namespace elgen {

/// One value, twice, each over a graph of its own.
struct ReadableForm {
  Expressions readable = {};
  Expressions compact = {};   ///< the shortest that is as precise, however it looks
  std::size_t length = 0;     ///< of the readable one
  bool is_rewritten = false;  ///< code is always the compact one: the other loses digits
};

/// The shortest candidate; none where all are too long. `derived` may be null.
[[nodiscard]] std::optional<ReadableForm> shortest(const Algebra& algebra, const Fraction& form,
                                                   const Expressions* derived,
                                                   const MixedPoints& points);

/// One entry of a function as it was derived, over the leaves; none where that is long.
struct DerivedEntry {
  Expressions as_it_stands = {};
  Expressions written_out = {};  ///< products in products
};
[[nodiscard]] std::optional<DerivedEntry> as_derived(const Program& program,
                                                     const Function& function, std::uint32_t entry);

}  // namespace elgen
