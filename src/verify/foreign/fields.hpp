// Fields: which fields of an output the numbers of foreign code are.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "elgen/foreign.hpp"
#include "elgen/model.hpp"
#include "elgen/outputs.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// A field of an output: its shape, and where its entries begin among the oracle's.
struct ForeignField {
  const FieldRow* row = nullptr;
  std::size_t first = 0;
  std::size_t rows = 1;
  std::size_t columns = 1;

  [[nodiscard]] std::size_t size() const { return rows * columns; }
};
using ForeignFields = std::vector<ForeignField>;

/// The fields that the model gives, none of them empty; without remainders of a method that does
/// not iterate.
[[nodiscard]] ForeignFields fields_of(const Model& model, const OutputRequest& output);

/// The entries of all of them.
[[nodiscard]] std::size_t size_of(const ForeignFields& fields);

/// The fields of an answer of `count` numbers: the first one, all without pivots and remainders,
/// all, or another one alone, whatever fits first. Empty: none fits.
[[nodiscard]] ForeignFields answered_fields(const ForeignFields& fields, std::size_t count);

/// The fields that a claim is about. E601, E603.
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
