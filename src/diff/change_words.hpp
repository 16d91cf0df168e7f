// change_words: functions that describe a change of each kind in words.
#pragma once

#include <string>

#include "elgen/diff.hpp"

namespace elgen {

/// The place of a key and two spaces: "models/cart_pole.toml:55:17  "; "" if the key has no place.
[[nodiscard]] std::string place_text(const KeyChange& change);

/// A changed key in words: "[gravity] vector[2]: -g -> g".
[[nodiscard]] std::string text_of(const KeyChange& change);

/// The meaning of an impact: "the equations are the same". Unless `is_certain`, adds that
/// entries were only compared at sampled points.
[[nodiscard]] std::string impact_meaning(Impact impact, bool is_certain);

/// The name of a system, followed by its path if other systems have the same name.
[[nodiscard]] std::string label_of(const DiffReport& report, const SystemChange& system);

/// True if the report has several systems or files, so that each line must name its system.
[[nodiscard]] bool has_several_systems(const DiffReport& report);

/// A system with errors in words: "models/a.toml: E201: unknown name `z`".
[[nodiscard]] std::string text_of(const UnreadableSystem& system);

/// True if the versions differ in this entry, or may differ.
[[nodiscard]] bool may_differ(const EntryChange& entry);

/// The numbers of entries by verdict.
struct VerdictCounts {
  std::size_t all = 0;
  std::size_t different = 0;
  std::size_t undecided = 0;  ///< neither proved equal nor shown to differ
  std::size_t rewritten = 0;
  std::size_t proved = 0;    ///< entries of `rewritten` that are proved equal
  std::size_t replaced = 0;  ///< pairs of a removed and an added entry, as after a rename
  std::size_t added = 0;
  std::size_t removed = 0;

  void add(const OutputChange& output);
  /// "3 of 12 entries differ, 2 rewritten (1 proved)".
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::size_t changed() const { return different + replaced + added + removed; }
};

[[nodiscard]] VerdictCounts counts_of(const SystemChange& system);

/// "a -> b"; "" if a form is missing or too long.
[[nodiscard]] std::string change_text(const EntryChange& entry);

/// The state of the witness, and both values of the entry at this state; "" if there is no witness.
[[nodiscard]] std::string witness_text(const EntryChange& entry);

/// A changed entry in words: "gravity[2] = a -> b, difference c", "gravity[2]: is new",
/// "gravity[2], undecided at 64 points".
[[nodiscard]] std::string text_of(const EntryChange& entry);

/// Changed numbers of operations in words: "mass_matrix: mul 3 -> 4".
[[nodiscard]] std::string text_of(const OperationsChange& change);

}  // namespace elgen
