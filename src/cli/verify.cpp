// elgen verify: a certificate per input, on stdout and where -o says.
#include <algorithm>
#include <chrono>

#include "cli/commands.hpp"
#include "cli/inputs.hpp"
#include "cli/output_files.hpp"
#include "cli/progress.hpp"
#include "cli/resources.hpp"
#include "elgen/render.hpp"

namespace elgen::cli {

namespace {

struct VerifyCommandOptions {
  std::vector<std::string> inputs = {};
  VerifyOptions verify = {};
  bool strict = false;                ///< what is skipped counts as failed
  std::string certificate_file = {};  ///< empty: none
  bool force = false;
};

/// A step that is shown, and timed with the stages of `products`.
template <class Step>
auto timed(const std::string& name, Products& products, const Progress& progress,
           const Step& step) {
  progress.stage(name);
  const auto start = std::chrono::steady_clock::now();
  auto result = step();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  products.times.push_back({name, elapsed.count()});
  return result;
}

/// Compiles, unless it is to be quick, and compares.
Result<Verification> compared(const std::string& path, Products& products,
                              const VerifyOptions& options, const Limits& limits) {
  const Model& model = products.checked->model;
  const Scene& scene = products.checked->scene;
  const Program& program = *products.program;
  const Progress progress(path);
  const auto compiled_by = [&](Build build) -> Result<CompiledHeaders> {
    if (options.quick) return CompiledHeaders();
    return timed("compile", products, progress,
                 [&] { return compile(*products.files, model, scene, program, limits, build); });
  };
  const Result<CompiledHeaders> compiled = compiled_by(Build::as_written);
  if (!compiled) return compiled.diagnostics;
  const Result<CompiledHeaders> as_users = compiled_by(Build::as_users);
  if (!as_users) return as_users.diagnostics;
  VerifyOptions with_products = options;
  with_products.forms = &*products.closed_forms;
  with_products.parts = &products.parts;
  with_products.ways = &products.ways;
  if (!as_users->empty()) with_products.as_users = as_users->front().functions.get();
  with_products.on_step = [&progress](const std::string& step) { progress.stage(step); };
  return timed("verify", products, progress,
               [&] { return verify(model, scene, program, *compiled, with_products); });
}

/// With every check, as -o gets it.
std::string full_text(const GlobalOptions& global, const Certificate& certificate) {
  const bool is_json = global.style.format == DiagnosticFormat::json;
  return is_json ? to_json(certificate) : to_full_text(certificate);
}

/// As -q, -v and --format want it.
std::string text_of(const GlobalOptions& global, const Certificate& certificate) {
  const bool is_json = global.style.format == DiagnosticFormat::json;
  if (is_json || (global.verbose && !global.quiet)) return full_text(global, certificate);
  return global.quiet ? verdict_line(certificate) : to_text(certificate);
}

ExitCode exit_code(const Certificate& certificate, bool strict) {
  const bool is_decided = !strict || count(certificate, Verdict::skipped) == 0;
  return holds(certificate) && is_decided ? ExitCode::success : ExitCode::differs;
}

/// Appends the input's certificate in full; none where it could not be generated.
ExitCode verify_one(const GlobalOptions& global, const VerifyCommandOptions& options,
                    const std::string& path, std::vector<std::string>& certificates) {
  renew_time_limit(global.limits);
  const Result<Inputs> inputs = read_inputs(path, global.limits);
  if (!inputs) return report(global, inputs.diagnostics);
  PipelineOptions pipeline = pipeline_options(global, {"readback", "parts"});
  pipeline.scene.large_expectations = true;
  Products products = run_shown(path, *inputs, pipeline);
  const ExitCode generated = report_products(global, products);
  if (generated != ExitCode::success || !global.stop_after.empty()) {
    tell_times(global, products);
    return generated;
  }
  if (global.verbose) {
    tell(global, text_page(products.checked->model, products.checked->scene, *products.program));
  }
  const auto verification = compared(path, products, options.verify, global.limits);
  tell_times(global, products);
  if (!verification) return report(global, verification.diagnostics);
  const Certificate& certificate = verification->certificate;
  certificates.push_back(full_text(global, certificate));
  const ExitCode printed = print(global, text_of(global, certificate));
  const ExitCode found = std::max(printed, report(global, verification->diagnostics));
  return std::max(found, exit_code(certificate, options.strict));
}

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

}  // namespace

void add_verify(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("verify", "check models against 60-digit arithmetic");
  const auto options = std::make_shared<VerifyCommandOptions>();
  command->add_option("inputs", options->inputs, "NAME.toml, NAME.scene.toml or - (stdin)")
      ->required();
  command
      ->add_option("--samples", options->verify.samples,
                   "states per output (256, fewer for long programs)")
      ->check(CLI::PositiveNumber);
  command->add_flag("--quick", options->verify.quick,
                    "few states, projections instead of all entries, no compiler");
  command->add_flag("--strict", options->strict, "exit with 1 where a check is skipped");
  command->add_option("-o,--output", options->certificate_file, "write the certificates here too")
      ->type_name("FILE");
  command->add_flag("--force", options->force, "overwrite FILE");
  set_action(*command, action, options, &verify_inputs);
}

}  // namespace elgen::cli
