// judge_foreign: states in five situations, so that the states at which code is wrong say what is.
#include <fmt/format.h>
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
#include "verify/states/tally.hpp"

namespace elgen {
namespace {

using cln::cl_R;
using Numbers = std::vector<cl_R>;
using States = std::vector<Arguments<double>>;

/// States take turns in them; `driven`: with inputs and accelerations, but without rates.
enum class Situation : std::uint8_t { whole, rest, driven, moving, varied };
constexpr std::size_t situations = 5;

struct ForeignSample {
  Situation situation;
  State state;
  Numbers truth;
  std::vector<double> answer;
};

/// The entry of an answer that is farthest off, in parts of the largest entry.
struct Deviation {
  double error = 0;
  std::size_t entry = 0;
};

/// A thousand roundings of 2^-24.
constexpr double digits_of_float = 6e-5;

States states_of(const Subject& subject, const ForeignOptions& options) {
  Sampler draw(options.seed);
  const LeafValues<Range> ranges = ranges_of(subject);
  States states;
  for (std::size_t i = 0; i < options.states; ++i) {
    const auto situation = static_cast<Situation>(i % situations);
    Arguments<double>& state = states.emplace_back(drawn_within(subject, ranges, draw));
    const bool is_at_rest = situation == Situation::rest;
    if (is_at_rest || situation == Situation::driven) {
      for (auto* const rates : {&state.v, &state.momenta}) std::ranges::fill(*rates, 0.0);
    }
    if (is_at_rest || situation == Situation::moving) {
      for (auto* const drive : {&state.a, &state.u}) std::ranges::fill(*drive, 0.0);
    }
    if (situation != Situation::varied) continue;
    constexpr std::size_t half_to_twice = 2;  // a turn in which parameters are that
    const State drawn = drawn_state(subject.model, subject.scene, draw, half_to_twice);
    state.parameters = arguments_at<double>(drawn).parameters;
  }
  return states;
}

double with_other_value(const Model& model, std::uint32_t parameter, double value) {
  const auto range = declared_range(model, Opcode::parameter, parameter);
  const double larger = value == 0 ? 1 : value * 1.25;
  return range && range->high < exact_value(larger) ? value * 0.75 : larger;
}

/// "forward_dynamics.acceleration[theta]"
std::string name_of_entry(const Model& model, const OutputRequest& output, std::size_t entry) {
  const FieldRow& field = output_row(output.kind).fields.front();
  const std::size_t columns = output.columns;
  std::string name = output.name + (field.name.empty() ? "" : ".") + std::string(field.name);
  if (output.rows * columns == 1) return name;
  name += "[" + line_labels(model, {field.rows, output.user, output.rows})[entry / columns].text();
  if (columns > 1) {
    name +=
        ", " +
        line_labels(model, {field.columns, output.user, output.columns})[entry % columns].text();
  }
  return name + "]";
}

/// "inputs", "accelerations": what an output takes of both.
std::string_view drive_of(const OutputRequest& output) {
  const LeafSet takes = output.takes;
  if (!takes.has_any(Opcode::acceleration)) return "inputs";
  return takes.has_any(Opcode::input) ? "inputs or accelerations" : "accelerations";
}

/// The row of one claim. Answers are compared with the oracle, then explained.
class ForeignJudge {
 public:
  ForeignJudge(const Subject& subject, const ForeignOptions& options, const OutputRequest& output)
      : subject_(subject), options_(options), output_(output) {}

  /// E716.
  Result<CertificateRow> judge(const ForeignClaim& claim) {
    States states = states_of(subject_, options_);
    std::vector<std::uint32_t> changed;
    for (std::uint32_t i = 0; i < subject_.model.parameters.size(); ++i) {
      if (subject_.scene.specialisation.fixed.count(i) > 0) continue;
      changed.push_back(i);
      double& value = states.emplace_back(states.front()).parameters[i];
      value = with_other_value(subject_.model, i, value);
    }
    const auto answers = call_foreign({options_.code, claim.name, options_.seconds}, subject_.model,
                                      output_, states);
    if (!answers) return answers.diagnostics;
    row_.check = "foreign code vs oracle";
    row_.output = output_.name;
    row_.subject = claim.name + (claim.name == output_.name ? "" : " as " + output_.name);
    row_.formula = "|f - f*| / max |f*| in 64 digits";
    row_.tolerance = fmt::format("{:g} of the largest entry", options_.tolerance);
    if (!all_answered(*answers, states)) return row_;
    compare(*answers, states);
    if (row_.verdict != Verdict::fails) return row_;
    find(when());
    if (tally_.worst() <= digits_of_float) {
      find(fmt::format("agrees at all states to {:.0e}, the digits of float", tally_.worst()));
    } else {
      find(ignored(*answers, states, changed));
      find(factor());
      find(convention());
    }
    return row_;
  }

 private:
  void find(const std::string& finding) {
    if (!finding.empty()) row_.findings.push_back(finding);
  }

