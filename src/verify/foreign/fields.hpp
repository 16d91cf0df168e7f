// Fields: the fields of an output to which the numbers of foreign code belong.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "elgen/foreign.hpp"
#include "elgen/model.hpp"
#include "elgen/outputs.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// A field of an output: its shape, and the index of its first entry among the oracle's.
struct ForeignField {
  const FieldRow* row = nullptr;
  std::size_t first = 0;
  std::size_t rows = 1;
  std::size_t columns = 1;

  [[nodiscard]] std::size_t size() const { return rows * columns; }
};
using ForeignFields = std::vector<ForeignField>;

/// The non-empty fields that the model has; no remainders for a method that does not iterate.
[[nodiscard]] ForeignFields fields_of(const Model& model, const OutputRequest& output);

/// The number of entries of all fields.
[[nodiscard]] std::size_t size_of(const ForeignFields& fields);

/// The fields of an answer of `count` numbers. The first choice that fits: the first field, all
/// without pivots and remainders, all, or a single other field. Empty: none fits.
[[nodiscard]] ForeignFields answered_fields(const ForeignFields& fields, std::size_t count);

/// The fields of a claim; E601 or E603 if it has none.
[[nodiscard]] Result<ForeignFields> claimed_fields(const CheckedModel& checked,
                                                   const ForeignClaim& claim);

/// "A, B"
[[nodiscard]] std::string names_text(const ForeignFields& fields);

/// "A (4), B (2)": the fields with their sizes.
[[nodiscard]] std::string sizes_text(const ForeignFields& fields);

/// "forward_dynamics.acceleration[theta]"
[[nodiscard]] std::string name_of_entry(const Model& model, const OutputRequest& output,
                                        const ForeignField& field, std::size_t entry);

}  // namespace elgen
