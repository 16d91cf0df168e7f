// Finds the oracle's request and the closed form of each field, in the order of the program.
#include "verify/bounds/field_place.hpp"

#include <algorithm>

#include "model/requests.hpp"

namespace elgen {
namespace {

/// The request whose oracle values belong to the field.
OutputRequest oracle_request(const SystemUnderTest& subject, const Function& function,
                             const Field& field) {
  const bool repeats = output_row(function.kind).is_summary;
  const OutputRequest* const asked =
      find_request(subject.scene, repeats ? field.name : function.name);
  if (asked != nullptr && (repeats || asked->kind == function.kind)) return *asked;
  return {.kind = function.kind,
          .user = function.user,
          .step = function.step,
          .independent = function.independent};
}

/// The index of a field in the output table; 0 if the output has no field of this name.
std::size_t field_index(OutputKind kind, std::string_view name) {
  const std::span<const FieldRow> fields = output_row(kind).fields;
  const auto found = std::ranges::find(fields, name, &FieldRow::name);
  return found == fields.end() ? 0 : static_cast<std::size_t>(found - fields.begin());
}

/// The closed form of one field of functions[index], whose entries start at `first`.
ClosedForm closed_form_of(const Program& program, std::size_t index, const Field& field,
                          std::size_t first) {
  const Function& function = program.functions[index];
  if (function.form != Form::closed) return {};
  if (!output_row(function.kind).is_summary) {
    const bool is_readable =
        index < program.readable.size() && !program.readable[index].fields.empty();
    return is_readable ? ClosedForm{&program.readable[index], first} : ClosedForm{};
  }
  // A field of `dynamics` has the entries of the function with this name.
  for (const Function& readable : program.readable) {
    if (readable.name == field.name && !readable.fields.empty()) return {&readable, 0};
  }
  return {};
}

}  // namespace

std::vector<ComparedField> compared_fields(const SystemUnderTest& subject, std::size_t index) {
  const Function& function = subject.program.functions[index];
  const bool holds_others = output_row(function.kind).is_summary;
  std::vector<ComparedField> places;
  std::size_t first = 0;
  for (std::size_t i = 0; i < function.fields.size(); ++i) {
    const Field& field = function.fields[i];
    ComparedField place;
    place.function = &function;
    place.field_index = i;
    place.first_entry = first;
    place.closed_form = closed_form_of(subject.program, index, field, first);
    place.request = oracle_request(subject, function, field);
    place.request_field_index = field_index(place.request.kind, field.name);
    if (!holds_others) {
      place.first_oracle_entry = first_entry_index(
          subject.model, {.kind = function.kind, .user = function.user}, place.request_field_index);
    }
    first += field.entries.size();
    places.push_back(std::move(place));
  }
  return places;
}

std::vector<ComparedField> field_places(const SystemUnderTest& subject) {
  std::vector<ComparedField> places;
  for (std::size_t index = 0; index < subject.program.functions.size(); ++index) {
    for (ComparedField& place : compared_fields(subject, index)) places.push_back(std::move(place));
  }
  return places;
}

}  // namespace elgen
