// FieldPlace: one field of a function of the program, and what it is compared with.
#pragma once

#include <vector>

#include "program/evaluate/subject.hpp"

namespace elgen {

/// The closed form that a function was emitted in, as it is printed.
struct ClosedForm {
  const Function* function = nullptr;  ///< null where there is none
  std::size_t first = 0;               ///< of the field's entries among the form's
};

struct FieldPlace {
  const Function* function = nullptr;
  std::size_t index = 0;  ///< of the field among the function's
  std::size_t first = 0;  ///< of its entries among the function's
  ClosedForm form = {};
  OutputRequest request = {};     ///< the request to the oracle
  std::size_t request_field = 0;  ///< of the field in the output table; a model may lack others
  std::size_t first_oracle = 0;   ///< of its entries among the oracle's

  [[nodiscard]] const Field& field() const { return function->fields[index]; }
  [[nodiscard]] const FieldRow& row() const { return field_row(request.kind, field().name); }
  /// Whether its terms cancel up to their rounding, so that it has no digits to lose.
  [[nodiscard]] bool is_remainder() const { return row().is_remainder; }
};

/// Fields of functions[index], one after another. `dynamics` holds other outputs under their names;
/// every other function is one output.
[[nodiscard]] std::vector<FieldPlace> field_places(const Subject& subject, std::size_t index);

/// Fields of all functions.
[[nodiscard]] std::vector<FieldPlace> field_places(const Subject& subject);

}  // namespace elgen
