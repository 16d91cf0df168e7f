// verify: compares oracle, program and compiled code of one scene, row by row. Each kind of check
// has its own file; this file sets the order of the rows.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "elgen/certificate.hpp"
#include "elgen/emitted_files.hpp"
#include "sample/states.hpp"
#include "verify/bounds/accuracy.hpp"
#include "verify/bounds/visit.hpp"
#include "verify/compiled_code.hpp"
#include "verify/states/kinks.hpp"
#include "verify/states/lossy_states.hpp"
#include "verify/states/near_zeros.hpp"
#include "verify/structure/expectations.hpp"
#include "verify/structure/structure.hpp"

namespace elgen {
namespace {

/// The default effort: `samples` random states, all extremes, states near zeros of sums, and states
/// at which the program may lose digits. If state_check_cost() times the number of states exceeds
/// `work`, fewer states are used, at least one.
struct Effort {
  std::size_t samples;
  std::size_t work;
};

/// About half a minute in 64 digits.
constexpr Effort thorough_effort{256, 1 << 20};
/// A few seconds. The longest programs are compared at one state per scalar.
constexpr Effort quick_effort{16, 1 << 18};
/// With this many velocities or more, the oracle takes minutes for all entries of all outputs.
constexpr std::size_t min_projected_velocities = 9;
/// Identities hold at all states or at none, so few states suffice.
constexpr std::size_t structure_samples = 32;

template <class Element>
void append(std::vector<Element>& all, std::vector<Element> more) {
  std::ranges::move(more, std::back_inserter(all));
}

std::vector<State> nominal_states(const SystemUnderTest& subject,
                                  const std::vector<SampledState<double>>& samples) {
  std::vector<State> states;
  for (const SampledState<double>& sample : samples) {
    if (sample.region != Region::nominal || states.size() == structure_samples) continue;
    states.push_back(exact_state(subject, sample.values));
  }
  return states;
}

/// At most `most` states, spread evenly; the first state is always among them.
template <class State>
std::vector<State> spread(std::vector<State> states, std::size_t most) {
  if (states.size() <= most) return states;
  std::vector<State> some;
  const std::size_t step = golden_step(states.size());
  for (std::size_t i = 0; i < most; ++i) some.push_back(states[i * step % states.size()]);
  return some;
}

/// If not all states are affordable, up to half of the affordable ones are near zeros and at
/// places with large losses.
template <class Scalar>
std::vector<SampledState<Scalar>> verification_states(const SystemUnderTest& subject,
                                                      const VerifyOptions& options) {
  const Effort& effort = options.is_quick ? quick_effort : thorough_effort;
  const SamplingOptions sampling{options.samples.value_or(effort.samples), options.seed, true};
  auto states = sample_states<Scalar>(subject, sampling);
  append(states, remote_states<Scalar>(subject, options.seed));
  auto near = states_near_zeros<Scalar>(subject, sampling);
  append(near, lossy_states<Scalar>(subject, sampling));
  if (!options.samples) {
    const std::size_t affordable =
        std::max<std::size_t>(effort.work / state_check_cost(subject), 1);
    if (states.size() + near.size() > affordable) near = spread(std::move(near), affordable / 2);
    states = spread(std::move(states), affordable - near.size());
  }
  append(states, std::move(near));
  return states;
}

/// Gives a third of the states steps of length 2^-20, and a third steps of length 0. Accelerations
/// then change the state by less than one rounding to float, so a state in float exceeds the bound.
void shorten_steps(std::vector<SampledState<double>>& states) {
  constexpr std::array lengths{0x1p-20, 0.0};
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (i % 3 < lengths.size()) states[i].values.h = lengths[i % 3];
  }
}

/// Each kink has two sides. Draws more states, and adds each state that is the first on some side.
/// Returns the kinks that still have states on one side only.
template <class Scalar>
std::string add_states_at_kinks(const SystemUnderTest& subject, const VerifyOptions& options,
                                std::vector<SampledState<Scalar>>& states) {
  KinkCoverage kinks(subject.model);
  for (const auto& state : states) {
    if (kinks.is_complete()) return {};
    kinks.add_state(exact_state(subject, state.values));
  }
  StateSequence<Scalar> more(subject, {most_draws_for_kinks, options.seed + 1, false});
  while (!kinks.is_complete()) {
    auto state = more.next();
    if (!state) break;
    if (kinks.add_state(exact_state(subject, state->values))) states.push_back(std::move(*state));
  }
  return kinks.one_sided_kinks_text();
}

CertificateRow one_sided_kinks_row(const std::string& kinks, std::size_t states) {
  CertificateRow row;
  row.check = "both sides of kinks";
  row.output = row.subject = "forces";
  row.formula = "the sign of x in abs(x), sign(x), and of x - y in min(x, y), max(x, y)";
  row.samples = states;
  row.worst_value = "sampled on one side only: " + kinks;
  row.tolerance = fmt::format("both signs in {} draws", most_draws_for_kinks);
  row.verdict = Verdict::noted;
  return row;
}

CertificateRow equilibrium_row(const std::string& equilibrium, const char* subject,
                               const char* formula, ClaimStatus status) {
  CertificateRow row;
  row.check = "[[equilibrium]]";
  row.output = fmt::format("{} {}", row.check, equilibrium);
  row.subject = fmt::format("{}.{}", equilibrium, subject);
  row.formula = formula;
  const bool is_proved = status == ClaimStatus::proved;
  row.evidence = is_proved ? Evidence::proof : Evidence::states;
  row.worst_value = is_proved ? "proved: the difference is the empty canonical sum" : "";
  row.tolerance = "1e-30 in 60 digits at random parameters: sampled, no proof";
  if (is_proved) row.tolerance = "proved";
  row.verdict = status == ClaimStatus::wrong       ? Verdict::fails
                : status == ClaimStatus::undecided ? Verdict::skipped
                                                   : Verdict::holds;
  return row;
}

std::vector<CertificateRow> equilibrium_rows(const std::vector<EquilibriumVerdict>& claims) {
  std::vector<CertificateRow> rows;
  for (const EquilibriumVerdict& claim : claims) {
    rows.push_back(equilibrium_row(claim.name, "balance", "bias(q, 0) - B u = 0", claim.balance));
    rows.back().worst_state = claim.balance == ClaimStatus::wrong ? claim.witness : "";
    if (!claim.frequencies) continue;
    rows.push_back(equilibrium_row(claim.name, "frequencies_squared",
                                   "det(x M - K) = det M (x - w1^2) (x - w2^2) ...",
                                   *claim.frequencies));
    rows.back().worst_state = *claim.frequencies == ClaimStatus::wrong ? claim.witness : "";
  }
  return rows;
}

std::string entry_numbers_text(const std::vector<std::uint32_t>& entries) {
  std::string text;
  for (const std::uint32_t entry : entries) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", entry + 1);
  }
  return text;
}

