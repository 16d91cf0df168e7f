// entries: how each entry of a function is written, and all of them as instructions.
#pragma once

#include <optional>
#include <vector>

#include "choose/text_errors.hpp"
#include "forms/write/rewritings.hpp"
#include "program/graph/angle_sums.hpp"

namespace elgen {

/// Whether one cost is at most so many quarters of another, or a division more.
[[nodiscard]] bool is_affordable(std::size_t cost, std::size_t other, std::size_t quarters);

/// Whether every entry has a closed form, and all together are not too long.
[[nodiscard]] bool has_closed_form(const ClosedFunction& closed);

/// The entries of functions[index] of the recursive program; none where the closed forms are too
/// long together. With `text`, inaccurate entries get an accurate rewriting if there is one, and
/// each entry has one that keeps its digits.
[[nodiscard]] ReadableEntries read_entries(const Program& program, const ClosedForms& forms,
                                           std::size_t index, const Points& points,
                                           TextErrors* text = nullptr);

/// Whether there are entries, and each has a form.
[[nodiscard]] bool is_complete(const ReadableEntries& entries);

/// Signs and calls of all of them together, where they are complete.
[[nodiscard]] std::size_t length(const ReadableEntries& entries);

/// The numbers of those that are rewritten, out of the first `count`: pivots of M are not
/// emitted with the others.
[[nodiscard]] std::vector<std::uint32_t> rewritten_entries(const ReadableEntries& entries,
                                                           std::size_t count);

/// Replaces entries that lose more than `limit` by rewritings that keep their digits; none where no
/// entry loses so much or has a rewriting.
[[nodiscard]] std::optional<ReadableEntries> with_kept(const ReadableEntries& entries,
                                                       double limit);

/// Shows rewritten entries as they are computed where the readable form is less precise, since the
/// code is judged by what is shown.
void read_as_precisely(ReadableEntries& entries, const Points& points);

/// All entries of a function as instructions, and the first inaccurate one.
struct Lowered {
  Function function = {};
  std::optional<std::size_t> inaccurate = {};
};

/// The demands on lowered entries.
struct LoweringAim {
  Splits splits = Splits::sums_and_differences;  ///< which angles may be taken apart
  const TextErrors* text = nullptr;              ///< null: the cheapest form is taken
  double tolerated = 0;                          ///< a loss
  std::size_t most_quarters = 4;  ///< of the cost of the cheapest form, for one that loses no more
};

/// All entries over one graph, as they are read or in their shortest forms: the cheapest accurate
/// one, or one that is a little dearer and loses no more than tolerated. `shape` says which they
/// are; `program` gets their constants.
[[nodiscard]] Lowered lowered_together(const ReadableEntries& entries, const Function& shape,
                                       Program& program, const LoweringAim& aim);

}  // namespace elgen
