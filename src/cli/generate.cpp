// elgen generate: inputs -> files, or what --check, --list-outputs and --stdout make of them.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "elgen/render.hpp"
#include "inputs.hpp"
#include "options.hpp"
#include "output_files.hpp"
#include "progress.hpp"
#include "resources.hpp"

namespace elgen::cli {

namespace {

namespace fs = std::filesystem;

/// One input on its way to its files.
struct Job {
  std::string path;
  Inputs inputs;
  Products products;

  [[nodiscard]] const Scene& scene() const { return products.checked->scene; }
};

PipelineOptions pipeline_options(const GlobalOptions& global, const GenerateOptions& options) {
  PipelineOptions pipeline;
  pipeline.scene = options.scene;
  pipeline.limits = global.limits;
  pipeline.dump_stage = global.dump_stage;
  pipeline.stop_after = options.list_outputs ? "check" : global.stop_after;
  return pipeline;
}

/// Reads and runs every input; diagnostics of all of them are reported.
ExitCode run(const GlobalOptions& global, const GenerateOptions& options, std::vector<Job>& jobs) {
  ExitCode worst = ExitCode::success;
  for (const std::string& path : options.inputs) {
    Result<Inputs> inputs = read_inputs(path, global.limits);
    if (!inputs) {
      worst = std::max(worst, report(global, inputs.diagnostics));
      continue;
    }
    renew_time_limit(global.limits);
    Job job{path, *inputs, run_shown(path, *inputs, pipeline_options(global, options))};
    worst = std::max(worst, print(global, job.products.dump));
    worst = std::max(worst, report(global, job.products.diagnostics));
    tell_times(global, job.products);
    jobs.push_back(std::move(job));
  }
  return worst;
}

/// E604: two inputs would write the same files.
Diagnostics duplicate_names(const std::vector<Job>& jobs) {
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

/// E607: options would change files that belong to the model or scene itself.
Diagnostics changed_by_options(const GenerateOptions& options, const std::vector<Job>& jobs) {
  Diagnostics errors;
  for (const Job& job : jobs) {
    if (!job.scene().has_options || options.output_directory_given) continue;
    for (const auto& [name, text] : job.products.files->files) {
      const fs::path path = fs::path(options.output_directory) / name;
      std::error_code error;
      if (!fs::exists(path, error)) continue;
      std::ifstream file(path, std::ios::binary);
      const std::string old{std::istreambuf_iterator<char>(file), {}};
      if (old == text) continue;
      errors.push_back({Code::E607,
                        {},
                        fmt::format("--outputs, --fix or --size would change `{}`", path.string()),
                        "give `-o DIR`, or write a scene"});
    }
  }
  return errors;
}

std::string escaped(const std::string& path) {
  std::string text;
  for (const char c : path) text += c == ' ' ? "\\ " : c == '$' ? "$$" : std::string(1, c);
  return text;
}

/// The file --depfile asks for, if it does.
std::vector<PlainFile> depfile(const GenerateOptions& options, const std::vector<Job>& jobs) {
  if (options.depfile.empty()) return {};
  std::string text;
  for (const Job& job : jobs) {
    for (const auto& [name, content] : job.products.files->files) {
      text += escaped((fs::path(options.output_directory) / name).generic_string()) + ":";
      text += " " + escaped(job.inputs.model->path);
      if (job.inputs.scene != nullptr) text += " " + escaped(job.inputs.scene->path);
      text += '\n';
    }
  }
  return {{options.depfile, text}};
}

ExitCode check(const GlobalOptions& global, const GenerateOptions& options,
               const std::vector<Job>& jobs) {
  const Differences differences = compare_files(options.output_directory, all_files(jobs));
  if (differences.text.empty()) {
    tell(global, "up to date");
    return ExitCode::success;
  }
  const ExitCode printed = print(global, differences.text);
  if (differences.is_stale) tell(global, "to repair: " + options.repair_command);
  for (const std::string& path : differences.orphans) tell(global, "to repair: delete " + path);
  return std::max(printed, ExitCode::differs);
}

ExitCode write(const GlobalOptions& global, const GenerateOptions& options,
               const std::vector<Job>& jobs) {
  Diagnostics errors = changed_by_options(options, jobs);
  if (errors.empty()) {
    errors = write_files(options.output_directory, all_files(jobs), options.force,
                         depfile(options, jobs));
  }
  if (has_errors(errors)) return report(global, errors);
  for (const Job& job : jobs) {
    for (const auto& [name, text] : job.products.files->files) {
      tell(global, "wrote " + (fs::path(options.output_directory) / name).generic_string());
    }
    if (global.verbose) {
      tell(global, "\n" + text_page(job.products.checked->model, job.products.checked->scene,
                                    *job.products.program));
    }
    tell(global, fmt::format("{}: {}; {}", job.scene().base_name, receipt(*job.products.readback),
                             receipt(*job.products.self_check)));
  }
  return ExitCode::success;
}

std::string listed(const GenerateOptions& options, const std::vector<Job>& jobs) {
  std::string text;
  for (const Job& job : jobs) {
    for (const std::string& name : emitted_paths(job.scene())) {
      text += (fs::path(options.output_directory) / name).generic_string() + "\n";
    }
  }
  return text;
}

std::string headers(const std::vector<Job>& jobs) {
  std::string text;
  for (const Job& job : jobs) text += job.products.files->files.at(header_path(job.scene()));
  return text;
}

}  // namespace

ExitCode generate(const GlobalOptions& global, const GenerateOptions& options) {
  std::vector<Job> jobs;
  const ExitCode worst = run(global, options, jobs);
  if (worst != ExitCode::success) return worst;
  if (!global.stop_after.empty() && !options.list_outputs) return worst;
  const Diagnostics duplicates = duplicate_names(jobs);
  if (!duplicates.empty()) return report(global, duplicates);
  if (options.list_outputs) return print(global, listed(options, jobs));
  if (options.to_stdout) return print(global, headers(jobs));
  return options.check ? check(global, options, jobs) : write(global, options, jobs);
}

}  // namespace elgen::cli