/// One row for each function with entries that `cancel` (elgen/cancel.hpp) replaced by 0, because
/// these entries were 0 at sampled points. Each row holds, because `cancel` checked all points.
std::vector<CertificateRow> sampled_zero_rows(const Program& program) {
  std::vector<CertificateRow> rows;
  for (const Function& function : program.functions) {
    if (function.sampled_zeros.empty()) continue;
    CertificateRow row;
    row.check = "zeros that are not proved";
    row.output = row.subject = function.name;
    row.formula = "|x| <= 1e-40 E in 60 digits for every x replaced by 0";
    row.evidence = Evidence::zeros;
    row.samples = zero_sample_count;
    row.worst_value = fmt::format("in entr{} {}", function.sampled_zeros.size() == 1 ? "y" : "ies",
                                  entry_numbers_text(function.sampled_zeros));
    row.tolerance =
        "20 digits above rounding error: no proof, but a value other than 0 would hardly stay "
        "below";
    rows.push_back(std::move(row));
  }
  return rows;
}

/// The functions compiled as users compile them, for single states or in packs; in Numerics::inner
/// if `is_wide`. Null if there is no such code, or if the code lacks `scalar`.
const CompiledModel* find_user_code(const CompiledHeaders& compiled, bool is_wide, bool in_packs,
                                    ScalarKind scalar) {
  for (const CompiledHeader& header : compiled) {
    const bool is_sought = header.is_in_packs == in_packs && header.is_wide == is_wide;
    if (header.build != BuildFlags::user_flags || !is_sought || header.functions == nullptr)
      continue;
    return header.functions->has(scalar) ? header.functions.get() : nullptr;
  }
  return nullptr;
}

