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
#include <vector>

#include "accuracy/running_errors.hpp"
#include "elgen/closed_forms.hpp"
#include "elgen/leaf_names.hpp"
#include "program/graph/rebuild.hpp"

namespace elgen {

/// Where ways to write one value are compared by how far rounding may take them:
///
///     2*a*(x + y) + b*z - a*(2*x + y)     has two terms more that cancel,   2 a x: where they are
///     a*y + b*z                           large, no digit of the first way is right
///
/// by their running errors to first order. A term that cancels shows where it outweighs all others,
/// so every leaf has a magnitude of its own.
using MixedPoints = std::vector<Arguments<double>>;

/// The same on every machine: a quarter of ordinary magnitudes, the others from 2^-26 to 2^26, as
/// wide as what programs are checked at. Parameters are positive, as most masses and lengths have
/// to be.
[[nodiscard]] MixedPoints mixed_points(const LeafNames& leaves);

/// Whether, wherever `reference` has a value x, the error of `way` is at most three times that of
/// `reference`, or at most 8 |x|, which no judge refuses; false where it has none at any point. One
/// and the same sum counts up to twice as much when it is put together in another way; what cancels
/// is beyond any factor.
[[nodiscard]] bool is_as_precise(const Expressions& way, const Expressions& reference,
                                 const MixedPoints& points, Leaves leaves);

/// One value, twice, each over a graph of its own.
struct ReadableForm {
  Expressions readable = {};
  Expressions compact = {};              ///< the shortest that is as precise, however it looks
  std::size_t length = 0;                ///< of the readable one
  bool is_rewritten = false;             ///< code is always the compact one: the other loses digits
  double loss = 0;                       ///< of the compact one (harm.hpp)
  std::optional<Expressions> kept = {};  ///< a longer way that keeps the digits it loses
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
