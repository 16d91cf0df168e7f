// Proves expectations if possible. Otherwise compares them to 45 digits at 64 random points, and at
// more points if the 64 lie on one side of a kink only. The row of a compared expectation says
// "sampled", because a comparison is no proof.
#include "verify/structure/expectations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "elgen/leaf_names.hpp"
#include "model/requests.hpp"
#include "numbers/exact_number.hpp"
#include "sample/states.hpp"
#include "verify/states/kinks.hpp"
#include "verify/states/tally.hpp"
#include "verify/structure/differing_terms.hpp"
#include "verify/structure/proofs.hpp"
#include "verify/structure/stated.hpp"

namespace elgen {
namespace {

using cln::cl_R;

constexpr std::size_t point_count = 64;
/// The oracle has 60 digits; in each form cancellation may cost 15.
constexpr double tolerance = 1e-45;
constexpr const char* sampled_reason = "1e-45 of the largest entry: sampled, no proof";
constexpr const char* proof_reason = "proved: both have the same canonical sum";
constexpr const char* rate_proof_reason = "proved: the rate is the empty canonical sum";
constexpr const char* equation_proof_reason =
    "proved: along the motion it is the empty canonical sum";
/// With the file's parameter values, a form either holds at all states or fails at most of them, so
/// few states suffice.
constexpr std::size_t states_of_values = 16;

double relative_difference(const cl_R& difference, const cl_R& scale) {
  if (cln::zerop(difference)) return 0;
  return to_double(cln::abs(difference) / scale);
}

const std::string& name_in_file(const Expectation& expectation) {
  return expectation.field.empty() ? expectation.output : expectation.field;
}

std::string expected_formula(const ExpectedEntry& entry) {
  const std::string text = to_string(entry.subject.model, entry.expression());
  if (entry.expectation.claims_conservation()) return fmt::format("d/dt ({}) = 0 at u = 0", text);
  if (entry.expectation.claims_equations()) return fmt::format("{} = 0 along the motion", text);
  return text;
}

/// The row of an entry that closed forms prove; none for other entries. If the equations are
/// `incomplete`, the row says whether the entry is a row of the equations of motion.
std::optional<CertificateRow> proved_row(const ExpectedEntry& entry, ExpectationProver& proofs,
                                         bool incomplete) {
  const auto written =
      incomplete ? proofs.written_form(entry.expectation, entry.index) : std::nullopt;
  const std::string matched = written ? matching_row(proofs, *written) : "";
  if (matched.empty() && !proofs.is_proved(entry.expectation, entry.index)) return std::nullopt;
  CertificateRow row = unjudged_row(entry);
  row.worst_value = !matched.empty() ? matched
                    : incomplete     ? "follows from the equations of motion"
                                     : "equal";
  row.evidence = Evidence::proof;
  row.tolerance = entry.expectation.claims_conservation() ? rate_proof_reason
                  : entry.expectation.claims_equations()  ? equation_proof_reason
                                                          : proof_reason;
  return row;
}

/// The value of the written form and the derived value at a state, and the scale of their
/// difference.
struct ComparedValue {
  cl_R written;
  cl_R derived;
  cl_R scale;
};

std::string mistake_text(const ExpectedEntry& entry, const ComparedValue& sample,
                         const State& state) {
  const std::string where = describe_state(entry.subject, state);
  const std::string written = short_number_text(sample.written);
  if (entry.expectation.claims_conservation())
    return fmt::format("its rate is {} instead of 0 at {}", written, where);
  if (entry.expectation.claims_equations())
    return fmt::format("left - right is {} instead of 0 along the motion at {}", written, where);
  return fmt::format("{} is {} by this form, {} as derived, {} too much, at {}", name_of(entry),
                     written, short_number_text(sample.derived),
                     short_number_text(sample.written - sample.derived), where);
}

Diagnostic no_common_value_error(const ExpectedEntry& entry) {
  return {Code::E510, entry.span(),
          fmt::format("this form of {} and the derived one have no value in common at {} points",
                      name_of(entry), point_count),
          "declare a `range` inside the domain"};
}

/// A state and the oracle's values of the output; for rates and equations only the state.
struct SampledPoint {
  State state;
  OracleValues entries = {};
  cl_R scale = 0;  ///< the largest entry of the output and of M; errors are relative to it
};

SampledPoint oracle_point_at(const Model& model, const OutputRequest& request, const State& state) {
  SampledPoint derived{state, oracle_values(model, request, state)};
  const OracleValues masses = oracle_values(model, {.kind = OutputKind::mass_matrix}, state);
  if (derived.entries) derived.scale = max_magnitude(*derived.entries);
  if (masses) derived.scale = cln::max(derived.scale, max_magnitude(*masses));
  return derived;
}

std::optional<ComparedValue> value_sample(const ExpectedEntry& entry, const SampledPoint& derived) {
  const auto written =
      oracle_expression_value(entry.subject.model, entry.expression(), derived.state);
  const std::size_t index = entry.expectation.first + entry.index;
  const bool is_there = derived.entries && index < derived.entries->size();
  if (!written || !is_there) return std::nullopt;
  return ComparedValue{*written, (*derived.entries)[index],
                       cln::max(derived.scale, cln::abs(*written))};
}

/// motion_at() with zero inputs, and with the momenta and the energy of the resulting state.
std::optional<State> free_motion(const Model& model, State start) {
  for (cl_R& u : start.u) u = 0;
  std::optional<State> state = motion_at(model, start);
  if (!state) return std::nullopt;
  const OracleValues momenta = oracle_values(model, {.kind = OutputKind::momentum}, *state);
  const OracleValues energy = oracle_values(model, {.kind = OutputKind::energy_function}, *state);
  if (!momenta || !energy) return std::nullopt;
  state->momenta = *momenta;
  state->E = energy->front();
  return state;
}

/// The value f(x) at the accelerations and multipliers x of the motion, in the result's `written`.
/// Its scale is `size` + |f(0)| + sum over i of |f(sizes_i e_i) - f(0)|, e_i the unit vectors. x
/// has no multipliers if `sizes` has none.
template <class F>
std::optional<ComparedValue> motion_function_sample(const F& f, const State& motion,
                                                    const cl_R& size, const State& sizes) {
  State part = motion;
  part.a.assign(motion.a.size(), cl_R(0));
  part.multipliers.assign(motion.multipliers.size(), cl_R(0));
  const std::optional<cl_R> whole = f(motion);
  const std::optional<cl_R> coasting = f(part);
  if (!whole || !coasting) return std::nullopt;
  ComparedValue result{*whole, 0, size + cln::abs(*coasting)};
  for (std::vector<cl_R> State::*const unknowns : {&State::a, &State::multipliers}) {
    for (std::size_t i = 0; i < (sizes.*unknowns).size(); ++i) {
      (part.*unknowns)[i] = (sizes.*unknowns)[i];
      const std::optional<cl_R> changed = f(part);
      (part.*unknowns)[i] = 0;
      if (!changed) return std::nullopt;
      result.scale = result.scale + cln::abs(*changed - *coasting);
    }
  }
  return result;
}

/// Conserved quantity e: de/dt along the motion, with the scale |e| plus the terms of de/dt.
/// Equation e: its value along the motion, with the scale of its terms.
std::optional<ComparedValue> motion_sample(const ExpectedEntry& entry, const State& motion) {
  const Model& model = entry.subject.model;
  const ExpressionId id = entry.expression();
  const auto value = [&](const State& at) { return oracle_expression_value(model, id, at); };
  State sizes = motion;
  if (entry.expectation.claims_equations()) {
    // The rounding error of an acceleration that is exactly 0 is proportional to the largest
    // acceleration.
    sizes.a.assign(motion.a.size(), max_magnitude(motion.a));
    sizes.multipliers.assign(motion.multipliers.size(), max_magnitude(motion.multipliers));
    return motion_function_sample(value, motion, 0, sizes);
  }
  sizes.multipliers.clear();
  const std::optional<cl_R> size = value(motion);
  if (!size) return std::nullopt;
  const auto rate = [&](const State& at) { return oracle_expression_rate(model, id, at); };
  return motion_function_sample(rate, motion, cln::abs(*size), sizes);
}

bool needs_motion(const Expectation& expectation) {
  return expectation.claims_conservation() || expectation.claims_equations();
}

/// The points at which an expectation is sampled.
std::vector<SampledPoint> sample_points(const Model& model, const Expectation& expectation,
                                        const std::vector<State>& states) {
  const auto request = find_request(model, expectation.output);
  std::vector<SampledPoint> points;
  for (const State& state : states) {
    if (needs_motion(expectation)) {
      const auto motion =
          expectation.claims_conservation() ? free_motion(model, state) : motion_at(model, state);
      if (motion) points.push_back({*motion});
    } else if (request) {
      points.push_back(oracle_point_at(model, *request, state));
    }
  }
  return points;
}

/// The difference of the written form from the derived one; "" if a form is missing or the text is
/// too long.
std::string difference_text(const ExpectedEntry& entry, ExpectationProver& proofs) {
  // Quotients that the author typed are reported as quotients, not as Stumpff functions.
  if (!entry.subject.model.original_expressions.empty() && proofs.quotient_forms() != nullptr) {
    ExpectationProver by_quotients(entry.subject, proofs.quotient_forms());
    return difference_text(entry, by_quotients);
  }
  const std::optional<Fraction> written = proofs.written_form(entry.expectation, entry.index);
  if (!written) return {};
  if (entry.expectation.claims_conservation()) return difference_from_constant(proofs, *written);
  if (entry.expectation.claims_equations()) return difference_from_motion(entry, proofs, *written);
  const std::optional<Fraction> derived = proofs.derived_form(entry.expectation, entry.index);
  if (!derived) return {};
  Algebra& algebra = *proofs.algebra();
  const Model& model = entry.subject.model;
  const auto terms = differing_terms(algebra, *derived, *written);
  std::string text = terms ? differing_terms_text(model, algebra, *terms) : "";
  if (!text.empty()) return text;
  const OptionalFraction difference = Arithmetic(algebra).subtract(*written, *derived);
  text = difference ? short_form_text(model, algebra, *difference) : "";
  return text.empty() ? "" : "the difference is " + text;
}

std::optional<ComparedValue> sample_at(const ExpectedEntry& entry, const SampledPoint& point) {
  return needs_motion(entry.expectation) ? motion_sample(entry, point.state)
                                         : value_sample(entry, point);
}

double error_of(const ComparedValue& sample) {
  return relative_difference(sample.written - sample.derived, sample.scale);
}

/// True if a wrong entry holds at these points with the file's values of the parameters. Example:
/// 5/7 g sin(alpha) of a homogeneous ball.
bool holds_at_file_values(const ExpectedEntry& entry, const std::vector<SampledPoint>& points) {
  const Model& model = entry.subject.model;
  const State nominal = nominal_state(model, fixing_scene(entry.subject, entry.expectation));
  std::vector<State> states;
  for (std::size_t i = 0; i < points.size() && i < states_of_values; ++i) {
    states.push_back(points[i].state);
    states.back().parameters = nominal.parameters;
  }
  std::size_t held = 0;
  for (const SampledPoint& point : sample_points(model, entry.expectation, states)) {
    const auto sample = sample_at(entry, point);
    if (sample && !(error_of(*sample) <= tolerance)) return false;
    if (sample) ++held;
  }
  return held > 0 && !model.parameters.empty();
}

/// The difference of a wrong entry from the derived one, and a note if the entry holds with the
/// file's values of the parameters.
std::string hint_of(const ExpectedEntry& entry, ExpectationProver& proofs,
                    const std::vector<SampledPoint>& points) {
  std::string hint = difference_text(entry, proofs);
  if (!holds_at_file_values(entry, points)) return hint;
  if (!hint.empty()) hint += "; ";
  return hint + "it holds for the parameter values of the file";
}

/// The points at which entries are sampled, and the kinks that have points on one side only.
struct ComparisonPoints {
  const std::vector<SampledPoint>& points;
  const std::string& one_sided_kinks;
};

/// Compares one entry at all points, adds its row, and reports the first wrong point.
void compare_entry(ExpectationReport& report, const ExpectedEntry& entry, ExpectationProver& proofs,
                   const ComparisonPoints& sampled) {
  Tally tally;
  std::string wrong;
  for (const SampledPoint& point : sampled.points) {
    const auto sample = sample_at(entry, point);
    if (!sample) {
      tally.count_skipped();
      continue;
    }
    const double figure = error_of(*sample);
    tally.add(figure, point.state);
    if (wrong.empty() && !(figure <= tolerance)) wrong = mistake_text(entry, *sample, point.state);
  }
  CertificateRow& row = report.rows.emplace_back(unjudged_row(entry));
  row.tolerance = sampled_reason;
  tally.write_result(row, entry.subject, tolerance);
  row.worst_value = fmt::format("{:.1e} relative", tally.worst());
  if (row.verdict == Verdict::holds) row.worst_state.clear();
  // An expectation without any value fails, because its author expects a value.
  if (tally.samples() == 0) row.verdict = Verdict::fails;
  if (!sampled.one_sided_kinks.empty())
    row.tolerance += "; sampled on one side only: " + sampled.one_sided_kinks;
  if (!wrong.empty()) {
    std::string hint = hint_of(entry, proofs, sampled.points);
    if (!hint.empty()) row.worst_value += "; " + hint;
    report.diagnostics.push_back({Code::E510, entry.span(), std::move(wrong), std::move(hint)});
  } else if (tally.samples() == 0) {
    report.diagnostics.push_back(no_common_value_error(entry));
  }
}

void check_expectation(ExpectationReport& report, const Expectation& expectation,
                       ExpectationProver& proofs, const CoveringStates& all) {
  const SystemUnderTest& subject = proofs.subject();
  const bool incomplete =
      expectation.claims_equations() && is_incomplete(subject.model, expectation);
  std::optional<std::vector<SampledPoint>> points;  // set at the first entry without a proof
  std::vector<ExpressionId> identities;
  for (std::size_t index = 0; index < expectation.entries.size(); ++index) {
    const ExpectedEntry entry{expectation, index, subject};
    auto row = expectation.claims_equations() ? identity_row(entry, all.states) : std::nullopt;
    if (row) identities.push_back(entry.expression());
    if (!row) row = proved_row(entry, proofs, incomplete);
    if (row) {
      report.rows.push_back(*std::move(row));
      continue;
    }
    if (!points) points = sample_points(subject.model, expectation, all.states);
    compare_entry(report, entry, proofs, {*points, all.one_sided_kinks});
  }
  if (expectation.claims_equations()) {
    check_rank(report, expectation, identities, subject, all.states);
  }
}

void check_all_expectations(ExpectationReport& report, const SystemUnderTest& subject,
                            ClosedForms* forms, std::uint64_t seed) {
  const Model& model = subject.model;
  // Expectations of the model describe neither an expansion of it nor inputs of the scene.
  const bool is_whole = !model.approximation && subject.scene.model_alone == nullptr;
  ExpectationProver proofs(subject, forms);
  std::array<std::optional<CoveringStates>, 2> drawn;  // of the model, and of the scene
  for (const Expectation& expectation : model.expectations) {
    const bool is_from_scene = is_of_scene(model, expectation.span);
    if (!is_whole && !is_from_scene) continue;
    if (expectation.state) {
      check_numbers(report, expectation, subject);
      continue;
    }
    std::optional<CoveringStates>& points = drawn[is_from_scene ? 1 : 0];
    const Scene& scene = fixing_scene(subject, expectation);
    if (!points) points = draw_covering_states(model, scene, point_count, seed);
    check_expectation(report, expectation, proofs, *points);
  }
}

}  // namespace

const Scene& fixing_scene(const SystemUnderTest& subject, const Expectation& expectation) {
  static const Scene fixes_nothing;
  return is_of_scene(subject.model, expectation.span) ? subject.scene : fixes_nothing;
}

std::string name_of(const ExpectedEntry& entry) {
  const Field field{.columns = std::max(entry.expectation.columns, 1U),
                    .entries = entry.expectation.entries};
  return name_in_file(entry.expectation) + index_text(field, entry.index);
}

CertificateRow unjudged_row(const ExpectedEntry& entry) {
  CertificateRow row;
  row.check = "[[expect]]";
  row.output = row.check + " " + name_in_file(entry.expectation);
  row.subject = name_of(entry);
  row.formula = expected_formula(entry);
  return row;
}

ExpectationReport check_expectations(const SystemUnderTest& subject, ClosedForms* forms,
                                     std::uint64_t seed) {
  ExpectationReport report;
  if (subject.scene.model_alone != nullptr) {
    const Model& alone = *subject.scene.model_alone;
    Program no_functions;
    no_functions.leaves = leaf_names(alone);
    const Scene no_changes;
    check_all_expectations(report, {alone, no_changes, no_functions}, nullptr, seed);
  }
  check_all_expectations(report, subject, forms, seed);
  return report;
}

}  // namespace elgen