/// The rows that compare compiled code with the program, not with the oracle.
std::vector<CertificateRow> check_compiled_headers(const SystemUnderTest& subject,
                                                   const CompiledHeaders& compiled,
                                                   const std::vector<SampledState<double>>& doubles,
                                                   const std::vector<SampledState<float>>& floats) {
  std::vector<CertificateRow> rows;
  std::vector<CertificateRow> sines;
  std::vector<CertificateRow> lacking;
  for (const CompiledHeader& header : compiled) {
    if (header.functions == nullptr) {
      lacking.push_back(missing_code_row(header));
      continue;
    }
    const bool has_doubles = header.functions->has(ScalarKind::double_precision);
    const bool has_floats = header.functions->has(ScalarKind::single_precision);
    if (has_doubles) append(rows, check_compiled_code(subject, header, doubles));
    if (has_floats) append(rows, check_compiled_code(subject, header, floats));
    append(sines, check_pack_sines(subject, header));
  }
  append(rows, lacking);
  append(rows, sines);
  if (!compiled.empty()) append(rows, check_helper_functions(subject));
  for (const CompiledHeader& header : compiled) {
    if (!header.declared.empty()) rows.push_back(check_declared_numbers(header.declared));
  }
  return rows;
}

/// Projections, to save time, if `options.is_quick` or if velocities are many; otherwise entries.
ComparisonMode comparison_for(const Model& model, const VerifyOptions& options) {
  const bool is_large = model.velocities.size() >= min_projected_velocities;
  return options.is_quick || is_large ? ComparisonMode::projections : ComparisonMode::entries;
}

}  // namespace

Verification verify(const Model& model, const Scene& scene, const Program& program,
                    const CompiledHeaders& compiled, const VerifyOptions& options) {
  const SystemUnderTest subject{model, scene, program};
  Verification result;
  result.certificate = {model.name, scene.name.empty() ? "full" : scene.name, options.seed, {}};
  std::vector<CertificateRow>& rows = result.certificate.rows;
  ExpectationReport expected = check_expectations(subject, options.forms, options.seed);
  append(rows, expected.rows);
  result.diagnostics = std::move(expected.diagnostics);
  if (options.only_expectations) return result;
  auto doubles = verification_states<double>(subject, options);
  if (scene.numerics.has_mixed_precision()) shorten_steps(doubles);
  auto floats = verification_states<float>(subject, options);
  const std::string one_sided_kinks = add_states_at_kinks(subject, options, doubles);
  (void)add_states_at_kinks(subject, options, floats);
  const auto accuracy = [&](ScalarKind scalar) {
    StateCheckOptions visit{comparison_for(model, options)};
    visit.loss_states =
        options.checks_extremes ? LossStates::everywhere : LossStates::inside_ranges;
    visit.user_code = find_user_code(compiled, false, false, scalar);
    visit.wide_code = find_user_code(compiled, true, false, scalar);
    visit.wide_pack_code = find_user_code(compiled, true, true, scalar);
    return AccuracyOptions{visit, options.on_step, options.jobs};
  };

  if (options.equilibrium_verdicts != nullptr)
    append(rows, equilibrium_rows(*options.equilibrium_verdicts));
  append(rows, check_accuracy(subject, doubles, accuracy(ScalarKind::double_precision)));
  const bool fits_float = literals_fit(model, program, ScalarKind::single_precision);
  if (fits_float)
    append(rows, check_accuracy(subject, floats, accuracy(ScalarKind::single_precision)));
  append(rows, check_compiled_headers(subject, compiled, doubles, floats));
  append(rows, sampled_zero_rows(program));
  if (!one_sided_kinks.empty())
    rows.push_back(one_sided_kinks_row(one_sided_kinks, doubles.size()));
  append(rows, check_structure(subject, nominal_states(subject, doubles)));
  return result;
}

}  // namespace elgen