  [[nodiscard]] OracleValues truth_at(const State& state) const {
    OracleValues values = oracle_values(subject_.model, output_, state);
    if (values) values->resize(std::size_t{output_.rows} * output_.columns);
    return values;
  }

  [[nodiscard]] Deviation deviation(const std::vector<double>& answer, const Numbers& truth) const {
    const cl_R scale = cln::max(largest_of(truth), least_);
    Deviation worst;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const cl_R difference = cln::abs(exact_value(answer[i]) - truth[i]);
      const bool is_told = std::isfinite(answer[i]) && !cln::zerop(scale);
      double error = is_told ? ScalarTraits<double>::from_real(difference / scale)
                             : std::numeric_limits<double>::infinity();
      if (std::isfinite(answer[i]) && cln::zerop(difference)) error = 0;
      if (error > worst.error) worst = {error, i};
    }
    return worst;
  }

  /// Whether these values are what code gives at all states.
  [[nodiscard]] bool agrees(
      const std::function<OracleValues(const ForeignSample&)>& expected) const {
    return std::ranges::all_of(samples_, [&](const ForeignSample& sample) {
      const OracleValues values = expected(sample);
      return values && deviation(sample.answer, *values).error <= options_.tolerance;
    });
  }

  /// Otherwise the row says why, and the first state without an answer. Code that fails behind its
  /// last answer has none either: nobody knows what it wrote.
  bool all_answered(const ForeignAnswers& answers, const States& states) {
    const std::size_t entries = std::size_t{output_.rows} * output_.columns;
    const auto other = std::ranges::find_if(
        answers.values, [entries](const auto& values) { return values.size() != entries; });
    const auto at = static_cast<std::size_t>(other - answers.values.begin());
    if (at == states.size() && answers.failure.empty()) return true;
    row_.verdict = Verdict::fails;
    if (at < states.size()) row_.where = describe(subject_, exact_state(subject_, states[at]));
    row_.worst = other == answers.values.end()
                     ? fmt::format("{}, after {}", answers.failure, counted(at, "answer"))
                     : fmt::format("gives {} for {} x {} entries", counted(other->size(), "number"),
                                   output_.rows, output_.columns);
    if (!answers.said.empty()) find("its words" + answers.said);
    return false;
  }

  void compare(const ForeignAnswers& answers, const States& states);

  [[nodiscard]] bool is_wrong(Situation situation) const {
    return wrong_[static_cast<std::size_t>(situation)].value_or(false);
  }

  [[nodiscard]] std::string when() const {
    const std::string_view drive = drive_of(output_);
    const bool moves = is_wrong(Situation::moving);
    const bool drives = is_wrong(Situation::driven);
    if (is_wrong(Situation::rest)) return "at rest already";
    if (!std::ranges::all_of(wrong_, &std::optional<bool>::has_value)) return {};
    if (moves && drives) return fmt::format("when moving, and with {}; agrees at rest", drive);
    if (moves) return "only when moving: agrees at rest";
    if (drives) return fmt::format("only with {}: agrees without", drive);
    if (is_wrong(Situation::whole)) return fmt::format("only when moving with {}", drive);
    return "only where parameters are varied: agrees at those of the file";
  }

  [[nodiscard]] std::string ignored(const ForeignAnswers& answers, const States& states,
                                    const std::vector<std::uint32_t>& changed) const;
  [[nodiscard]] std::string factor() const;
  [[nodiscard]] std::string convention() const;

