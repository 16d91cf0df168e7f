// entries: how each entry of a function is written, and all of them as instructions.
#pragma once

#include <optional>
#include <vector>

#include "choose/harm.hpp"
#include "choose/precision.hpp"
#include "choose/readable.hpp"
#include "lower/graph/angle_sums.hpp"

namespace elgen {

using ReadableEntries = std::vector<std::optional<ReadableForm>>;  ///< of all fields

/// One function in both forms.
struct BothForms {
  const Program& program;    ///< of the recursive form
  const Function& function;  ///< the recursive form
  const ClosedForms& forms;
  const ClosedFunction& closed;
};

/// None where the closed forms are too long together. With `text`, an entry that the shortest ways
/// harm is rewritten where there is one that does not.
[[nodiscard]] ReadableEntries read_entries(const BothForms& both, const MixedPoints& points,
                                           const TextErrors* text);

/// Whether there are entries, and each has a form.
[[nodiscard]] bool is_complete(const ReadableEntries& entries);

/// Signs and calls of all of them together, where they are complete.
[[nodiscard]] std::size_t length(const ReadableEntries& entries);

/// The numbers of those that rewrite() has written, out of the first `count`: pivots of M are not
/// emitted with the others.
[[nodiscard]] std::vector<std::uint32_t> rewritten_entries(const ReadableEntries& entries,
                                                           std::size_t count);

/// How entries are judged that lose digits.
struct Judgement {
  const ComparisonPoints& points;
  double tolerated =
      tolerated_loss;          ///< of an entry that loses no more only shorter ways are taken
  Magnitudes magnitudes = {};  ///< by point and entry; empty: each entry by itself
  bool prefers_short = false;  ///< in what solves: sums that keep all digits and are shorter
};

/// Writes the entries that lose digits in ways that do not; whether there is one. `losses` are
/// those of the code, entry by entry.
[[nodiscard]] bool rewrite(ReadableEntries& entries, const std::vector<double>& losses,
                           const BothForms& both, const Judgement& judgement);

/// Shows those that rewrite() has written as they are computed where they would be shown in a way
/// that is less precise, which would judge the code.
void read_as_precisely(ReadableEntries& entries, const MixedPoints& points);

/// All entries of a function as instructions, and the first one that is harmed by them.
struct Lowered {
  Function function = {};
  std::optional<std::size_t> harmed = {};
};

/// All entries over one graph, as they are read or in their shortest forms: the cheaper one that
/// harms nothing, with angles taken apart as `splits` says, or with their differences left whole.
/// `shape` says which they are; `program` gets their constants. `text` may be null.
[[nodiscard]] Lowered lowered_together(const ReadableEntries& entries, const Function& shape,
                                       Program& program, Splits splits, const TextErrors* text);

/// As they are read, entry by entry, so that nothing is taken apart for what another entry shares.
[[nodiscard]] Function lowered_one_by_one(const ReadableEntries& entries, const Function& shape,
                                          Program& program);

}  // namespace elgen
