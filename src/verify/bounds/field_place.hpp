// FieldPlace: one field of a function of the program, and its counterparts: the oracle's values and
// the closed form.
#pragma once

#include <vector>

#include "program/evaluate/subject.hpp"

namespace elgen {

/// The closed form of an emitted function, as it is printed.
struct ClosedForm {
  const Function* function = nullptr;  ///< null if there is none
  std::size_t first = 0;               ///< index of the field's first entry in the form
};

struct FieldPlace {
  const Function* function = nullptr;
  std::size_t index = 0;  ///< index of the field in the function
  std::size_t first = 0;  ///< index of its first entry in the function
  ClosedForm form = {};
  OutputRequest request = {};     ///< the request to the oracle
  std::size_t request_field = 0;  ///< index in the output table; a model may lack fields
  std::size_t first_oracle = 0;   ///< index of its first entry among the oracle's values

  [[nodiscard]] const Field& field() const { return function->fields[index]; }
  [[nodiscard]] const FieldRow& row() const { return field_row(request.kind, field().name); }
  /// True if its terms cancel up to their rounding, so that it has no digits to lose.
  [[nodiscard]] bool is_remainder() const { return row().is_remainder; }
};

/// The fields of functions[index], in order. `dynamics` contains other outputs under their names;
/// every other function is one output.
[[nodiscard]] std::vector<FieldPlace> field_places(const Subject& subject, std::size_t index);

/// Fields of all functions.
[[nodiscard]] std::vector<FieldPlace> field_places(const Subject& subject);

}  // namespace elgen
