// A certificate for programs.
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "elgen/certificate.hpp"

namespace elgen {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 4> verdict_names{"holds", "fails", "skipped", "noted"};
constexpr std::array<std::string_view, 4> obstacle_names{"overflow", "undefined", "ill_conditioned",
                                                         "singular"};
constexpr std::array<std::string_view, 4> evidence_names{"states", "proof", "zeros", "numbers"};

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

}  // namespace

std::string to_json(const Certificate& certificate) {
  Json checks = Json::array();
  for (const CertificateRow& row : certificate.rows) checks.push_back(json_of(row));
  const Json json{{"model", certificate.model},
                  {"scene", certificate.scene},
                  {"seed", certificate.seed},
                  {"holds", count(certificate, Verdict::holds)},
                  {"fails", count(certificate, Verdict::fails)},
                  {"skipped", count(certificate, Verdict::skipped)},
                  {"noted", count(certificate, Verdict::noted)},
                  {"checks", checks}};
  return json.dump(2) + "\n";
}

}  // namespace elgen
