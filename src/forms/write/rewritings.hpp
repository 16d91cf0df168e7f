// rewritings: forms of a value with common factors collected. They are candidates for the readable
// form, which pages print, and for the compact form, which code evaluates.
//
// Candidates are written in multiple angles, or with sin^2 replaced by cos^2 or the reverse, each
// with common factors collected. The derived entry is another candidate, if this entry is short and
// as precise as the others. The length of a form counts signs, exponents and calls. The readable
// form is the shortest form, but a form collected by rates, or by rates and coordinates, as in
// textbooks, counts as 12 to 14 % shorter. On a tie the earlier form is chosen. The compact form is
// the shortest form that is as precise as the readable form, because readers judge the code by the
// readable form.
#pragma once

#include <optional>
#include <vector>

#include "accuracy/running_errors.hpp"
#include "elgen/closed_forms.hpp"
#include "program/graph/rebuild.hpp"
#include "sample/points.hpp"

namespace elgen {

/// An entry with more terms is not written out, since nobody reads it. A limit of 1000 changes no
/// page of models/; with 100, entries of the arms are missing.
inline constexpr std::size_t most_terms = 400;

/// One rewriting of a value, with common factors collected.
struct CollectedForm {
  Expressions expressions = {};
  std::size_t terms = 0;  ///< which trigonometric form; groupings of one form have equal errors
  std::size_t length = 0;
  std::size_t weighted_length = 0;  ///< length times the weight of its grouping
};

/// The number of signs and exponents of the only value, plus call_length and multiple_length
/// (real_terms.hpp).
[[nodiscard]] std::size_t written_length(const Expressions& expressions);

/// The rewritings of a closed form in each trigonometric form (real_terms.hpp). Both lists are
/// empty if every rewriting is too long.
struct Rewritings {
  /// Sums of products without collected factors, so that cancelling terms are in the same sum.
  std::vector<Expressions> plain = {};
  std::vector<CollectedForm> collected = {};  ///< in all groupings
};
[[nodiscard]] Rewritings rewritings_of(const Algebra& algebra, const Fraction& form);

/// The derived expression with common factors collected.
[[nodiscard]] CollectedForm derived_rewriting(const Expressions& derived);

/// Rewritings with homogeneous terms (real_terms.hpp), in which nothing cancels when the square of
/// a sine or cosine is 1. They are longer than other rewritings, and only for code.
[[nodiscard]] std::vector<CollectedForm> precise_rewritings(const Algebra& algebra,
                                                            const Fraction& form);

/// True if the homogeneous numerator of `form` has terms and none can be negative, so that nothing
/// cancels. Each coefficient must be positive, and each power even, except powers of roots and of
/// parameters that are assumed to be positive or nonnegative.
[[nodiscard]] bool has_nonnegative_terms(const Algebra& algebra, const Fraction& form,
                                         const LeafNames& leaves);

/// True if the error of `rewriting` is at most max(3 E, 8 |x|) at every point at which `reference`
/// has a value x with error E. False if `reference` has no value at any point, or if `leaves` are
/// exact and only `rewriting` has a sine of a rounded sum. Errors are first-order running errors,
/// in units of rounding. The factor 3 admits every reordering of a sum, which at most doubles the
/// error, but no cancellation.
[[nodiscard]] bool is_as_precise(const Expressions& rewriting, const Expressions& reference,
                                 const Points& points, LeafRounding leaves);

/// The forms of one entry, each over its own graph.
struct ReadableForm {
  Expressions readable = {};
  Expressions compact = {};   ///< shortest form that is as precise as `readable`
  std::size_t length = 0;     ///< length of the readable form
  bool is_shortest = false;   ///< the readable form is also the compact form
  bool is_rewritten = false;  ///< the code must use `compact`, because `readable` loses digits
  bool is_limited = false;    ///< not all rewritings were tried (KeptDigits::is_limited)
  double loss = 0;            ///< loss of the compact form (text_errors.hpp)
  std::optional<Expressions> precise = {};  ///< a longer form with the digits that `compact` loses
};

using ReadableEntries = std::vector<std::optional<ReadableForm>>;  ///< entries of all fields

/// `readable` is the candidate of least weighted length; `compact` is the shortest candidate that
/// is as precise as `readable`. None without candidates. `derived` may be null.
[[nodiscard]] std::optional<ReadableForm> choose_readable_form(
    const std::vector<CollectedForm>& rewritings, const CollectedForm* derived,
    const Points& points);

/// Lowers the readable forms one by one, so that no form is changed for a common subexpression with
/// another entry.
[[nodiscard]] Function lower_separately(const ReadableEntries& entries, const Function& shape,
                                        Program& program);

/// One entry of a function as derived, over the leaves. derived_entry(): none for a long entry.
struct DerivedEntry {
  Expressions unexpanded = {};
  CollectedForm collected = {};  ///< with nested products flattened
};
[[nodiscard]] std::optional<DerivedEntry> derived_entry(const Program& program,
                                                        const Function& function,
                                                        std::uint32_t entry);

}  // namespace elgen
