// elgen verify: prints a certificate for each input, and also writes it to the file of -o.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "base/reason.hpp"
#include "cli/commands.hpp"
#include "cli/files/inputs.hpp"
#include "cli/options.hpp"
#include "cli/process/resources.hpp"
#include "cli/process/terminal.hpp"
#include "cli/shown_pipeline.hpp"
#include "elgen/certificate.hpp"
#include "elgen/foreign.hpp"
#include "elgen/page.hpp"
#include "elgen/tradeoff.hpp"
#include "elgen/wording.hpp"

namespace elgen::cli {
namespace {

/// A word of --build, and the build that the word selects.
struct BuildWord {
  std::string_view word;
  BuildFlags build;
};
constexpr std::array<BuildWord, 3> build_words{{{"written", BuildFlags::as_written},
                                                {"native", BuildFlags::native},
                                                {"users", BuildFlags::user_flags}}};

struct VerifyCommandOptions {
  std::vector<std::string> inputs = {};
  VerifyOptions verify = {};  ///< verify_compiled() sets forms, claims and on_step
  std::vector<BuildFlags> builds = {BuildFlags::as_written, BuildFlags::native,
                                    BuildFlags::user_flags};
  bool strict = false;     ///< a skipped check counts as failed
  FileOption output = {};  ///< for the certificates
  std::optional<LanguageId> language = {};
  ForeignOptions foreign = {};  ///< no claims: no foreign code is checked
};

/// The certificate with every check, as -o writes it.
std::string full_text(const GlobalOptions& global, const Certificate& certificate) {
  return wants_json(global) ? to_json(certificate) : to_full_text(certificate);
}

/// The certificate in the form that -q, -v, --format and the options select.
std::string certificate_text(const GlobalOptions& global, const VerifyCommandOptions& options,
                             const Certificate& certificate) {
  if (wants_json(global)) return to_json(certificate);
  if (global.quiet) return verdict_line(certificate);
  const bool is_full =
      global.verbose || options.verify.only_expectations || !options.foreign.claims.empty();
  return is_full ? to_full_text(certificate, options.verify.only_expectations)
                 : to_text(certificate);
}

ExitCode exit_code(const Certificate& certificate, bool strict) {
  const bool is_decided = !strict || count_rows(certificate, Verdict::skipped) == 0;
  return holds(certificate) && is_decided ? ExitCode::success : ExitCode::differs;
}

template <class Step>
auto run_timed(const std::string& name, Products& products, const Progress& progress,
               const Step& step) {
  progress.show_stage(name);
  const auto start = std::chrono::steady_clock::now();
  auto result = step();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  products.times.push_back({name, elapsed.count()});
  return result;
}

/// One header without code and with the reason `late`. All checks of code are then skipped, because
/// a slow compiler is no fault of the model.
CompiledHeaders skipped_header(const Diagnostic& late) {
  CompiledHeaders headers(1);
  headers.front().failure_reason = late.message + "; " + late.hint;
  return headers;
}

/// Compiles the emitted code in each build of options.builds; nothing with --quick or --only.
Result<CompiledHeaders> compile_builds(Products& products, const VerifyCommandOptions& options,
                                       const Limits& limits, const Progress& progress) {
  if (options.verify.is_quick || options.verify.only_expectations) return CompiledHeaders();
  const auto& [model, scene] = *products.checked;
  const CompileOptions all{limits, options.builds, true};
  return run_timed("compile", products, progress, [&, &model = model, &scene = scene] {
    Result<CompiledHeaders> compiled =
        compile(*products.files, model, scene, *products.program, all);
    const bool is_late = !compiled && compiled.diagnostics.front().code == Code::E909;
    if (is_late) return Result<CompiledHeaders>(skipped_header(compiled.diagnostics.front()));
    return compiled;
  });
}

/// The certificate rows for `max_error`. If the scene expands the model, derives the exact model
/// for the comparison.
Result<std::vector<CertificateRow>> check_error_bounds(const PipelineSources& inputs,
                                                       const Products& products,
                                                       const CompiledHeaders& compiled,
                                                       const VerifyOptions& options,
                                                       const Limits& limits) {
  const CheckedModel& checked = *products.checked;
  renew_time_limit(limits);
  const bool has_error_bound = checked.scene.numerics.max_error && !compiled.empty();
  if (!has_error_bound || !checked.model.approximation) {
    return check_max_error(checked, *products.program, compiled, options);
  }
  PipelineOptions pipeline{.limits = limits, .goals = {Goal::choose}};
  pipeline.scene.purpose = purpose::verify_expansion;
  const Products exact = run_pipeline(inputs, pipeline);
  if (!exact.program) return exact.diagnostics;
  return check_max_error(*exact.checked, *exact.program, compiled, options);
}

/// Compiles the code and verifies the products. Shows every step, and appends its time to
/// products.times. E913 for `--only expect` without [[expect]].
Result<Verification> verify_compiled(const std::string& path, const PipelineSources& inputs,
                                     Products& products, const VerifyCommandOptions& options,
                                     const Limits& limits) {
  const Progress progress(path);
  const auto compiled = compile_builds(products, options, limits, progress);
  if (!compiled) return compiled.diagnostics;
  VerifyOptions verification = options.verify;
  verification.forms = &*products.closed_forms;
  if (products.claims) verification.equilibrium_verdicts = &*products.claims;
  verification.on_step = [&progress](const std::string& step) { progress.show_stage(step); };
  const auto& [model, scene] = *products.checked;
  Verification result =
      run_timed("verify", products, progress, [&, &model = model, &scene = scene] {
        return verify(model, scene, *products.program, *compiled, verification);
      });
  const auto more = run_timed("search", products, progress, [&] {
    return check_error_bounds(inputs, products, *compiled, verification, limits);
  });
  if (!more) return more.diagnostics;
  std::vector<CertificateRow>& rows = result.certificate.rows;
  rows.insert(rows.end(), more->begin(), more->end());
  if (!rows.empty() || !verification.only_expectations) return result;
  return Diagnostic{Reason::nothing_expected,
                    {},
                    quote_text(path) + " has no `[[expect]]` to check",
                    "`[[expect]]` describes the model: a scene that changes the model skips it"};
}

/// Compares foreign code with the oracle; no equations are derived.
Result<Verification> judge_foreign_code(const std::string& path, Products& products,
                                        const VerifyCommandOptions& options, const Limits& limits) {
  ForeignOptions foreign = options.foreign;
  foreign.seed = options.verify.seed;
  foreign.states = options.verify.samples.value_or(foreign.states);
  foreign.seconds = limits.seconds;
  return run_timed("judge", products, Progress(path),
                   [&] { return compare_foreign_code(*products.checked, foreign); });
}

/// Prints the certificate of an input, and appends its full text to `certificates`; nothing is
/// appended if the input has errors.
ExitCode verify_input(const GlobalOptions& global, const VerifyCommandOptions& options,
                      const PipelineSources& inputs, std::vector<std::string>& certificates) {
  const std::string& path = (inputs.scene != nullptr ? inputs.scene : inputs.model)->path;
  const bool is_foreign = !options.foreign.claims.empty();
  const Goal last = options.verify.is_quick ? Goal::typeset : Goal::emit;
  PipelineOptions pipeline = pipeline_options(global, {last, Goal::claims});
  if (is_foreign) pipeline = pipeline_options(global, {Goal::check});
  if (options.verify.only_expectations) pipeline = pipeline_options(global, {Goal::choose});
  for (const ForeignClaim& claim : options.foreign.claims) {
    pipeline.scene.outputs.push_back(make_source("command line", claim.output));
  }
  pipeline.scene.purpose = purpose::verify;
  pipeline.scene.language = options.language;
  Products products = run_pipeline_with_progress(path, inputs, pipeline);
  const ExitCode generated = report_products(global, products);
  if (generated != ExitCode::success || !global.stop_after.empty()) {
    print_stage_times(global, products);
    return generated;
  }
  if (global.verbose && products.page_programs) {
    const auto& [model, scene] = *products.checked;
    print_message(global, overview(model_page(model, scene, products.page_programs->program),
                                   screen_of(stderr)));
  }
  const auto verification = is_foreign
                                ? judge_foreign_code(path, products, options, global.limits)
                                : verify_compiled(path, inputs, products, options, global.limits);
  print_stage_times(global, products);
  if (!verification) return report(global, verification.diagnostics);
  const Certificate& certificate = verification->certificate;
  certificates.push_back(full_text(global, certificate));
  const ExitCode printed = print(global, certificate_text(global, options, certificate));
  const ExitCode judged = std::max(printed, exit_code(certificate, options.strict));
  // The full certificate of foreign code has the text of each error.
  const bool is_reported =
      is_foreign && !global.quiet && global.style.format == DiagnosticFormat::text;
  return is_reported ? judged : std::max(judged, report(global, verification->diagnostics));
}

ExitCode verify_inputs(const GlobalOptions& global, const VerifyCommandOptions& options) {
  ExitCode worst = ExitCode::success;
  std::vector<std::string> certificates;
  for (const std::string& path : options.inputs) {
    renew_time_limit(global.limits);
    const Result<PipelineSources> inputs = read_inputs(path, global.limits);
    const ExitCode found = inputs ? verify_input(global, options, *inputs, certificates)
                                  : report(global, inputs.diagnostics);
    worst = std::max(worst, found);
  }
  // A file without the certificates of some inputs would look complete.
  if (options.output.file.empty() || certificates.size() != options.inputs.size()) return worst;
  std::string all;
  for (const std::string& certificate : certificates) all += certificate;
  return std::max(worst, report(global, write_output(global, options.output, all).diagnostics));
}

ExitCode run_verify(const GlobalOptions& global, const VerifyCommandOptions& options) {
  const Diagnostics refused = check_output_path(options.output);
  return refused.empty() ? verify_inputs(global, options) : report(global, refused);
}

/// Adds the options for the number and the seed of states, and for the number of processes.
void add_state_options(CLI::App& command, VerifyOptions& verify) {
  constexpr unsigned most_jobs = 512;
  verify.jobs = std::clamp(std::thread::hardware_concurrency(), 1U, most_jobs);
  command
      .add_option("--samples", verify.samples,
                  "states per output (default: 256, fewer for long programs)")
      ->check(number_error)
      ->check(CLI::PositiveNumber);
  command.add_option("--seed", verify.seed, "seed of the random states (default: 1)")
      ->check(number_error);
  command.add_option("--jobs", verify.jobs, "number of processes (default: number of cores)")
      ->check(CLI::Range(1U, most_jobs));
}

/// Adds --build.
void add_build_option(CLI::App& command, std::vector<BuildFlags>& builds) {
  const auto set = [&builds](const std::string& word) {
    builds = {std::ranges::find(build_words, word, &BuildWord::word)->build};
  };
  CLI::Option* const build = command.add_option_function<std::string>(
      "--build", set, "compile C++ and C99 only in this way (default: all three ways)");
  build->check(CLI::IsMember(column_words(build_words, &BuildWord::word)))->type_name("BUILD");
  build->excludes(command.get_option("--quick"));
}

/// Adds --only.
void add_only_option(CLI::App& command, VerifyOptions& verify) {
  const auto set = [&verify](const std::string&) { verify.only_expectations = true; };
  CLI::Option* const only = command.add_option_function<std::string>(
      "--only", set, "expect: check [[expect]] and nothing else; compile no code");
  only->check(CLI::IsMember(std::vector<std::string>{"expect"}))->type_name("PART");
  for (const char* const other :
       {"--samples", "--jobs", "--extremes", "--quick", "--build", "--foreign"}) {
    only->excludes(command.get_option(other));
  }
}

/// The claim in "OUTPUT.FIELD=NAME", such as "linearization.B=my_B". By default NAME is the text
/// before "=".
ForeignClaim claim_of(const std::string& text) {
  const std::string claimed = text.substr(0, text.find('='));
  const std::string output = claimed.substr(0, claimed.find('.'));
  const std::string field = claimed.substr(std::min(output.size() + 1, claimed.size()));
  return {output, field,
          claimed.size() + 1 < text.size() ? text.substr(claimed.size() + 1) : claimed};
}

void add_foreign_options(CLI::App& command, ForeignOptions& foreign) {
  const auto add_claims = [&foreign](const std::vector<std::string>& texts) {
    for (const std::string& text : texts) foreign.claims.push_back(claim_of(text));
  };
  CLI::Option* const code = command.add_option(
      "--foreign", foreign.code,
      "check code of other origin: a shared library, or a command that answers line by line");
  code->type_name("CODE");
  CLI::Option* const function = command.add_option_function<std::vector<std::string>>(
      "--function", add_claims,
      "output or field that the function NAME of the other code computes");
  function->type_name("OUTPUT[.FIELD][=NAME]")->allow_extra_args(false)->needs(code);
  code->needs(function);
  const auto refused_nan = [](const std::string& word) {
    const bool is_nan = CLI::detail::to_lower(word).find("nan") != std::string::npos;
    return is_nan ? quote_text(word) + " is no number" : "";
  };
  command
      .add_option("--tolerance", foreign.tolerance,
                  "allowed error, relative to the largest entry (default: 1e-9)")
      ->check(CLI::PositiveNumber)
      ->check(refused_nan)
      ->needs(code);
  for (const char* const other : {"--extremes", "--quick", "--build", "--jobs"}) {
    code->excludes(command.get_option(other));
  }
}

}  // namespace

void add_verify(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("verify", "check models against 60-digit arithmetic");
  const auto options = std::make_shared<VerifyCommandOptions>();
  command->add_option("inputs", options->inputs, "NAME.toml, NAME.scene.toml or - (stdin)")
      ->required();
  add_state_options(*command, options->verify);
  command->add_flag("--extremes", options->verify.checks_extremes,
                    "also measure lost digits outside the declared ranges");
  command->add_flag("--quick", options->verify.is_quick,
                    "few states, random projections instead of all entries, no compiler");
  add_build_option(*command, options->builds);
  add_language_option(*command, options->language);
  add_foreign_options(*command, options->foreign);
  add_only_option(*command, options->verify);
  command->add_flag("--strict", options->strict, "exit with 1 if a check is skipped");
  add_file_options(*command, options->output, "also write the certificates to FILE");
  set_action(*command, action, options, &run_verify);
}

}  // namespace elgen::cli
