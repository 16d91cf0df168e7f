// elgen verify: a certificate per input, on stdout and where -o says.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "inputs.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "resources.hpp"

namespace elgen::cli {

namespace {

ExitCode verify_one(const GlobalOptions& global, const VerifyCommandOptions& options,
                    const std::string& path, std::string& certificates) {
  renew_time_limit(global.limits);
  Result<Inputs> inputs = read_inputs(path, global.limits);
  if (!inputs) return report(global, inputs.diagnostics);
  const Progress progress(path);
  PipelineOptions pipeline;
  pipeline.limits = global.limits;
  pipeline.dump_stage = global.dump_stage;
  pipeline.stop_after = global.stop_after;
  pipeline.check_itself = false;
  pipeline.scene.large_expectations = true;
  pipeline.on_stage = [&](const std::string& stage) { progress.stage(stage); };
  Products products = run_pipeline(*inputs, pipeline);
  fmt::print("{}", products.dump);
  const ExitCode generated = report(global, products.diagnostics);
  tell_times(global, products);
  if (generated != ExitCode::success || !global.stop_after.empty()) return generated;

  const auto& [model, scene] = *products.checked;
  std::unique_ptr<CompiledModel> compiled;
  if (!options.verify.quick) {
    progress.stage("compile");
    auto result = compile(*products.files, model, scene, *products.program);
    if (!result) return report(global, result.diagnostics);
    compiled = std::move(*result);
  }
  progress.stage("verify");
  VerifyOptions with_proofs = options.verify;
  with_proofs.forms = &*products.closed_forms;
  const Verification verification =
      verify(model, scene, *products.program, compiled.get(), with_proofs);
  certificates += to_text(verification.certificate);
  const ExitCode found = report(global, verification.diagnostics);
  return holds(verification.certificate) ? found : std::max(found, ExitCode::differs);
}

}  // namespace

ExitCode verify_inputs(const GlobalOptions& global, const VerifyCommandOptions& options) {
  ExitCode worst = ExitCode::success;
  std::string all;
  for (const std::string& path : options.inputs) {
    std::string certificates;
    worst = std::max(worst, verify_one(global, options, path, certificates));
    fmt::print("{}", certificates);
    all += certificates;
  }
  if (options.certificate_file.empty()) return worst;
  std::ofstream file(options.certificate_file, std::ios::binary);
  file << all;
  file.close();
  if (file) return worst;
  return std::max(
      worst,
      report(
          global,
          {{Code::E706, {}, fmt::format("`{}` could not be written", options.certificate_file)}}));
}

}  // namespace elgen::cli
