// diff_data: writes a report as JSON.
#include <array>
#include <utility>

#include "base/json.hpp"
#include "diff/change_words.hpp"
#include "elgen/diff.hpp"

namespace elgen {
namespace {

Json json_of(const Span& span) {
  if (span.source == nullptr) return nullptr;
  const LineColumn at = line_column(*span.source, span.begin);
  return {{"path", span.source->path}, {"line", at.line}, {"column", at.column}};
}

Json json_of(const KeyChange& change) {
  return {{"id", change.entry + "/" + (change.is_reordering ? "order" : text_of(change.path))},
          {"impact", impact_row(change.impact).word},
          {"before", change.before},
          {"after", change.after},
          {"old_place", json_of(change.old_span)},
          {"new_place", json_of(change.new_span)}};
}

/// The words of EntryVerdict in JSON, in the order of the enumerators.
constexpr std::array verdict_words{"identical", "equal", "not_told_apart",
                                   "different", "added", "removed"};

Json json_of(const EntryChange& entry) {
  Json json{{"id", entry.place},
            {"verdict", verdict_words[static_cast<std::size_t>(entry.verdict)]}};
  if (entry.verdict == EntryVerdict::equal) json["proved"] = entry.is_proved;
  if (!may_differ(entry)) return json;
  json["told_apart"] = entry.is_certain;
  json["unit"] = entry.unit;
  for (const auto& [key, text] : {std::pair("before", &entry.before),
                                  {"after", &entry.after},
                                  {"difference", &entry.difference}}) {
    json[key] = text->empty() ? Json(nullptr) : Json(*text);
  }
  json["share"] = entry.relative_change;
  if (entry.witness) {
    const auto& [at, before, after] = *entry.witness;
    json["witness"] = {{"at", at}, {"before", before}, {"after", after}};
  }
  return json;
}

Json json_of(const OutputChange& output) {
  Json entries = Json::array();
  for (const EntryChange& entry : output.entries) entries.push_back(json_of(entry));
  return {{"name", output.name}, {"entries", output.entry_count}, {"changes", std::move(entries)}};
}

Json json_of(const InterfaceChange& change) {
  return {{"impact", impact_row(change.impact).word}, {"text", change.text}};
}

Json json_of(const OperationCounts& n) {
  Json json = Json::object();
  for (const auto& [name, count] : operation_columns) json[std::string(name)] = n.*count;
  return json;
}

Json json_of(const OperationsChange& change) {
  return {{"function", change.function},
          {"before", json_of(change.before)},
          {"after", json_of(change.after)}};
}

Json json_of(const Diagnostic& diagnostic) {
  return {{"code", code_row(diagnostic.code).name},
          {"message", diagnostic.message},
          {"place", json_of(diagnostic.span)}};
}

Json json_of(const UnreadableSystem& system) {
  return {{"path", system.path}, {"error", json_of(system.error)}};
}

template <class List>
Json list_of(const List& list) {
  Json json = Json::array();
  for (const auto& one : list) json.push_back(json_of(one));
  return json;
}

Json json_of(const SystemChange& system) {
  Json outputs = Json::array();
  for (const OutputChange& output : system.outputs) {
    if (!output.entries.empty()) outputs.push_back(json_of(output));
  }
  Json json{{"name", system.name},
            {"path", system.path},
            {"impact", impact_row(system.impact).word},
            {"told_apart", system.is_certain},
            {"keys", list_of(system.keys)},
            {"outputs", std::move(outputs)},
            {"interface", list_of(system.interface)}};
  if (system.operations) json["operations"] = list_of(*system.operations);
  if (!system.extension.empty()) json["extension"] = system.extension;
  json["broken_expectations"] = system.broken_expectations;
  json["warnings"] = list_of(system.warnings);
  return json;
}

}  // namespace

std::string to_json(const DiffReport& report) {
  Json systems = Json::array();
  for (const SystemChange& system : report.systems) systems.push_back(json_of(system));
  const Json json{
      {"format", "elgen diff 1"},
      {"impact", has_verdict(report) ? Json(impact_row(impact_of(report)).word) : Json()},
      {"systems", std::move(systems)},
      {"added", report.added},
      {"removed", report.removed},
      {"unreadable", list_of(report.unreadable)}};
  return json.dump(2) + "\n";
}

}  // namespace elgen
