// elgen generate: writes the emitted files. With --check, --list-outputs or --stdout, only prints.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "base/json.hpp"
#include "base/reason.hpp"
#include "cli/commands.hpp"
#include "cli/files/inputs.hpp"
#include "cli/files/output_files.hpp"
#include "cli/files/source_paths.hpp"
#include "cli/generated_check.hpp"
#include "cli/process/resources.hpp"
#include "cli/process/terminal.hpp"
#include "cli/shown_pipeline.hpp"
#include "elgen/artifacts.hpp"
#include "elgen/page.hpp"
#include "elgen/wording.hpp"

namespace elgen::cli {

namespace {

namespace fs = std::filesystem;

struct GenerateOptions {
  std::vector<std::string> inputs = {};
  std::string output_directory = "generated";
  bool output_directory_given = false;
  SceneOptions scene = {};
  bool check = false;
  bool force = false;
  bool list_outputs = false;
  bool to_stdout = false;
  std::string depfile = {};
};

/// One input with its sources and products.
struct Job {
  std::string path;
  PipelineSources inputs;
  Products products;

  [[nodiscard]] const Scene& scene() const { return products.checked->scene; }
};

/// Removes warnings and notes that were already reported: a scene repeats the notes of its model.
Diagnostics without_repetitions(Diagnostics diagnostics, std::set<std::string>& reported) {
  std::erase_if(diagnostics, [&reported](const Diagnostic& diagnostic) {
    const bool is_error = code_row(diagnostic.code).severity == Severity::error;
    return !is_error && !reported.insert(format({diagnostic}, {})).second;
  });
  return diagnostics;
}

/// Reads all inputs, runs the pipeline for each, and reports their diagnostics.
ExitCode run_jobs(const GlobalOptions& global, const GenerateOptions& options,
                  std::vector<Job>& jobs) {
  PipelineOptions pipeline = pipeline_options(global, {Goal::self_check});
  pipeline.scene = options.scene;
  if (options.list_outputs) pipeline.goals = {Goal::check};
  ExitCode worst = ExitCode::success;
  std::set<std::string> reported;
  for (const std::string& path : options.inputs) {
    Result<PipelineSources> inputs = read_inputs(path, global.limits);
    if (!inputs) {
      worst = std::max(worst, report(global, inputs.diagnostics));
      continue;
    }
    renew_time_limit(global.limits);
    if (!options.to_stdout) {
      pipeline.scene.paths = source_paths(*inputs, options.output_directory);
    }
    Job job{path, *inputs, run_pipeline_with_progress(path, *inputs, pipeline)};
    job.products.diagnostics = without_repetitions(std::move(job.products.diagnostics), reported);
    worst = std::max(worst, report_products(global, job.products));
    print_stage_times(global, job.products);
    jobs.push_back(std::move(job));
  }
  return worst;
}

/// E604 if two inputs would write the same files.
Diagnostics duplicate_name_errors(const std::vector<Job>& jobs) {
  Diagnostics errors;
  std::map<std::string, std::string> first;
  for (const Job& job : jobs) {
    const std::string& name = job.scene().base_name;
    const auto [entry, is_new] = first.emplace(name, job.path);
    if (is_new) continue;
    errors.push_back({Code::E604,
                      {},
                      fmt::format("`{}` and `{}` would both be written to `{}`", entry->second,
                                  job.path, name)});
  }
  return errors;
}

EmittedFiles all_files(const std::vector<Job>& jobs) {
  EmittedFiles all;
  for (const Job& job : jobs) {
    all.files.insert(job.products.files->files.begin(), job.products.files->files.end());
  }
  return all;
}

/// E607 if options would change files that were written by `generate` without these options.
Diagnostics option_change_errors(const GenerateOptions& options, const std::vector<Job>& jobs) {
  Diagnostics errors;
  for (const Job& job : jobs) {
    if (!job.scene().has_options || options.output_directory_given) continue;
    for (const OutputFile& file : to_output_files(options.output_directory, *job.products.files)) {
      if (read_existing_file(file.path).value_or(file.text) == file.text) continue;
      errors.push_back(
          {Code::E607,
           {},
           fmt::format("--outputs, --language, --fix or --size would change `{}`", file.path),
           "give `-o DIR`, or write a scene"});
    }
  }
  return errors;
}

/// The files of the job that were read: the model, and the scene if there is one.
std::vector<SourcePointer> sources_of(const Job& job) {
  std::vector<SourcePointer> sources{job.inputs.model, job.inputs.scene};
  std::erase_if(sources, [](const SourcePointer& source) {
    return source == nullptr || source->path == stdin_name;
  });
  return sources;
}

/// E714 if a source changed after it was read: builds would then keep the code of the old source.
Diagnostics changed_source_errors(const std::vector<Job>& jobs) {
  Diagnostics errors;
  for (const Job& job : jobs) {
    for (const SourcePointer& source : sources_of(job)) {
      if (read_existing_file(source->path).value_or(source->text) == source->text) continue;
      errors.push_back({Code::E714,
                        {},
                        fmt::format("`{}` has changed since it was read", source->path),
                        "nothing is written; generate again"});
    }
  }
  return errors;
}

/// The source that the existing file `file.path` states. None if the source is the input of `job`,
/// or can no longer generate files of the job's name.
std::optional<std::string> find_other_source(const GlobalOptions& global, const Job& job,
                                             const std::string& directory, const OutputFile& file) {
  const auto source =
      find_source_path(directory, stated_paths(read_existing_file(file.path).value_or("")));
  std::error_code error;
  const bool is_other = source && !fs::equivalent(*source, job.path, error);
  return is_other && may_have_name(global, *source, job.scene().base_name) ? source : std::nullopt;
}

/// E604 if the job would replace the files of another model or scene that has the same name.
Diagnostics occupied_name_errors(const GlobalOptions& global, const GenerateOptions& options,
                                 const std::vector<Job>& jobs) {
  Diagnostics errors;
  for (const Job& job : jobs) {
    for (const OutputFile& file : to_output_files(options.output_directory, *job.products.files)) {
      const auto other = find_other_source(global, job, options.output_directory, file);
      if (!other) continue;
      errors.push_back({Code::E604,
                        {},
                        fmt::format("`{}` was generated from `{}`, and `{}` has the same name",
                                    file.path, *other, job.path),
                        "rename one, give `-o DIR`, or replace the files with --force"});
      break;
    }
  }
  return errors;
}

/// The paths of a job's files, the header first, then in the order of artifacts.def.
std::vector<std::string> paths_of(const GenerateOptions& options, const Job& job) {
  std::vector<std::string> paths;
  for (const Artifact& artifact : requested_artifacts(job.scene())) {
    paths.push_back((fs::path(options.output_directory) / artifact.path).generic_string());
  }
  return paths;
}

/// The text of --depfile. The header is the first target, because Ninja expects the first output of
/// its rule.
std::string dependency_rules(const GenerateOptions& options, const std::vector<Job>& jobs) {
  std::string text;
  for (const Job& job : jobs) {
    std::string sources;
    for (const auto& source : sources_of(job)) sources += " " + escape_for_make(source->path);
    for (const std::string& path : paths_of(options, job)) {
      text += escape_for_make(path) + ":" + sources + "\n";
    }
  }
  return text;
}

std::vector<OutputFile> output_files(const GenerateOptions& options, const std::vector<Job>& jobs) {
  std::vector<OutputFile> files = to_output_files(options.output_directory, all_files(jobs));
  if (!options.depfile.empty()) {
    files.push_back(
        {options.depfile, dependency_rules(options, jobs), ReplacePolicy::dependencies});
  }
  return files;
}

/// The word; in single quotes if a shell needs quotes.
std::string quote_for_shell(const std::string& word) {
  constexpr const char* harmless =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,/:@%";
  if (!word.empty() && word.find_first_not_of(harmless) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

/// The command line without --check. If options change the files, the output directory is added,
/// unless the command line names a directory.
std::string repair_command(const GlobalOptions& global, const GenerateOptions& options) {
  std::string command = "elgen";
  for (std::size_t i = 1; i < global.words.size(); ++i) {
    if (global.words[i] != "--check") command += " " + quote_for_shell(global.words[i]);
  }
  if (options.scene.changes_files() && !options.output_directory_given) {
    command += " -o " + quote_for_shell(options.output_directory);
  }
  return command;
}

/// The command that compares the inputs with their committed versions; "" for standard input.
std::string comparison_command(const GenerateOptions& options) {
  if (std::ranges::count(options.inputs, "-") > 0) return {};
  std::string command = "elgen diff --against REV";
  for (const std::string& input : options.inputs) command += " " + quote_for_shell(input);
  return command;
}

ExitCode check_jobs(const GlobalOptions& global, const GenerateOptions& options,
                    const std::vector<Job>& jobs) {
  GeneratedSystems systems{options.output_directory, all_files(jobs)};
  systems.repair = repair_command(global, options);
  systems.comparison = comparison_command(options);
  for (const Job& job : jobs) systems.sources.push_back(job.scene().paths);
  return check_generated(global, systems);
}

/// Suggestions for a new user: the next commands.
std::string next_commands(const std::string& input) {
  const std::string steps = fmt::format("elgen show {} --what steps", input);
  const std::string outputs = fmt::format("elgen show {}", input);
  const std::string verify = fmt::format("elgen verify {}", input);
  const std::size_t width = steps.size();
  return fmt::format(
      "\nnext: {:<{}}  print all equations\n      {}  print their derivation\n"
      "      {:<{}}  compare all with 60 digits",
      outputs, width, steps, verify, width);
}

void report_files(const GlobalOptions& global, const GenerateOptions& options, const Job& job,
                  const std::vector<std::string>& written) {
  const auto& [model, scene] = *job.products.checked;
  if (global.verbose) {
    const auto page = model_page(model, scene, job.products.page_programs->program);
    print_message(global, overview(page, screen_of(stderr)));
  }
  for (const OutputFile& file : to_output_files(options.output_directory, *job.products.files)) {
    const bool is_new = std::find(written.begin(), written.end(), file.path) != written.end();
    print_message(global, (is_new ? "wrote " : "unchanged ") + printable_path(file.path));
  }
  const std::string checked = self_check_text(*job.products.self_check);
  const char* more = has_expectations(model, scene) ? "; `elgen verify` checks [[expect]]" : "";
  print_message(global, fmt::format("{}: {}{}", job.scene().base_name, checked, more));
  if (global.verbose) print_message(global, next_commands(job.path));
}

/// The paths in the order in which they are printed.
std::vector<std::string> sorted_paths_of(const GenerateOptions& options, const Job& job) {
  std::vector<std::string> paths = paths_of(options, job);
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// The job as JSON. `written`: the paths of all files that changed; null if files are only listed.
Json json_of(const GenerateOptions& options, const Job& job,
             const std::vector<std::string>* written) {
  Json sources = Json::array();
  for (const SourcePointer& source : sources_of(job)) sources.push_back(source->path);
  Json files = Json::array();
  for (const std::string& path : sorted_paths_of(options, job)) {
    Json file{{"path", path}};
    if (written != nullptr) file["written"] = std::ranges::count(*written, path) > 0;
    files.push_back(std::move(file));
  }
  Json json{{"name", job.scene().base_name},
            {"input", job.path},
            {"sources", std::move(sources)},
            {"files", std::move(files)}};
  if (written != nullptr) {
    json["self_check"] = self_check_text(*job.products.self_check);
  }
  return json;
}

std::string to_json(const GenerateOptions& options, const std::vector<Job>& jobs,
                    const std::vector<std::string>* written) {
  Json systems = Json::array();
  for (const Job& job : jobs) systems.push_back(json_of(options, job, written));
  return Json{{"systems", std::move(systems)}}.dump(2) + "\n";
}

ExitCode write_jobs(const GlobalOptions& global, const GenerateOptions& options,
                    const std::vector<Job>& jobs) {
  Diagnostics refusals = option_change_errors(options, jobs);
  if (refusals.empty()) refusals = changed_source_errors(jobs);
  if (refusals.empty() && !options.force) refusals = occupied_name_errors(global, options, jobs);
  if (!refusals.empty()) return report(global, refusals);
  const auto written =
      write_files(output_files(options, jobs), {options.force, global.limits.seconds});
  if (!written) return report(global, written.diagnostics);
  for (const Job& job : jobs) report_files(global, options, job, *written);
  return wants_json(global) ? print(global, to_json(options, jobs, &*written)) : ExitCode::success;
}

std::string path_list(const GenerateOptions& options, const std::vector<Job>& jobs) {
  std::string text;
  for (const Job& job : jobs) {
    for (const std::string& path : sorted_paths_of(options, job)) text += path + "\n";
  }
  return text;
}

std::string joined_headers(const std::vector<Job>& jobs) {
  std::string text;
  for (const Job& job : jobs)
    text += job.products.files->files.at(requested_artifacts(job.scene()).front().path);
  return text;
}

ExitCode generate(const GlobalOptions& global, const GenerateOptions& options) {
  if (options.to_stdout && wants_json(global)) {
    return report(global, {{Reason::not_as_json, {}, "a header is not printed as json"}});
  }
  std::vector<Job> jobs;
  const ExitCode worst = run_jobs(global, options, jobs);
  if (worst != ExitCode::success) return worst;
  if (!global.stop_after.empty() && !options.list_outputs) return worst;
  const Diagnostics duplicates = duplicate_name_errors(jobs);
  if (!duplicates.empty()) return report(global, duplicates);
  if (options.list_outputs) {
    return print(global,
                 wants_json(global) ? to_json(options, jobs, nullptr) : path_list(options, jobs));
  }
  if (options.to_stdout) return print(global, joined_headers(jobs));
  return options.check ? check_jobs(global, options, jobs) : write_jobs(global, options, jobs);
}

}  // namespace

void add_generate(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("generate", "derive the equations of models and scenes and write code");
  const auto options = std::make_shared<GenerateOptions>();
  command->add_option("inputs", options->inputs, "NAME.toml, NAME.scene.toml or - (stdin)")
      ->required();
  command
      ->add_option("-o,--output-directory", options->output_directory,
                   "folder of the written files")
      ->type_name("DIR")
      ->capture_default_str()
      ->each([options](const std::string&) { options->output_directory_given = true; });
  add_source_option(*command, "--outputs", "LIST", options->scene.outputs,
                    "write only these outputs: mass_matrix,bias,…");
  add_language_option(*command, options->scene.language);
  add_specialisation_options(*command, options->scene);
  CLI::Option* check = command->add_flag("--check", options->check,
                                         "write nothing; exit with 1 if the files differ");
  command->add_flag("--force", options->force, "also overwrite files that elgen did not generate");
  CLI::Option* list = command->add_flag("--list-outputs", options->list_outputs,
                                        "print the paths of the files and write nothing");
  CLI::Option* depfile =
      command
          ->add_option("--depfile", options->depfile,
                       "write the inputs of each file as rules for make and ninja")
          ->type_name("FILE");
  CLI::Option* to_stdout = command->add_flag("--stdout", options->to_stdout,
                                             "print the header instead of writing files");
  check->excludes(list)->excludes(to_stdout)->excludes(depfile);
  list->excludes(to_stdout)->excludes(depfile);
  to_stdout->excludes(depfile);
  set_action(*command, action, options, &generate);
}

}  // namespace elgen::cli
