// A certificate for programs, and the schema of it.
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/json_schema.hpp"
#include "elgen/certificate.hpp"

namespace elgen {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 4> verdict_names{"holds", "fails", "skipped", "noted"};
constexpr std::array<std::string_view, 4> obstacle_names{"overflow", "undefined", "ill_conditioned",
                                                         "singular"};
constexpr std::array<std::string_view, 3> evidence_names{"states", "proof", "zeros"};

template <class Enum, std::size_t size>
std::string_view name_in(const std::array<std::string_view, size>& words, Enum value) {
  return words[static_cast<std::size_t>(value)];
}

Json json_of(const CertificateRow& row) {
  Json skipped = Json::object();
  for (const SkippedStates& some : row.skipped) {
    skipped[std::string(name_in(obstacle_names, some.obstacle))] = some.states;
  }
  Json json{{"check", row.check},     {"output", row.output},
            {"subject", row.subject}, {"verdict", name_in(verdict_names, row.verdict)},
            {"formula", row.formula}, {"evidence", name_in(evidence_names, row.evidence)},
            {"samples", row.samples}, {"skipped_states", skipped}};
  // JSON has no infinity, which a value that is no number is off by, and one whose R is 0.
  if (row.error && std::isfinite(*row.error)) json["error_in_bounds"] = *row.error;
  if (row.loss && std::isfinite(*row.loss)) json["loss"] = *row.loss;
  if (row.loss_of_field && std::isfinite(*row.loss_of_field)) {
    json["loss_of_field"] = *row.loss_of_field;
  }
  json["worst"] = row.worst;
  json["worst_at"] = row.where;
  json["tolerance"] = row.tolerance;
  return json;
}

Json text(std::string_view doc) { return value_schema("string", doc); }

Json whole_number(std::string_view doc = {}) {
  Json schema = value_schema("integer", doc);
  schema["minimum"] = 0;
  return schema;
}

template <std::size_t size>
Json words(const std::array<std::string_view, size>& all, std::string_view doc) {
  return word_schema({all.begin(), all.end()}, doc);
}

Json skipped_schema() {
  std::vector<SchemaKey> keys;
  for (const std::string_view name : obstacle_names) keys.push_back({name, whole_number(), false});
  return object_schema(std::move(keys), "states at which nothing is said, by the reason");
}

Json check_schema() {
  return object_schema(
      {{"check", text("what was compared with what")},
       {"output", text("the function")},
       {"subject", text("the field or entry of it, and the scalar")},
       {"verdict", words(verdict_names,
                         "noted: half of the digits are lost, or a side of a kink was not seen")},
       {"formula", text("what was evaluated")},
       {"evidence",
        words(evidence_names, "compared at states; proved for all; zeros found at random points")},
       {"samples", whole_number("states at which it was compared")},
       {"skipped_states", skipped_schema()},
       {"error_in_bounds", value_schema("number", "largest error in u B, where finite"), false},
       {"loss", value_schema("number", "largest loss of digits in u R, where finite"), false},
       {"loss_of_field", value_schema("number", "the same in u of the field's largest entry"),
        false},
       {"worst", text("the worst figure, with its unit")},
       {"worst_at", text("the state of the worst figure")},
       {"tolerance", text("the bound, and its reason")}});
}

Json screened_schema() {
  std::vector<SchemaKey> keys;
  for (const ScalarRow& scalar : scalar_table) {
    keys.push_back({scalar.name,
                    object_schema({{"states", whole_number()}, {"visited", whole_number()}}),
                    false});
  }
  return object_schema(std::move(keys), "by scalar: states screened, and of them visited");
}

}  // namespace

std::string to_json(const Certificate& certificate) {
  Json checks = Json::array();
  for (const CertificateRow& row : certificate.rows) checks.push_back(json_of(row));
  Json screened = Json::object();
  for (const ScreenedCount& some : certificate.screened) {
    screened[std::string(name_of(some.scalar))] = {{"states", some.states},
                                                   {"visited", some.visited}};
  }
  const Json json{{"model", certificate.model},
                  {"scene", certificate.scene},
                  {"seed", certificate.seed},
                  {"screened", screened},
                  {"holds", count(certificate, Verdict::holds)},
                  {"fails", count(certificate, Verdict::fails)},
                  {"skipped", count(certificate, Verdict::skipped)},
                  {"noted", count(certificate, Verdict::noted)},
                  {"checks", checks}};
  return json.dump(2) + "\n";
}

std::string certificate_schema() {
  return schema_text("certificate of elgen verify",
                     object_schema({{"model", text("name of the model")},
                                    {"scene", text("name of the scene, or full")},
                                    {"seed", whole_number("of the random states")},
                                    {"screened", screened_schema()},
                                    {"holds", whole_number("how many checks do")},
                                    {"fails", whole_number()},
                                    {"skipped", whole_number()},
                                    {"noted", whole_number()},
                                    {"checks", list_schema(check_schema())}}));
}

}  // namespace elgen
