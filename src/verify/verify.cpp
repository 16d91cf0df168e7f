// verify: oracle, program and compiled code of one scene, compared row by row. Each kind of check
// lives in a file of its own; here is only the order of the certificate.
#include <algorithm>
#include <utility>

#include "accuracy.hpp"
#include "compiled_code.hpp"
#include "elgen/certificate.hpp"
#include "emit/scalar_range.hpp"
#include "expectations.hpp"
#include "sampled_zeros.hpp"
#include "states.hpp"
#include "structure.hpp"

namespace elgen {
namespace {

constexpr std::size_t quick_samples = 16;
constexpr std::size_t default_samples = 256;
/// Instructions times random states, about half a minute in 64 digits; never fewer states than
/// a quick run has.
constexpr std::size_t most_work = 1 << 20;
/// Identities hold at all states or at none, so that few states tell.
constexpr std::size_t structure_samples = 32;

void append(std::vector<CertificateRow>& rows, const std::vector<CertificateRow>& more) {
  rows.insert(rows.end(), more.begin(), more.end());
}

std::vector<State> nominal_states(const Subject& subject,
                                  const std::vector<SampledState<double>>& samples) {
  std::vector<State> states;
  for (const SampledState<double>& sample : samples) {
    if (sample.region != Region::nominal || states.size() == structure_samples) continue;
    states.push_back(exact_state(subject, sample.values));
  }
  return states;
}

std::size_t samples_of(const Program& program, const VerifyOptions& options) {
  if (options.quick) return quick_samples;
  if (options.samples) return *options.samples;
  std::size_t length = 1;
  for (const Function& function : program.functions) length += function.instructions.size();
  return std::clamp(most_work / length, quick_samples, default_samples);
}

}  // namespace

Verification verify(const Model& model, const Scene& scene, const Program& program,
                    const CompiledHeaders& compiled, const VerifyOptions& options) {
  const Subject subject{model, scene, program};
  const Sampling sampling{samples_of(program, options), options.seed, true};
  const auto doubles = sample_states<double>(subject, sampling);
  const auto floats = sample_states<float>(subject, sampling);

  Verification result;
  result.certificate = {model.name, scene.name.empty() ? "full" : scene.name, options.seed, {}};
  std::vector<CertificateRow>& rows = result.certificate.rows;
  ExpectationReport expected = check_expectations(subject, options.forms, options.seed);
  append(rows, expected.rows);
  append(rows, check_accuracy(subject, doubles));
  const bool fits_float = fits(model, program, ScalarKind::single_precision);
  if (fits_float) append(rows, check_accuracy(subject, floats));
  for (const CompiledHeader& header : compiled) {
    const bool has_doubles = header.functions->has(ScalarKind::double_precision);
    const bool has_floats = header.functions->has(ScalarKind::single_precision);
    if (has_doubles) append(rows, check_compiled(subject, header, doubles));
    if (has_floats) append(rows, check_compiled(subject, header, floats));
  }
  append(rows, sampled_zeros(program));
  append(rows, check_structure(subject, nominal_states(subject, doubles)));
  result.diagnostics = std::move(expected.diagnostics);
  return result;
}

}  // namespace elgen
