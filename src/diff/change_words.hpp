// change_words: single changes as text.
#pragma once

#include <string>

#include "elgen/diff.hpp"

namespace elgen {

/// "models/cart_pole.toml:55:17  "; "" without a place
[[nodiscard]] std::string place_text(const KeyChange& change);

/// "[gravity] vector[2]: -g -> g"
[[nodiscard]] std::string text_of(const KeyChange& change);

/// "the equations are the same"; it says so if only sampled points show this.
[[nodiscard]] std::string meaning(Impact impact, bool is_told_apart);

/// The name of a system, with its path if other systems have the same name.
[[nodiscard]] std::string label_of(const DiffReport& report, const SystemChange& system);

/// True if lines have to name their systems.
[[nodiscard]] bool has_several(const DiffReport& report);

/// "models/a.toml: E201: unknown name `z`"
[[nodiscard]] std::string text_of(const UnreadableSystem& system);

/// True if the versions differ in this entry, or may differ.
[[nodiscard]] bool may_differ(const EntryChange& entry);

/// Numbers of entries by verdict.
struct VerdictCounts {
  std::size_t all = 0;
  std::size_t different = 0;
  std::size_t undecided = 0;  ///< neither proved equal nor different
  std::size_t rewritten = 0;
  std::size_t proved = 0;    ///< rewritten entries whose equality is proved
  std::size_t replaced = 0;  ///< an old entry is gone and a new one exists, as after a rename
  std::size_t added = 0;
  std::size_t removed = 0;

  void add(const OutputChange& output);
  /// "3 of 12 entries differ, 2 rewritten (1 proved)"
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::size_t changed() const { return different + replaced + added + removed; }
};

[[nodiscard]] VerdictCounts counts_of(const SystemChange& system);

/// "a -> b"; "" without a closed form that is short enough
[[nodiscard]] std::string change_text(const EntryChange& entry);

/// A state, and the values of the entry at it; "" without a witness.
[[nodiscard]] std::string witness_text(const EntryChange& entry);

/// "gravity[2] = a -> b, difference c", "gravity[2]: is new", "gravity[2], not told apart at 64
/// points"
[[nodiscard]] std::string text_of(const EntryChange& entry);

/// "mass_matrix: mul 3 -> 4"
[[nodiscard]] std::string text_of(const OperationsChange& change);

}  // namespace elgen
