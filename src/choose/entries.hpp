// entries: how each entry of a function is written, and the entries as instructions.
#pragma once

#include <optional>
#include <vector>

#include "choose/text_errors.hpp"
#include "forms/write/rewritings.hpp"
#include "program/graph/angle_sums.hpp"

namespace elgen {

/// Whether a cost is at most `quarters` quarters of another, or one division more.
[[nodiscard]] bool is_affordable(std::size_t cost, std::size_t other, std::size_t quarters);

/// Whether every entry has a closed form, and their total length is within limits.
[[nodiscard]] bool has_closed_form(const ClosedFunction& closed);

/// The entries of functions[index] of the recursive program; none if the closed forms are too long
/// in total. With `text`, inaccurate entries get an accurate rewriting if there is one, and each
/// entry has a rewriting that keeps its digits.
[[nodiscard]] ReadableEntries read_entries(const Program& program, const ClosedForms& forms,
                                           std::size_t index, const Points& points,
                                           TextErrors* text = nullptr);

/// Whether there are entries and all have a form.
[[nodiscard]] bool is_complete(const ReadableEntries& entries);

/// The total number of signs and calls if the entries are complete.
[[nodiscard]] std::size_t length(const ReadableEntries& entries);

/// The numbers of rewritten entries among the first `count`, as pivots of M are not emitted with
/// the others.
[[nodiscard]] std::vector<std::uint32_t> rewritten_entries(const ReadableEntries& entries,
                                                           std::size_t count);

/// Replaces entries that lose more than `limit` by rewritings that keep their digits; none if no
/// entry loses so much or has a rewriting.
[[nodiscard]] std::optional<ReadableEntries> with_kept(const ReadableEntries& entries,
                                                       double limit);

/// Shows rewritten entries as they are computed if the readable form is less precise, since readers
/// judge the code by the form they see.
void read_as_precisely(ReadableEntries& entries, const Points& points);

/// All entries of a function as instructions, and the first inaccurate entry.
struct Lowered {
  Function function = {};
  std::optional<std::size_t> inaccurate = {};
};

/// Requirements for lowered entries.
struct LoweringAim {
  Splits splits = Splits::sums_and_differences;  ///< angles that may be split
  const TextErrors* text = nullptr;              ///< null: take the cheapest form
  double tolerated = 0;                          ///< loss
  std::size_t most_quarters = 4;  ///< of the cheapest cost, for a form that loses no more
};

/// All entries over one graph, in their readable or shortest forms: the cheapest accurate form, or
/// a slightly dearer one that loses no more than tolerated. `shape` names the entries; `program`
/// gets their constants.
[[nodiscard]] Lowered lowered_together(const ReadableEntries& entries, const Function& shape,
                                       Program& program, const LoweringAim& aim);

}  // namespace elgen