  const Subject& subject_;
  const ForeignOptions& options_;
  const OutputRequest& output_;
  CertificateRow row_ = {};
  std::vector<ForeignSample> samples_ = {};
  cl_R least_ = 0;
  Tally tally_ = {};
  std::array<std::optional<bool>, situations> wrong_ = {};  ///< none: nothing compared there
};

/// Where all entries of a state are smaller than 1e-6 of the largest at all states, they are held
/// to that: terms that cancel on paper leave 1e-16 of it.
void ForeignJudge::compare(const ForeignAnswers& answers, const States& states) {
  for (std::size_t i = 0; i < options_.states; ++i) {
    State state = exact_state(subject_, states[i]);
    const OracleValues truth = truth_at(state);
    if (!truth) {
      tally_.skip();
      continue;
    }
    least_ = cln::max(least_, largest_of(*truth) * power_of_ten(-6));
    const auto situation = static_cast<Situation>(i % situations);
    samples_.push_back({situation, std::move(state), *truth, answers.values[i]});
  }
  for (const auto& [situation, state, truth, answer] : samples_) {
    const auto [error, entry] = deviation(answer, truth);
    std::optional<bool>& is_wrong = wrong_[static_cast<std::size_t>(situation)];
    is_wrong = is_wrong.value_or(false) || error > options_.tolerance;
    if (!tally_.add(error, state)) continue;
    row_.worst = fmt::format("{} is {:.10g}, the oracle says {:.10g}",
                             name_of_entry(subject_.model, output_, entry), answer[entry],
                             ScalarTraits<double>::from_real(truth[entry]));
  }
  tally_.tell(row_, subject_, options_.tolerance);
  if (samples_.empty()) {
    row_.worst = "the oracle has no value at any of the states";
  } else if (row_.verdict == Verdict::holds) {
    const std::string where = counted(samples_.size(), "state");
    row_.worst = fmt::format("agrees at {} to {:.1g}", where, tally_.worst());
  } else if (std::isfinite(tally_.worst())) {
    row_.worst += fmt::format(": {:.1e} of the largest entry", tally_.worst());
  }
}

/// `changed` are the parameters that the states behind those that are compared change, one each, in
/// the first of them.
std::string ForeignJudge::ignored(const ForeignAnswers& answers, const States& states,
                                  const std::vector<std::uint32_t>& changed) const {
  const OracleValues truth = truth_at(exact_state(subject_, states.front()));
  if (!truth) return {};
  std::vector<double> before;
  for (const cl_R& value : *truth) before.push_back(ScalarTraits<double>::from_real(value));
  std::vector<std::string> names;
  for (std::size_t i = 0; i < changed.size(); ++i) {
    if (answers.values[options_.states + i] != answers.values.front()) continue;
    const OracleValues now = truth_at(exact_state(subject_, states[options_.states + i]));
    if (!now || deviation(before, *now).error <= options_.tolerance) continue;
    names.push_back(in_backticks(subject_.model.parameters[changed[i]].name));
  }
  return names.empty() ? "" : fmt::format("ignores {}", fmt::join(names, ", "));
}

/// The same quotient of all entries at all states: another unit, sign, length or inertia.
std::string ForeignJudge::factor() const {
  const ForeignSample& first = samples_.front();
  const auto largest = std::ranges::max_element(first.truth, std::ranges::less(),
                                                [](const cl_R& x) { return cln::abs(x); });
  if (cln::zerop(*largest)) return {};
  const auto entry = static_cast<std::size_t>(largest - first.truth.begin());
  const cl_R quotient = exact_value(first.answer[entry]) / *largest;
  const auto scaled = [&](const ForeignSample& sample) {
    Numbers values = sample.truth;
    for (cl_R& value : values) value = value * quotient;
    return OracleValues(std::move(values));
  };
  if (cln::zerop(quotient) || !agrees(scaled)) return {};
  return fmt::format("is {:.6g} times the oracle's at all states",
                     ScalarTraits<double>::from_real(quotient));
}

std::string ForeignJudge::convention() const {
  for (const Convention& convention : conventions(subject_.model)) {
    const auto expected = [&](const ForeignSample& sample) {
      OracleValues values = truth_at(our_state(convention, sample.state));
      if (values) values = their_values(convention, output_, *values);
      return values;
    };
    if (agrees(expected))
      return "agrees at all states under another convention: " + convention.name;
  }
  return {};
}

LeafNames leaves_for(const Model& model, const std::vector<OutputRequest>& outputs) {
  LeafNames leaves = leaf_names(model);
  for (const OutputRequest& output : outputs) {
    const LeafSet takes = output.takes;
    if (takes.has_any(Opcode::momentum)) leaves.momenta = leaves.v;
    if (takes.has_any(Opcode::reference)) leaves.reference = leaves.v;
    if (takes.has_any(Opcode::step)) leaves.h = leaf_row(Opcode::step).symbol;
  }
  return leaves;
}

/// If nothing could be compared, the findings are about the answers.
Diagnostic disagreement(const Model& model, const CertificateRow& row) {
  const std::string name = in_backticks(row.subject);
  const std::string found = fmt::format("{}", fmt::join(row.findings, "; "));
  if (row.samples > 0) return {Code::E717, model.name_span, name + ": " + row.worst, found};
  return {Code::E717, {}, name + " " + row.worst + (found.empty() ? "" : "; " + found)};
}

}  // namespace

Result<Verification> judge_foreign(const CheckedModel& checked, const ForeignOptions& options) {
  const auto& [model, scene] = checked;
  Program program;
  program.leaves = leaves_for(model, scene.outputs);
  const Subject subject{model, scene, program};
  Verification result;
  result.certificate = {model.name, scene.name.empty() ? "full" : scene.name, options.seed, {}};
  for (const ForeignClaim& claim : options.claims) {
    const OutputRequest* const output = find_request(scene, claim.output);
    const std::string name = in_backticks(claim.output);
    if (output == nullptr) return Diagnostic{Code::E601, {}, name + " is not one output"};
    if (output_row(output->kind).repeats) {
      return Diagnostic{Code::E603, {}, name + " repeats other outputs", "name one of these"};
    }
    Result<CertificateRow> row = ForeignJudge(subject, options, *output).judge(claim);
    if (!row) return row.diagnostics;
    if (row->verdict == Verdict::fails) result.diagnostics.push_back(disagreement(model, *row));
    result.certificate.rows.push_back(std::move(*row));
  }
  return result;
}

}  // namespace elgen
