// Fields: finds the fields of an output to which the numbers of foreign code belong.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "elgen/foreign.hpp"
#include "elgen/model.hpp"
#include "elgen/outputs.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// A field of an output: its shape, and the index of its first entry among the oracle's values.
struct ForeignField {
  const FieldRow* row = nullptr;
  std::size_t first_entry = 0;
  std::size_t rows = 1;
  std::size_t columns = 1;

  [[nodiscard]] std::size_t size() const { return rows * columns; }
};
using ForeignFields = std::vector<ForeignField>;

/// The non-empty fields of an output. Remainders are included only for a method that iterates.
[[nodiscard]] ForeignFields foreign_fields_of(const Model& model, const OutputRequest& output);

/// The number of entries of all fields.
[[nodiscard]] std::size_t entry_count(const ForeignFields& fields);

/// The fields of an answer of `count` numbers: the first of the following choices with `count`
/// entries; empty if no choice has `count` entries.
///     the first field
///     all fields without pivots and remainders
///     all fields
///     one other field
[[nodiscard]] ForeignFields match_answer_fields(const ForeignFields& fields, std::size_t count);

/// The field that the claim names, or all fields of its output. E601 if the output or the field
/// does not exist; an error with the reason repeats_outputs for `dynamics`.
[[nodiscard]] Result<ForeignFields> claimed_fields(const CheckedModel& checked,
                                                   const ForeignClaim& claim);

/// The names of the fields: "A, B".
[[nodiscard]] std::string field_names_text(const ForeignFields& fields);

/// The names and sizes of the fields: "A (4), B (2)".
[[nodiscard]] std::string field_sizes_text(const ForeignFields& fields);

/// The name of an entry: "forward_dynamics.acceleration[theta]".
[[nodiscard]] std::string name_of_entry(const Model& model, const OutputRequest& output,
                                        const ForeignField& field, std::size_t entry);

}  // namespace elgen
