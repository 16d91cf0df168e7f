// change_words: single changes in words.
#pragma once

#include <string>

#include "elgen/diff.hpp"

namespace elgen {

/// "models/cart_pole.toml:55:17  "; "" where it has no place
[[nodiscard]] std::string place_text(const KeyChange& change);

/// "[gravity] vector[2]: -g -> g"
[[nodiscard]] std::string text_of(const KeyChange& change);

/// "the equations are the same", and where nothing but points say so, that.
[[nodiscard]] std::string meaning(Impact impact, bool is_told_apart);

/// The name of a system, and where others have it, too, its path.
[[nodiscard]] std::string label_of(const DiffReport& report, const SystemChange& system);

/// Whether lines have to name their systems.
[[nodiscard]] bool has_several(const DiffReport& report);

/// "models/a.toml: E201: unknown name `z`"
[[nodiscard]] std::string text_of(const UnreadableSystem& system);

/// Whether the versions differ in this entry, or nothing tells.
[[nodiscard]] bool may_differ(const EntryChange& entry);

/// Entries by their verdicts.
struct VerdictCounts {
  std::size_t all = 0;
  std::size_t different = 0;
  std::size_t undecided = 0;  ///< not told apart
  std::size_t rewritten = 0;
  std::size_t proved = 0;    ///< of those that are rewritten
  std::size_t replaced = 0;  ///< one is gone and another is there, as where a name is another one
  std::size_t added = 0;
  std::size_t removed = 0;

  void add(const OutputChange& output);
  /// "3 of 12 entries differ, 2 rewritten (1 proved)"
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::size_t changed() const { return different + replaced + added + removed; }
};

[[nodiscard]] VerdictCounts counts_of(const SystemChange& system);

/// "a -> b"; "" where there is no closed form that is short enough
[[nodiscard]] std::string change_text(const EntryChange& entry);

/// Where the entry was looked at, and what it was there; "" where it was at no state.
[[nodiscard]] std::string witness_text(const EntryChange& entry);

/// "gravity[2] = a -> b, difference c", "gravity[2]: is new", "gravity[2], not told apart at 64
/// points"
[[nodiscard]] std::string text_of(const EntryChange& entry);

/// "mass_matrix: mul 3 -> 4"
[[nodiscard]] std::string text_of(const OperationsChange& change);

}  // namespace elgen
