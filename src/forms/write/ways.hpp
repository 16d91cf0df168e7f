// ways: the ways to write a closed form, each collected: common factors are pulled out of its sums.
#pragma once

#include <optional>
#include <vector>

#include "elgen/closed_forms.hpp"
#include "program/graph/rebuild.hpp"

namespace elgen {

/// Beyond this many terms an entry is not written out: nobody reads it. With 1000 the pages of
/// models/ are the same; with 100 entries of the arms are missing.
inline constexpr std::size_t most_terms = 400;

/// One way to write a value.
struct Collected {
  Expressions expressions = {};
  std::size_t terms = 0;  ///< which: grouping the same terms in another way does not change errors
  std::size_t length = 0;
  std::size_t weighted_length = 0;  ///< length times the weight of its grouping
};

/// Signs and calls of the one value.
[[nodiscard]] std::size_t written_length(const Expressions& expressions);

/// The closed form in multiple angles, by sines and by cosines, in all groupings; none where it is
/// beyond most_terms.
[[nodiscard]] std::vector<Collected> collected_ways(const Algebra& algebra, const Fraction& form);

/// The same as sums of products: nothing is collected, so that terms which cancel stand together.
[[nodiscard]] std::vector<Expressions> plain_ways(const Algebra& algebra, const Fraction& form);

/// As it was derived.
[[nodiscard]] Collected derived_way(const Expressions& derived);

/// In sums that do not cancel where one square of an angle is 1 (real_terms.hpp: homogeneous):
/// longer, and for code only.
[[nodiscard]] std::vector<Collected> precise_ways(const Algebra& algebra, const Fraction& form);

}  // namespace elgen
