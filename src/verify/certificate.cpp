// Writes certificates as JSON and as text:
//
//     certificate of cart_pole, scene full, seed 1
//
//       holds    mass_matrix        9 checks, at 276 states, at most 0.4 digits lost
//       FAILS    gravity            1 of 8 checks
//                program vs oracle: gravity (double)
//                worst      entry 1 is 2, the oracle says 1
//                …
//
//     41 checks hold, 1 fails, 2 skipped
#include "elgen/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "base/json.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

using Rows = std::vector<const CertificateRow*>;
using OutputRows = std::pair<std::string, Rows>;

constexpr std::array<std::string_view, 4> verdict_words{"holds", "FAILS", "skipped", "noted"};
constexpr std::array<std::string_view, 5> obstacle_words{"overflow", "outside the domain",
                                                         "singular", "undecided by the oracle",
                                                         "not projected onto the constraints"};

constexpr std::array<std::string_view, 4> verdict_names{"holds", "fails", "skipped", "noted"};
constexpr std::array<std::string_view, 5> obstacle_names{"overflow", "undefined", "singular",
                                                         "unsettled", "unmet"};
constexpr std::array<std::string_view, 4> evidence_names{"states", "proof", "zeros", "numbers"};

template <class Enum, std::size_t size>
std::string_view word(const std::array<std::string_view, size>& words, Enum value) {
  return words[static_cast<std::size_t>(value)];
}

/// The number of skipped states by obstacle: "41 outside the domain, 1 overflow".
std::string skipped_text(const CertificateRow& row) {
  std::string text;
  for (const SkippedStates& some : row.skipped) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", some.states,
                        word(obstacle_words, some.reason));
  }
  return text;
}

/// Why the row is skipped: the obstacles at its states, or "<Eigen/Core> is not installed" if the
/// check did not run.
std::string skip_reason(const CertificateRow& row) {
  return row.skipped.empty() ? row.worst_value : skipped_text(row);
}

void append_detail(std::string& text, std::string_view label, const std::string& value) {
  if (!value.empty()) text += fmt::format("           {:<10} {}\n", label, value);
}

std::string evidence_text(const CertificateRow& row) {
  switch (row.evidence) {
    case Evidence::proof:
      return "for every state, by proof";
    case Evidence::zeros:
      return "at " + count_text(row.samples, "random point");
    case Evidence::numbers:
      return "of " + count_text(row.samples, "number");
    case Evidence::states:
      break;
  }
  return "at " + count_text(row.samples, "state");
}

void append_details(std::string& text, const CertificateRow& row) {
  append_detail(text, "formula", row.formula);
  append_detail(text, "decided", evidence_text(row));
  append_detail(text, "skipped", skipped_text(row));
  append_detail(text, "worst at", row.worst_state);
  append_detail(text, "tolerance", row.tolerance);
  for (const std::string& finding : row.findings) append_detail(text, "found", finding);
}

std::size_t count_of(const Rows& rows, Verdict verdict) {
  return static_cast<std::size_t>(std::ranges::count(rows, verdict, &CertificateRow::verdict));
}

Verdict verdict_of(const Rows& rows) {
  for (const Verdict verdict : {Verdict::fails, Verdict::holds, Verdict::noted}) {
    if (count_of(rows, verdict) > 0) return verdict;
  }
  return Verdict::skipped;
}

/// Rows grouped by output, in the order in which outputs first occur.
std::vector<OutputRows> group_by_output(const Certificate& certificate) {
  std::vector<OutputRows> groups;
  for (const CertificateRow& row : certificate.rows) {
    auto known = std::ranges::find(groups, row.output, &OutputRows::first);
    if (known == groups.end()) known = groups.insert(known, {row.output, {}});
    known->second.push_back(&row);
  }
  return groups;
}

bool has_evidence(const Rows& rows, Evidence evidence) {
  return std::ranges::count(rows, evidence, &CertificateRow::evidence) > 0;
}

