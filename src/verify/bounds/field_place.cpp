// The places of all fields, in the order of the program.
#include "verify/bounds/field_place.hpp"

namespace elgen {
namespace {

/// What the oracle is asked for.
OutputRequest request_of(const Subject& subject, const Function& function, const Field& field) {
  const OutputRequest request{
      .kind = function.kind, .user = function.user, .iterations = function.iterations};
  if (!output_row(function.kind).repeats) return request;
  const OutputRequest* member = find_request(subject.scene, field.name);
  return member != nullptr ? *member : request;
}

}  // namespace

std::vector<FieldPlace> field_places(const Subject& subject, std::size_t index) {
  const Function& function = subject.program.functions[index];
  const bool holds_others = output_row(function.kind).repeats;
  std::vector<FieldPlace> places;
  std::size_t first = 0;
  for (std::size_t i = 0; i < function.fields.size(); ++i) {
    const Field& field = function.fields[i];
    FieldPlace place;
    place.function = &function;
    place.index = i;
    place.first = first;
    place.judge = judge_of(subject.program, index, field, first);
    place.request = request_of(subject, function, field);
    place.request_field = holds_others ? 0 : i;
    place.first_oracle = holds_others ? 0 : first;
    first += field.entries.size();
    places.push_back(std::move(place));
  }
  return places;
}

std::vector<FieldPlace> field_places(const Subject& subject) {
  std::vector<FieldPlace> places;
  for (std::size_t index = 0; index < subject.program.functions.size(); ++index) {
    for (FieldPlace& place : field_places(subject, index)) places.push_back(std::move(place));
  }
  return places;
}

}  // namespace elgen
