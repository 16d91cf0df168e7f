// Finds the fields of an answer by the count of its numbers, because the numbers have no names.
#include "verify/foreign/fields.hpp"

#include <fmt/ranges.h>

#include <numeric>

#include "base/reason.hpp"
#include "elgen/wording.hpp"
#include "model/requests.hpp"

namespace elgen {
std::size_t entry_count(const ForeignFields& fields) {
  return std::accumulate(
      fields.begin(), fields.end(), std::size_t{0},
      [](std::size_t sum, const ForeignField& field) { return sum + field.size(); });
}

ForeignFields foreign_fields_of(const Model& model, const OutputRequest& output) {
  const auto& rows = output_row(output.kind).fields;
  ForeignFields fields;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ForeignField field{&rows[i], first_entry_index(model, output, i),
                             extent_size(model, rows[i].rows, output.user),
                             extent_size(model, rows[i].columns, output.user)};
    if (has_field(output, rows[i]) && field.size() > 0) fields.push_back(field);
  }
  return fields;
}

ForeignFields match_answer_fields(const ForeignFields& fields, std::size_t count) {
  std::vector<ForeignFields> choices{{}, fields, fields};
  if (!fields.empty()) choices.front() = {fields.front()};
  std::erase_if(choices[1], [](const ForeignField& field) {
    return field.row->rows == Extent::pivots || field.row->is_residual;
  });
  for (const ForeignField& field : fields) choices.push_back({field});
  for (const ForeignFields& choice : choices) {
    if (entry_count(choice) == count) return choice;
  }
  return {};
}

std::string field_names_text(const ForeignFields& fields) {
  std::vector<std::string_view> names;
  for (const ForeignField& field : fields) names.push_back(field.row->name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string field_sizes_text(const ForeignFields& fields) {
  std::vector<std::string> texts;
  for (const ForeignField& field : fields) {
    texts.push_back(fmt::format("{} ({})", field.row->name, field.size()));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string name_of_entry(const Model& model, const OutputRequest& output,
                          const ForeignField& field, std::size_t entry) {
  const FieldRow& row = *field.row;
  const auto label = [&](Extent extent, std::size_t at) {
    return line_at(model, extent, at, output.user)->text();
  };
  std::string name = output.name + (row.name.empty() ? "" : ".") + std::string(row.name);
  if (field.size() == 1) return name;
  std::vector<std::string> labels{label(row.rows, entry / field.columns)};
  if (field.columns > 1) labels.push_back(label(row.columns, entry % field.columns));
  if (labels.front().starts_with(name + "[") && labels.size() == 1) return labels.front();
  if (labels.front().empty()) labels.erase(labels.begin());
  return fmt::format("{}[{}]", name, fmt::join(labels, ", "));
}

Result<ForeignFields> claimed_fields(const CheckedModel& checked, const ForeignClaim& claim) {
  const std::string name = quote_text(claim.output);
  const OutputRequest* const output = find_request(checked.scene, claim.output);
  if (output == nullptr) return Diagnostic{Code::E601, {}, name + " is not one output"};
  if (output_row(output->kind).is_summary) {
    return Diagnostic{
        Reason::repeats_outputs, {}, name + " repeats other outputs", "name one of these"};
  }
  ForeignFields fields = foreign_fields_of(checked.model, *output);
  if (claim.field.empty()) return fields;
  const std::string names = field_names_text(fields);
  std::erase_if(fields, [&](const ForeignField& field) { return field.row->name != claim.field; });
  if (!fields.empty()) return fields;
  return Diagnostic{Code::E601,
                    {},
                    name + " has no field " + quote_text(claim.field),
                    names.empty() ? "" : "its fields are " + names};
}

}  // namespace elgen
