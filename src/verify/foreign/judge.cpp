// compare_foreign_code: compares the answers of foreign code with the oracle, and searches for the
// mistake if they are wrong.
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "elgen/foreign.hpp"
#include "elgen/foreign_code.hpp"
#include "elgen/wording.hpp"
#include "model/requests.hpp"
#include "numbers/exact_number.hpp"
#include "program/evaluate/subject.hpp"
#include "sample/states.hpp"
#include "verify/foreign/conventions.hpp"
#include "verify/foreign/fields.hpp"
#include "verify/foreign/situations.hpp"
#include "verify/states/tally.hpp"

namespace elgen {
namespace {

using cln::cl_R;
using RealNumbers = std::vector<cl_R>;
using States = std::vector<Arguments<double>>;

struct ForeignSample {
  Situation situation;
  State state;
  RealNumbers truth;
  std::vector<double> answer;
};

/// The largest error of an answer, relative to the largest entry of its field.
struct Deviation {
  double error = 0;
  std::size_t answer_index = 0;  ///< index in the answer
  std::size_t field = 0;
  std::size_t entry = 0;  ///< index in the field
};

/// A thousand roundings of float, each 2^-24.
constexpr double float_precision = 6e-5;

/// The entries first, ..., first + size - 1.
RealNumbers slice_of(const RealNumbers& values, std::size_t first, std::size_t size) {
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(size)};
}

/// True if a field may be pure rounding error: terms up to 1e30 cancel to below 1e-30 in 64 digits.
bool may_be_rounding_error(const RealNumbers& largest) {
  return std::ranges::any_of(largest,
                             [](const cl_R& x) { return !cln::zerop(x) && x < power_of_ten(-30); });
}

/// Compares the answers to one claim with the oracle, and explains the differences.
class ForeignComparison {
 public:
  /// `fields`: the fields of the claim. `is_moved`: states are projected onto the constraints.
  ForeignComparison(const SystemUnderTest& subject, const ForeignOptions& options,
                    const OutputRequest& output, ForeignFields fields, bool is_moved)
      : subject_(subject),
        options_(options),
        output_(output),
        fields_(std::move(fields)),
        is_projected_(is_moved) {}

  /// The row of the claim; E716 if the code does not run.
  Result<CertificateRow> compare_claim(const ForeignClaim& claim) {
    states_ = draw_foreign_states(subject_, options_, output_.kind, is_projected_);
    row_.check = "foreign code vs oracle";
    row_.output = output_.name;
    const std::string claimed = claim.output + (claim.field.empty() ? "" : ".") + claim.field;
    row_.subject = claim.name + (claim.name == claimed ? "" : " as " + claimed);
    row_.formula = "|f - f*| / max |f*| in 60 digits";
    row_.tolerance = fmt::format("{:g} of the largest entry", options_.tolerance);
    if (is_projected_) row_.tolerance += ", at states on the constraints";
    if (states_.values.empty()) return unmet_row();
    States called = states_.values;
    const std::vector<std::uint32_t> changed = add_parameter_variations(subject_, called);
    const auto answers = call_foreign_function({options_.code, claim.name, options_.seconds},
                                               subject_.model, output_, called);
    if (!answers) return answers.diagnostics;
    if (!check_answers(*answers, called)) return row_;
    compare_answers(*answers);
    if (row_.verdict != Verdict::fails) return row_;
    add_finding(wrong_situations_text());
    if (tally_.worst() <= float_precision) {
      add_finding(
          fmt::format("agrees at all states to {:.0e}, the precision of float", tally_.worst()));
    } else {
      add_finding(ignored_parameters_text(*answers, called, changed));
      add_finding(common_factor_text());
      add_finding(convention_text());
    }
    return row_;
  }

 private:
  void add_finding(const std::string& finding) {
    if (!finding.empty()) row_.findings.push_back(finding);
  }

  CertificateRow unmet_row() {
    row_.verdict = Verdict::skipped;
    row_.worst_value = "no state was projected onto the constraints";
    row_.skipped = {{SkipReason::off_constraints, states_.unmet}};
    return row_;
  }

  /// The oracle's entries of the compared fields. If a field may be pure rounding error, all
  /// entries are computed with more digits.
  [[nodiscard]] OracleValues oracle_entries_at(const State& state) const {
    OracleValues truth = compared_entries(oracle_values(subject_.model, output_, state));
    if (!truth || !may_be_rounding_error(largest_by_field(*truth))) return truth;
    OracleValues settled = compared_entries(stable_values(subject_.model, output_, state).values);
    return settled ? settled : truth;
  }