/// The smallest number of compared states in a row that holds. If `with_loss`, only rows with a
/// loss count, otherwise only rows without a loss.
std::optional<std::size_t> fewest_states(const Rows& rows, bool with_loss) {
  std::optional<std::size_t> fewest;
  for (const CertificateRow* row : rows) {
    const bool counts = row->evidence == Evidence::states && row->verdict == Verdict::holds;
    if (!counts || row->loss.has_value() != with_loss) continue;
    fewest = std::min(fewest.value_or(row->samples), row->samples);
  }
  return fewest;
}

/// ", 1 of 3 equations stated" for a row with an incomplete set of equations; else "".
std::string stated_text(const CertificateRow& row) {
  if (!row.stated) return "";
  return fmt::format(", {} of {} stated", row.stated->stated,
                     count_text(row.stated->needed, "equation"));
}

/// The largest `skipped_in_ranges` of all rows.
std::size_t max_skipped_in_ranges(const Rows& rows) {
  std::size_t most = 0;
  for (const CertificateRow* row : rows) most = std::max(most, row->skipped_in_ranges);
  return most;
}

/// "9 checks, at 276 states, at most 0.4 digits lost", "4 checks, proved"
std::string summary(const Rows& rows) {
  const std::size_t failed = count_of(rows, Verdict::fails);
  if (failed > 0) return fmt::format("{} of {}", failed, count_text(rows.size(), "check"));
  std::string text = count_text(rows.size(), "check");
  if (has_evidence(rows, Evidence::numbers)) return text + ", exact";
  if (!has_evidence(rows, Evidence::states)) return text + ", proved";
  std::optional<double> loss;
  for (const CertificateRow* row : rows) {
    if (row->loss) loss = std::max(loss.value_or(1), *row->loss);
  }
  const auto states = fewest_states(rows, loss.has_value());
  if (states) text += ", at " + count_text(*states, "state");
  const std::size_t skipped = max_skipped_in_ranges(rows);
  if (skipped > 0) text += fmt::format(", {} inside the ranges skipped", skipped);
  if (loss) text += ", " + lost_digits_text(std::log10(*loss));
  if (has_evidence(rows, Evidence::proof)) text += ", some proved";
  if (has_evidence(rows, Evidence::zeros)) text += ", relies on unproved zeros";
  for (const CertificateRow* row : rows) text += stated_text(*row);
  return text;
}

void append_output(std::string& text, const std::string& name, const Rows& rows,
                   std::size_t width) {
  const Verdict verdict = verdict_of(rows);
  text +=
      fmt::format("  {:<8} {:<{}}  {}\n", word(verdict_words, verdict), name, width, summary(rows));
  for (const CertificateRow* row : rows) {
    if (row->verdict == Verdict::holds) continue;
    const bool fails = row->verdict == Verdict::fails;
    const bool is_skipped = row->verdict == Verdict::skipped;
    const std::string prefix = fails ? "" : fmt::format("{}: ", word(verdict_words, row->verdict));
    text += fmt::format("           {}{}, {}\n", prefix, row->check, row->subject);
    append_detail(text, is_skipped ? "because" : "worst",
                  is_skipped ? skip_reason(*row) : row->worst_value);
    if (fails) append_details(text, *row);
    if (row->verdict == Verdict::noted) append_detail(text, "worst at", row->worst_state);
  }
}

std::string heading(const Certificate& certificate) {
  return fmt::format("certificate of {}, scene {}, seed {}\n\n", certificate.model,
                     certificate.scene, certificate.seed);
}

