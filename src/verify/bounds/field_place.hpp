// ComparedField: one field of a function of the program, with the oracle's request and the closed
// form to which it is compared.
#pragma once

#include <vector>

#include "program/evaluate/subject.hpp"

namespace elgen {

/// The closed form of an emitted function, as pages print it.
struct ClosedForm {
  const Function* function = nullptr;  ///< null if there is none
  std::size_t first_entry = 0;         ///< index of the field's first entry in the form
};

struct ComparedField {
  const Function* function = nullptr;
  std::size_t field_index = 0;  ///< index of the field in the function
  std::size_t first_entry = 0;  ///< index of the field's first entry in the function
  ClosedForm closed_form = {};
  OutputRequest request = {};           ///< output whose oracle values belong to the field
  std::size_t request_field_index = 0;  ///< index of the field in the output table
  std::size_t first_oracle_entry = 0;   ///< index of the field's first value among the oracle's

  [[nodiscard]] const Field& field() const { return function->fields[field_index]; }
  [[nodiscard]] const FieldRow& row() const { return field_row(request.kind, field().name); }
  /// True for a remainder of an iteration: its terms cancel up to rounding errors, so no
  /// loss of digits is measured.
  [[nodiscard]] bool is_remainder() const { return row().is_residual; }
};

/// The fields of functions[index], in order. `dynamics` has one field per output, named after this
/// output; every other function is one output.
[[nodiscard]] std::vector<ComparedField> compared_fields(const SystemUnderTest& subject,
                                                         std::size_t index);

/// The fields of all functions, in order.
[[nodiscard]] std::vector<ComparedField> field_places(const SystemUnderTest& subject);

}  // namespace elgen