  [[nodiscard]] OracleValues compared_entries(const OracleValues& values) const {
    if (!values) return std::nullopt;
    RealNumbers all;
    for (const ForeignField& field : fields_) {
      if (field.first_entry + field.size() > values->size()) return std::nullopt;
      const RealNumbers part = slice_of(*values, field.first_entry, field.size());
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }

  /// The largest |entry| of each field.
  [[nodiscard]] RealNumbers largest_by_field(const RealNumbers& values) const {
    RealNumbers largest;
    std::size_t first = 0;
    for (const ForeignField& field : fields_) {
      largest.push_back(max_magnitude(slice_of(values, first, field.size())));
      first += field.size();
    }
    return largest;
  }

  [[nodiscard]] Deviation largest_deviation(const std::vector<double>& answer,
                                            const RealNumbers& truth) const;

  /// True if the code's answers agree with `expected` at all samples.
  [[nodiscard]] bool agrees_at_all_samples(
      const std::function<OracleValues(const ForeignSample&)>& expected) const {
    return std::ranges::all_of(samples_, [&](const ForeignSample& sample) {
      const OracleValues values = expected(sample);
      return values && largest_deviation(sample.answer, *values).error <= options_.tolerance;
    });
  }

  bool check_answers(const ForeignResults& answers, const States& states);
  void compare_answers(const ForeignResults& answers);

  [[nodiscard]] bool is_wrong(Situation situation) const {
    return is_wrong_[static_cast<std::size_t>(situation)].value_or(false);
  }

  [[nodiscard]] std::string wrong_situations_text() const;
  [[nodiscard]] std::string ignored_parameters_text(
      const ForeignResults& answers, const States& states,
      const std::vector<std::uint32_t>& changed) const;
  [[nodiscard]] std::string common_factor_text() const;
  [[nodiscard]] std::string convention_text() const;

  const SystemUnderTest& subject_;
  const ForeignOptions& options_;
  const OutputRequest& output_;
  ForeignFields fields_;  ///< of the claim; once the code has answered, of the answers
  bool is_projected_;
  ForeignStates states_ = {};
  CertificateRow row_ = {};
  std::vector<ForeignSample> samples_ = {};
  RealNumbers min_scales_ = {};  ///< by field: lower bound of the scale of errors
  Tally tally_ = {};
  std::array<std::optional<bool>, situation_count> is_wrong_ = {};  ///< none: not compared
};

Deviation ForeignComparison::largest_deviation(const std::vector<double>& answer,
                                               const RealNumbers& truth) const {
  const RealNumbers largest = largest_by_field(truth);
  Deviation worst;
  std::size_t place = 0;
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    const cl_R scale = cln::max(largest[k], min_scales_[k]);
    for (std::size_t i = 0; i < fields_[k].size(); ++i, ++place) {
      const double given = answer[place];
      const cl_R difference = cln::abs(exact_value(given) - truth[place]);
      const bool has_relative_error = std::isfinite(given) && !cln::zerop(scale);
      double error = has_relative_error ? to_double(difference / scale)
                                        : std::numeric_limits<double>::infinity();
      if (std::isfinite(given) && cln::zerop(difference)) error = 0;
      if (error > worst.error) worst = {error, place, k, i};
    }
  }
  return worst;
}

/// True if the code gave an answer of the right size for each state and did not fail afterwards.
/// Otherwise the row fails, and names the first state without such an answer.
bool ForeignComparison::check_answers(const ForeignResults& answers, const States& states) {
  const ForeignFields claimed = fields_;
  const std::size_t count = answers.values.empty() ? 0 : answers.values.front().size();
  fields_ = match_answer_fields(claimed, count);
  if (fields_.empty()) fields_ = {claimed.front()};
  const auto other = std::ranges::find_if(
      answers.values, [this](const auto& values) { return values.size() != entry_count(fields_); });
  const auto at = static_cast<std::size_t>(other - answers.values.begin());
  if (at == states.size() && answers.failure.empty()) return true;
  row_.verdict = Verdict::fails;
  if (at < states.size())
    row_.worst_state = describe_state(subject_, exact_state(subject_, states[at]));
  if (other == answers.values.end()) {
    row_.worst_value = fmt::format("{}, after {}", answers.failure, count_text(at, "answer"));
  } else {
    const ForeignField& first = fields_.front();
    const std::string shape = fields_.size() == 1
                                  ? fmt::format("{} x {}", first.rows, first.columns)
                                  : std::to_string(entry_count(fields_));
    row_.worst_value =
        fmt::format("gives {} for {} entries", count_text(other->size(), "number"), shape);
    if (claimed.size() > 1) add_finding("its fields are " + field_sizes_text(claimed));
  }
  if (!answers.error_output.empty()) add_finding("its words" + answers.error_output);
  return false;
}

/// Compares the answers with the oracle. Errors are relative to the largest entry of the field at
/// the state, or to 1e-6 of its largest entry at all states, whichever is larger: terms that cancel
/// exactly leave 1e-16 of the largest term.
void ForeignComparison::compare_answers(const ForeignResults& answers) {
  min_scales_.assign(fields_.size(), 0);
  for (std::size_t i = 0; i < states_.values.size(); ++i) {
    State state = exact_state(subject_, states_.values[i]);
    const OracleValues truth = oracle_entries_at(state);
    if (!truth) {
      tally_.count_skipped();
      continue;
    }
    const RealNumbers largest = largest_by_field(*truth);
    for (std::size_t k = 0; k < largest.size(); ++k) {
      min_scales_[k] = cln::max(min_scales_[k], largest[k] * power_of_ten(-6));
    }
    samples_.push_back({states_.situations[i], std::move(state), *truth, answers.values[i]});
  }
  for (const auto& [situation, state, truth, answer] : samples_) {
    const auto [error, place, field, entry] = largest_deviation(answer, truth);
    std::optional<bool>& is_wrong = is_wrong_[static_cast<std::size_t>(situation)];
    is_wrong = is_wrong.value_or(false) || error > options_.tolerance;
    if (!tally_.add(error, state)) continue;
    row_.worst_value = fmt::format("{} is {:.10g}, the oracle says {:.10g}",
                                   name_of_entry(subject_.model, output_, fields_[field], entry),
                                   answer[place], to_double(truth[place]));
  }
  tally_.write_result(row_, subject_, options_.tolerance);
  if (states_.unmet > 0) row_.skipped.push_back({SkipReason::off_constraints, states_.unmet});
  if (samples_.empty()) {
    row_.worst_value = "the oracle has no value at any state";
  } else if (row_.verdict == Verdict::holds) {
    const std::string where = count_text(samples_.size(), "state");
    row_.worst_value = fmt::format("agrees at {} to {:.1g}", where, tally_.worst());
    if (!fields_.front().row->name.empty()) row_.worst_value += " in " + field_names_text(fields_);
  } else if (std::isfinite(tally_.worst())) {
    row_.worst_value += fmt::format(": {:.1e} of the largest entry", tally_.worst());
  }
}

std::string ForeignComparison::wrong_situations_text() const {
  const std::string_view drive = drive_text(output_);
  const bool moves = is_wrong(Situation::moving);
  const bool drives = is_wrong(Situation::driven);
  if (is_wrong(Situation::rest)) return "wrong even at rest";
  if (!std::ranges::all_of(is_wrong_, &std::optional<bool>::has_value)) return {};
  if (moves && drives) return fmt::format("wrong when moving, and with {}; agrees at rest", drive);
  if (moves) return "wrong only when moving; agrees at rest";
  if (drives) return fmt::format("wrong only with {}; agrees without them", drive);
  if (is_wrong(Situation::general)) return fmt::format("wrong only when moving with {}", drive);
  return "wrong only if parameters are varied; agrees at the parameters of the file";
}

/// Names the parameters that the code ignores. State i after the compared states differs from the
/// first state in parameter changed[i] only.
std::string ForeignComparison::ignored_parameters_text(
    const ForeignResults& answers, const States& states,
    const std::vector<std::uint32_t>& changed) const {
  const OracleValues truth = oracle_entries_at(exact_state(subject_, states.front()));
  if (!truth) return {};
  std::vector<double> before;
  for (const cl_R& value : *truth) before.push_back(to_double(value));
  std::vector<std::string> names;
  for (std::size_t i = 0; i < changed.size(); ++i) {
    const std::size_t other = states_.values.size() + i;
    if (answers.values[other] != answers.values.front()) continue;
    const OracleValues now = oracle_entries_at(exact_state(subject_, states[other]));
    if (!now || largest_deviation(before, *now).error <= options_.tolerance) continue;
    names.push_back(quote_text(subject_.model.parameters[changed[i]].name));
  }
  return names.empty() ? "" : fmt::format("ignores {}", fmt::join(names, ", "));
}

/// The common factor of the foreign answers, in words: "is 2 times the oracle's value". "" if no
/// factor fits all entries and states. A factor suggests a different unit, sign or inertia.
std::string ForeignComparison::common_factor_text() const {
  const ForeignSample& first = samples_.front();
  const auto largest = std::ranges::max_element(first.truth, std::ranges::less(),
                                                [](const cl_R& x) { return cln::abs(x); });
  if (cln::zerop(*largest)) return {};
  const auto entry = static_cast<std::size_t>(largest - first.truth.begin());
  const cl_R quotient = exact_value(first.answer[entry]) / *largest;
  const auto scaled = [&](const ForeignSample& sample) {
    RealNumbers values = sample.truth;
    for (cl_R& value : values) value = value * quotient;
    return OracleValues(std::move(values));
  };
  if (cln::zerop(quotient) || !agrees_at_all_samples(scaled)) return {};
  return fmt::format("is {:.6g} times the oracle's value at all states", to_double(quotient));
}

std::string ForeignComparison::convention_text() const {
  for (const Convention& convention : candidate_conventions(subject_.model)) {
    const auto expected = [&](const ForeignSample& sample) {
      const OracleValues ours = oracle_entries_at(to_our_state(convention, sample.state));
      if (!ours) return ours;
      RealNumbers theirs;
      for (const ForeignField& field : fields_) {
        const RealNumbers part = slice_of(*ours, theirs.size(), field.size());
        const RealNumbers changed =
            to_their_values(subject_.model, convention, output_, field, part);
        theirs.insert(theirs.end(), changed.begin(), changed.end());
      }
      return OracleValues(std::move(theirs));
    };
    if (agrees_at_all_samples(expected))
      return "agrees at all states under another convention: " + convention.name;
  }
  return {};
}

LeafNames leaves_for(const Model& model, const std::vector<OutputRequest>& outputs) {
  LeafNames leaves = leaf_names(model);
  for (const OutputRequest& output : outputs) name_optional_leaves(output.argument_kinds, leaves);
  return leaves;
}

/// E717 with `row.worst_value`: the largest error or, if no state was compared, the faulty answer.
Diagnostic disagreement_error(const Model& model, const CertificateRow& row) {
  const std::string name = quote_text(row.subject);
  const std::string found = fmt::format("{}", fmt::join(row.findings, "; "));
  if (row.samples > 0) return {Code::E717, model.name_span, name + ": " + row.worst_value, found};
  return {Code::E717, {}, name + " " + row.worst_value + (found.empty() ? "" : "; " + found)};
}

/// The row of one claim. Code that fails at states on the constraints is also compared at other
/// states, because an output such as x^2 + y^2 - l^2 is pure rounding error on the constraints.
Result<CertificateRow> claim_row(const SystemUnderTest& subject, const ForeignOptions& options,
                                 const ForeignFields& fields, const ForeignClaim& claim) {
  const OutputRequest& output = *find_request(subject.scene, claim.output);
  const bool is_moved = is_compared_on_constraints(subject.model, output.kind);
  Result<CertificateRow> row =
      ForeignComparison(subject, options, output, fields, is_moved).compare_claim(claim);
  const bool is_wrong = row && row->verdict == Verdict::fails && row->samples > 0;
  if (!is_moved || !is_wrong) return row;
  Result<CertificateRow> off =
      ForeignComparison(subject, options, output, fields, false).compare_claim(claim);
  return off && off->verdict == Verdict::holds ? off : row;
}

}  // namespace

Result<Verification> compare_foreign_code(const CheckedModel& checked,
                                          const ForeignOptions& options) {
  const auto& [model, scene] = checked;
  Program program;
  program.leaves = leaves_for(model, scene.outputs);
  const SystemUnderTest subject{model, scene, program};
  Verification result;
  result.certificate = {model.name, scene.name.empty() ? "full" : scene.name, options.seed, {}};
  for (const ForeignClaim& claim : options.claims) {
    const Result<ForeignFields> fields = claimed_fields(checked, claim);
    if (!fields) return fields.diagnostics;
    Result<CertificateRow> row = claim_row(subject, options, *fields, claim);
    if (!row) return row.diagnostics;
    if (row->verdict == Verdict::fails)
      result.diagnostics.push_back(disagreement_error(model, *row));
    result.certificate.rows.push_back(std::move(*row));
  }
  return result;
}

}  // namespace elgen
