// entries: chooses how each entry of a function is written, and lowers entries to instructions.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "choose/text_errors.hpp"
#include "forms/write/remainders.hpp"
#include "forms/write/rewritings.hpp"
#include "program/graph/angle_sums.hpp"

namespace elgen {

/// The largest cost of a form that keeps digits, in quarters of the cost of the cheapest form.
inline constexpr std::size_t quarters_for_balance = 5;

/// True if cost <= quarters/4 * other + the cost of one division.
[[nodiscard]] bool is_affordable(std::size_t cost, std::size_t other, std::size_t quarters);

/// True if every entry has a closed form and the forms together are not too long.
[[nodiscard]] bool has_closed_form(const ClosedFunction& closed);

/// The errors of the recursive form, null if accuracy does not matter, and the places at which sums
/// of the entries may vanish.
struct AccuracySearch {
  FormErrors* text = nullptr;
  std::span<const ExactPlace> places = {};
};

/// The entries of functions[index] of the recursive program; empty if the closed forms together are
/// too long. If search.text is not null, an accurate rewriting replaces each inaccurate entry if
/// one exists, and an entry that loses digits gets a rewriting that keeps these digits.
[[nodiscard]] ReadableEntries read_entries(const Program& program, const ClosedForms& forms,
                                           std::size_t index, const Points& points,
                                           AccuracySearch search = {});

/// True if there are entries and all have a form.
[[nodiscard]] bool is_complete(const ReadableEntries& entries);

/// The total number of signs and calls. The entries must be complete.
[[nodiscard]] std::size_t total_length(const ReadableEntries& entries);

/// The indices below `count` of the rewritten entries. Later entries belong to `diagonal_field`,
/// which is not emitted.
[[nodiscard]] std::vector<std::uint32_t> rewritten_entries(const ReadableEntries& entries,
                                                           std::size_t count);

/// The index of the first entry for which not all rewritings were tried; none if all were.
[[nodiscard]] std::optional<std::size_t> first_limited_entry(const ReadableEntries& entries);

/// Replaces each entry that loses more than `limit` by its rewriting that keeps digits. None if no
/// entry is replaced.
[[nodiscard]] std::optional<ReadableEntries> replace_lossy_entries(const ReadableEntries& entries,
                                                                   double limit);

/// Replaces the readable form of each rewritten entry by the computed form if the readable form is
/// less precise: readers judge the code by the form on the page.
void show_computed_forms(ReadableEntries& entries, const Points& points);

/// All entries of a function as instructions, and the index of the first inaccurate entry, if any.
struct LoweredEntries {
  Function function = {};
  std::optional<std::size_t> first_inaccurate = {};
};

/// Requirements for lowered entries.
struct LoweringRequirements {
  ExpandedAngles splits =
      ExpandedAngles::sums_and_differences;  ///< which sums of angles may be split
  const FormErrors* text = nullptr;          ///< null: choose the cheapest form
  double max_loss = 0;                       ///< largest loss that is accepted
  std::size_t most_quarters = 4;             ///< cost limit in quarters of the cheapest form
};

/// Lowers all entries in one graph, in their readable or compact forms. Chooses the cheapest
/// accurate form, or a slightly dearer one with a tolerated loss. `shape` names the entries;
/// `program` receives their constants.
[[nodiscard]] LoweredEntries lower_jointly(const ReadableEntries& entries, const Function& shape,
                                           Program& program, const LoweringRequirements& aim);

}  // namespace elgen
