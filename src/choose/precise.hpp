// precise: the way to write an entry that keeps its digits.
//
// Besides the ways that people write there are sums that do not cancel near right angles, the entry
// as it was derived, and differences with roots by their conjugates. Of those that lose nothing the
// shortest is taken, else the one that loses least.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "choose/harm.hpp"
#include "choose/precision.hpp"
#include "choose/readable.hpp"

namespace elgen {

/// An entry that loses digits, and what is wanted in its place.
struct LossyEntry {
  double loss = 0;
  double tolerated = tolerated_loss;  ///< a way that loses no more is good enough
  std::size_t longest = std::numeric_limits<std::size_t>::max();  ///< written length of a way
  std::vector<double> beside = {};  ///< by point, magnitudes of its field; empty: its own
};

/// The shortest way that does not harm the entry with this number; the text as it stands comes
/// last. None where every way does. `derived` may be null.
[[nodiscard]] std::optional<Expressions> harmless_way(const Algebra& algebra, const Fraction& form,
                                                      const DerivedEntry* derived,
                                                      const TextErrors& text, std::size_t entry);

/// None where every way loses about as much. `derived` may be null. Cost: the possible losses of
/// each way, up to the first that is good enough.
[[nodiscard]] std::optional<Expressions> more_precise(const Algebra& algebra, const Fraction& form,
                                                      const DerivedEntry* derived,
                                                      const LossyEntry& entry,
                                                      const ComparisonPoints& points);

/// A sum that does not cancel and is shorter than `known`, where there is one that loses nothing:
/// differences of angles that inputs' own rounding would excuse have all digits in it.
[[nodiscard]] std::optional<Expressions> shorter_precise(const Algebra& algebra,
                                                         const Fraction& form,
                                                         const Expressions& known,
                                                         const ComparisonPoints& points);

}  // namespace elgen
