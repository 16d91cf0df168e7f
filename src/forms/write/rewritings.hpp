// rewritings: the forms in which a closed form can be written, with common factors pulled out of
// its sums; and readable, the shortest of them.
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
#include "program/graph/rebuild.hpp"
#include "sample/points.hpp"

namespace elgen {

/// Beyond this many terms an entry is not written out: nobody reads it. With 1000 the pages of
/// models/ are the same; with 100 entries of the arms are missing.
inline constexpr std::size_t most_terms = 400;

/// One rewriting of a value.
struct Collected {
  Expressions expressions = {};
  std::size_t terms = 0;  ///< which: another grouping of the same terms does not change errors
  std::size_t length = 0;
  std::size_t weighted_length = 0;  ///< length times the weight of its grouping
};

/// Signs and calls of the one value.
[[nodiscard]] std::size_t written_length(const Expressions& expressions);

/// A closed form in multiple angles, by sines and by cosines; none where it is beyond most_terms.
struct Rewritings {
  /// Sums of products: nothing is collected, so that terms which cancel stand together.
  std::vector<Expressions> plain = {};
  std::vector<Collected> collected = {};  ///< in all groupings
};
[[nodiscard]] Rewritings rewritings_of(const Algebra& algebra, const Fraction& form);

/// As it was derived.
[[nodiscard]] Collected derived_rewriting(const Expressions& derived);

/// In sums that do not cancel where one square of an angle is 1 (real_terms.hpp: homogeneous):
/// longer, and for code only.
[[nodiscard]] std::vector<Collected> precise_rewritings(const Algebra& algebra,
                                                        const Fraction& form);

/// Whether, by running errors to first order and wherever `reference` has a value x, the error of
/// `rewriting` is at most three times that of `reference`, or at most 8 |x|, which no judge
/// refuses; false where it has none at any point. One and the same sum counts up to twice as much
/// when its terms are added in another order; what cancels is beyond any factor.
[[nodiscard]] bool is_as_precise(const Expressions& rewriting, const Expressions& reference,
                                 const Points& points, Leaves leaves);

/// One value, twice, each over a graph of its own.
struct ReadableForm {
  Expressions readable = {};
  Expressions compact = {};              ///< the shortest that is as precise, however it looks
  std::size_t length = 0;                ///< of the readable one
  bool is_shortest = false;              ///< the readable one: it is the compact one, too
  bool is_rewritten = false;             ///< code is always the compact one: the other loses digits
  double loss = 0;                       ///< of the compact one (text_errors.hpp)
  std::optional<Expressions> kept = {};  ///< a longer one that keeps the digits it loses
};

using ReadableEntries = std::vector<std::optional<ReadableForm>>;  ///< of all fields

/// The shortest candidate; none where all are too long. `derived` may be null.
[[nodiscard]] std::optional<ReadableForm> shortest(const std::vector<Collected>& rewritings,
                                                   const Collected* derived, const Points& points);

/// As they are read, entry by entry, so that nothing is taken apart for what another entry shares.
[[nodiscard]] Function lowered_one_by_one(const ReadableEntries& entries, const Function& shape,
                                          Program& program);

/// One entry of a function as it was derived, over the leaves; none where that is long.
struct DerivedEntry {
  Expressions as_it_stands = {};
  Collected collected = {};  ///< with products written out in products
};
[[nodiscard]] std::optional<DerivedEntry> as_derived(const Program& program,
                                                     const Function& function, std::uint32_t entry);

}  // namespace elgen
