// elgen verify: a certificate per input, on stdout and where -o says.
#include <algorithm>

#include "elgen/render.hpp"
#include "inputs.hpp"
#include "options.hpp"
#include "output_files.hpp"
#include "progress.hpp"
#include "resources.hpp"

namespace elgen::cli {

namespace {

PipelineOptions pipeline_options(const GlobalOptions& global) {
  PipelineOptions pipeline;
  pipeline.limits = global.limits;
  pipeline.dump_stage = global.dump_stage;
  pipeline.stop_after = global.stop_after;
  pipeline.check_itself = false;
  pipeline.scene.large_expectations = true;
  return pipeline;
}

/// Compiles, unless it is to be quick, and compares.
Result<Verification> compared(const std::string& path, const Products& products,
                              const VerifyOptions& options, const Limits& limits) {
  const auto& [model, scene] = *products.checked;
  const Progress progress(path);
  CompiledHeaders compiled;
  if (!options.quick) {
    progress.stage("compile");
    auto result = compile(*products.files, model, scene, *products.program, limits);
    if (!result) return result.diagnostics;
    compiled = std::move(*result);
  }
  progress.stage("verify");
  return verify(model, scene, *products.program, compiled, options);
}

/// Appends the input's certificate; none where it could not be generated.
ExitCode verify_one(const GlobalOptions& global, const VerifyCommandOptions& options,
                    const std::string& path, std::vector<std::string>& certificates) {
  renew_time_limit(global.limits);
  const Result<Inputs> inputs = read_inputs(path, global.limits);
  if (!inputs) return report(global, inputs.diagnostics);
  Products products = run_shown(path, *inputs, pipeline_options(global));
  const ExitCode dumped = print(global, products.dump);
  const ExitCode generated = std::max(dumped, report(global, products.diagnostics));
  tell_times(global, products);
  if (generated != ExitCode::success || !global.stop_after.empty()) return generated;
  if (global.verbose) {
    const auto& [model, scene] = *products.checked;
    tell(global, text_page(model, scene, *products.program));
  }
  VerifyOptions with_proofs = options.verify;
  with_proofs.forms = &*products.closed_forms;
  const Result<Verification> verification = compared(path, products, with_proofs, global.limits);
  if (!verification) return report(global, verification.diagnostics);
  certificates.push_back(to_text(verification->certificate));
  const ExitCode printed = print(global, certificates.back());
  const ExitCode found = std::max(printed, report(global, verification->diagnostics));
  return holds(verification->certificate) ? found : std::max(found, ExitCode::differs);
}

}  // namespace

ExitCode verify_inputs(const GlobalOptions& global, const VerifyCommandOptions& options) {
  const std::string& file = options.certificate_file;
  Diagnostics refused;
  if (!file.empty()) refused = refuse_places({{file, "", Replaces::nothing}}, options.force);
  if (!refused.empty()) return report(global, refused);
  ExitCode worst = ExitCode::success;
  std::vector<std::string> certificates;
  for (const std::string& path : options.inputs) {
    worst = std::max(worst, verify_one(global, options, path, certificates));
  }
  // A file with some certificates missing would look like all of them.
  if (file.empty() || certificates.size() != options.inputs.size()) return worst;
  std::string all;
  for (const std::string& certificate : certificates) all += certificate;
  const auto written =
      write_files({{file, all, Replaces::nothing}}, {options.force, global.limits.seconds});
  return std::max(worst, report(global, written.diagnostics));
}

}  // namespace elgen::cli
