// elgen verify: a certificate per input, on stdout and where -o says.
#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "cli/commands.hpp"
#include "cli/comparison.hpp"
#include "cli/files/inputs.hpp"
#include "cli/files/output_files.hpp"
#include "cli/process/resources.hpp"
#include "cli/process/terminal.hpp"
#include "cli/shards/screening_shard.hpp"
#include "cli/shown_pipeline.hpp"
#include "elgen/render.hpp"

namespace elgen::cli {

namespace {

struct VerifyCommandOptions {
  std::vector<std::string> inputs = {};
  ComparisonOptions comparison = {};
  std::optional<Shard> shard = {};  ///< to be screened alone
  bool merge = false;               ///< inputs are files of shards
  bool strict = false;              ///< what is skipped counts as failed
  std::string output_file = {};     ///< of certificates or of the shard; empty: none
  bool force = false;
};

/// With every check, as -o gets it.
std::string full_text(const GlobalOptions& global, const Certificate& certificate) {
  return wants_json(global) ? to_json(certificate) : to_full_text(certificate);
}

/// As -q, -v and --format want it.
std::string text_of(const GlobalOptions& global, const Certificate& certificate) {
  if (wants_json(global) || (global.verbose && !global.quiet))
    return full_text(global, certificate);
  return global.quiet ? verdict_line(certificate) : to_text(certificate);
}

ExitCode exit_code(const Certificate& certificate, bool strict) {
  const bool is_decided = !strict || count(certificate, Verdict::skipped) == 0;
  return holds(certificate) && is_decided ? ExitCode::success : ExitCode::differs;
}

/// The stages that all comparisons need.
Products derived(const GlobalOptions& global, const std::string& path, const Inputs& inputs) {
  PipelineOptions pipeline = pipeline_options(global, {"emit", "parts"});
  pipeline.scene.large_expectations = true;
  return run_shown(path, inputs, pipeline);
}

bool is_derived(const GlobalOptions& global, ExitCode generated) {
  return generated == ExitCode::success && global.stop_after.empty();
}

/// Appends the input's certificate in full; none where it could not be generated.
ExitCode verify_one(const GlobalOptions& global, const VerifyCommandOptions& options,
                    const Inputs& inputs, const Screening* screening,
                    std::vector<std::string>& certificates) {
  const std::string& path = (inputs.scene != nullptr ? inputs.scene : inputs.model)->path;
  Products products = derived(global, path, inputs);
  const ExitCode generated = report_products(global, products);
  if (!is_derived(global, generated)) {
    tell_times(global, products);
    return generated;
  }
  if (global.verbose) {
    const auto& [model, scene] = *products.checked;
    tell(global, overview(sheet(model, scene, *products.program), screen_of(stderr)));
  }
  const auto verification = compared(path, products, options.comparison, global.limits, screening);
  tell_times(global, products);
  if (!verification) return report(global, verification.diagnostics);
  const Certificate& certificate = verification->certificate;
  certificates.push_back(full_text(global, certificate));
  const ExitCode printed = print(global, text_of(global, certificate));
  const ExitCode found = std::max(printed, report(global, verification->diagnostics));
  return std::max(found, exit_code(certificate, options.strict));
}

ExitCode write_output(const GlobalOptions& global, const VerifyCommandOptions& options,
                      const std::string& text) {
  const auto written = write_files({{options.output_file, text, Replaces::nothing}},
                                   {options.force, global.limits.seconds});
  return report(global, written.diagnostics);
}

ExitCode verify_each(const GlobalOptions& global, const VerifyCommandOptions& options) {
  ExitCode worst = ExitCode::success;
  std::vector<std::string> certificates;
  for (const std::string& path : options.inputs) {
    renew_time_limit(global.limits);
    const Result<Inputs> inputs = read_inputs(path, global.limits);
    const ExitCode found = inputs ? verify_one(global, options, *inputs, nullptr, certificates)
                                  : report(global, inputs.diagnostics);
    worst = std::max(worst, found);
  }
  // A file with some certificates missing would look like all of them.
  if (options.output_file.empty() || certificates.size() != options.inputs.size()) return worst;
  std::string all;
  for (const std::string& certificate : certificates) all += certificate;
  return std::max(worst, write_output(global, options, all));
}

/// Screens the shard's states of one input, and writes what is found.
ExitCode screen_shard(const GlobalOptions& global, const VerifyCommandOptions& options) {
  const std::string& path = options.inputs.front();
  const Result<Inputs> inputs = read_inputs(path, global.limits);
  if (!inputs) return report(global, inputs.diagnostics);
  Products products = derived(global, path, *inputs);
  const ExitCode generated = report_products(global, products);
  if (!is_derived(global, generated)) return generated;
  const Result<Machine> machine = this_machine(global.limits);
  if (!machine) return report(global, machine.diagnostics);
  const auto screening =
      screened(path, products, options.comparison, *options.shard, global.limits);
  tell_times(global, products);
  if (!screening) return report(global, screening.diagnostics);
  const VerifyOptions& verify = options.comparison.verify;
  return write_output(global, options,
                      to_json(ScreeningShard{head_here(ShardJob::verify, *inputs, *options.shard,
                                                       *machine, global.limits),
                                             *verify.samples, verify.seed, *screening}));
}

/// Verifies as one process that has screened all states.
ExitCode merge_shards(const GlobalOptions& global, const VerifyCommandOptions& options) {
  const Result<ScreeningShard> merged = merged_screening(options.inputs, global.limits);
  if (!merged) return report(global, merged.diagnostics);
  VerifyCommandOptions of_shards = options;
  of_shards.comparison.verify.samples = merged->samples;
  of_shards.comparison.verify.seed = merged->seed;
  std::vector<std::string> certificates;
  const ExitCode found =
      verify_one(global, of_shards, merged->head.inputs, &merged->screening, certificates);
  if (options.output_file.empty() || certificates.empty()) return found;
  return std::max(found, write_output(global, options, certificates.front()));
}

/// E913: what was asked for excludes itself.
Diagnostics contradictions(const VerifyCommandOptions& options) {
  const bool is_many = is_screened(options.comparison.verify);
  Diagnostics found;
  const auto refuse = [&found](std::string message) {
    found.push_back({Code::E913, {}, std::move(message)});
  };
  if (options.comparison.verify.quick && is_many) {
    refuse(fmt::format("--quick has no compiler, which more than {} samples are screened with",
                       most_visited_samples));
  }
  if (!options.shard) return found;
  if (!is_many) {
    refuse(fmt::format("--shard shares out what is screened: --samples of more than {}",
                       most_visited_samples));
  }
  if (options.inputs.size() != 1) refuse("--shard takes one input");
  if (options.output_file.empty()) refuse("--shard writes a file: `-o FILE`");
  return found;
}

ExitCode run_verify(const GlobalOptions& global, const VerifyCommandOptions& options) {
  if (const Diagnostics found = contradictions(options); !found.empty()) {
    return report(global, found);
  }
  const std::string& file = options.output_file;
  Diagnostics refused;
  if (!file.empty()) refused = refuse_places({{file, "", Replaces::nothing}}, options.force);
  if (!refused.empty()) return report(global, refused);
  if (options.merge) return merge_shards(global, options);
  return options.shard ? screen_shard(global, options) : verify_each(global, options);
}

/// How many states, which, and by whom.
void add_screening(CLI::App& command, const std::shared_ptr<VerifyCommandOptions>& options) {
  VerifyOptions& verify = options->comparison.verify;
  options->comparison.jobs = std::max(1U, std::thread::hardware_concurrency());
  CLI::Option* const samples =
      command
          .add_option("--samples", verify.samples,
                      "states per output (256, fewer for long programs); more than 2000 are "
                      "screened in 50 digits, and the worst 1000 visited")
          ->check(CLI::PositiveNumber);
  CLI::Option* const seed = command.add_option("--seed", verify.seed, "of the states (1)");
  command
      .add_option("--jobs", options->comparison.jobs, "processes that screen (as many as cores)")
      ->check(CLI::Range(1, 1024));
  CLI::Option* const shard =
      add_shard(command, options->shard, "screen one of N parts, for -o FILE");
  command.add_flag("--merge", options->merge, "inputs are shards: visit, certify")
      ->excludes(samples)
      ->excludes(seed)
      ->excludes(shard);
}

}  // namespace

void add_verify(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("verify", "check models against 60-digit arithmetic");
  const auto options = std::make_shared<VerifyCommandOptions>();
  command
      ->add_option("inputs", options->inputs,
                   "NAME.toml, NAME.scene.toml or - (stdin); with --merge files of shards")
      ->required();
  add_screening(*command, options);
  command->add_flag("--extremes", options->comparison.verify.extremes,
                    "count the digits that are lost beyond the declared ranges, too");
  command
      ->add_flag("--quick", options->comparison.verify.quick,
                 "few states, projections instead of all entries, no compiler")
      ->excludes(command->get_option("--merge"));
  command->add_flag("--strict", options->strict, "exit with 1 where a check is skipped");
  command
      ->add_option("-o,--output", options->output_file,
                   "write the certificates, or the shard, here too")
      ->type_name("FILE");
  command->add_flag("--force", options->force, "overwrite FILE");
  set_action(*command, action, options, &run_verify);
}

}  // namespace elgen::cli