std::string counts_text(const Certificate& certificate) {
  const std::size_t held = count_rows(certificate, Verdict::holds);
  const std::size_t failed = count_rows(certificate, Verdict::fails);
  const std::size_t noted = count_rows(certificate, Verdict::noted);
  std::string text = fmt::format("{} hold{}, {} fail{}, {} skipped{}", count_text(held, "check"),
                                 held == 1 ? "s" : "", failed, failed == 1 ? "s" : "",
                                 count_rows(certificate, Verdict::skipped),
                                 noted > 0 ? fmt::format(", {} noted", noted) : "");
  for (const CertificateRow& row : certificate.rows) text += stated_text(row);
  return text;
}

Json json_of(const CertificateRow& row) {
  Json skipped = Json::object();
  for (const SkippedStates& some : row.skipped) {
    skipped[std::string(word(obstacle_names, some.reason))] = some.states;
  }
  Json json{{"check", row.check},     {"output", row.output},
            {"subject", row.subject}, {"verdict", word(verdict_names, row.verdict)},
            {"formula", row.formula}, {"evidence", word(evidence_names, row.evidence)},
            {"samples", row.samples}, {"skipped_states", skipped}};
  if (row.loss) json["loss"] = *row.loss;
  if (row.loss_of_field) json["loss_of_field"] = *row.loss_of_field;
  json["worst"] = row.worst_value;
  json["worst_at"] = row.worst_state;
  json["tolerance"] = row.tolerance;
  if (!row.findings.empty()) json["findings"] = row.findings;
  if (row.stated)
    json["equations"] = {{"stated", row.stated->stated}, {"needed", row.stated->needed}};
  return json;
}

}  // namespace

std::size_t count_rows(const Certificate& certificate, Verdict verdict) {
  return static_cast<std::size_t>(
      std::ranges::count(certificate.rows, verdict, &CertificateRow::verdict));
}

bool holds(const Certificate& certificate) { return count_rows(certificate, Verdict::fails) == 0; }

std::string lost_digits_text(double digits) {
  return digits < 0.05 ? "no digit lost" : fmt::format("at most {:.1f} digits lost", digits);
}

std::string verdict_line(const Certificate& certificate) {
  const bool is_full = certificate.scene == "full";
  return certificate.model + (is_full ? "" : ", scene " + certificate.scene) + ": " +
         counts_text(certificate) + "\n";
}

std::string to_text(const Certificate& certificate) {
  const auto groups = group_by_output(certificate);
  std::size_t width = 0;
  for (const auto& [name, rows] : groups) width = std::max(width, name.size());
  std::string text = heading(certificate);
  for (const auto& [name, rows] : groups) append_output(text, name, rows, width);
  return text + "\n" + counts_text(certificate) + "\n";
}

std::string to_full_text(const Certificate& certificate, bool verdict_first) {
  std::size_t width = 0;
  for (const CertificateRow& row : certificate.rows) width = std::max(width, row.subject.size());
  std::string text = verdict_first ? verdict_line(certificate) + "\n" : heading(certificate);
  std::string_view check;
  for (const CertificateRow& row : certificate.rows) {
    if (row.check != check) text += fmt::format("{}{}\n", check.empty() ? "" : "\n", row.check);
    check = row.check;
    text += fmt::format("  {:<8} {:<{}}  {}\n", word(verdict_words, row.verdict), row.subject,
                        width, row.worst_value);
    append_details(text, row);
  }
  return verdict_first ? text : text + "\n" + counts_text(certificate) + "\n";
}

std::string to_json(const Certificate& certificate) {
  Json checks = Json::array();
  for (const CertificateRow& row : certificate.rows) checks.push_back(json_of(row));
  const Json json{{"model", certificate.model},
                  {"scene", certificate.scene},
                  {"seed", certificate.seed},
                  {"holds", count_rows(certificate, Verdict::holds)},
                  {"fails", count_rows(certificate, Verdict::fails)},
                  {"skipped", count_rows(certificate, Verdict::skipped)},
                  {"noted", count_rows(certificate, Verdict::noted)},
                  {"checks", checks}};
  return json.dump(2) + "\n";
}

}  // namespace elgen
