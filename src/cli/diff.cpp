// elgen diff: compares the equations of models and scenes in two folders or two files.
#include "elgen/diff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "base/reason.hpp"
#include "cli/commands.hpp"
#include "cli/compared_versions.hpp"
#include "elgen/wording.hpp"

namespace elgen::cli {

namespace {

struct DiffOptions {
  std::vector<std::string> inputs = {};
  std::string revision = {};  ///< revision of git; empty: `inputs` has two paths
  std::string allowed = "equal";
  std::vector<std::string> renames = {};
  std::vector<std::string> only = {};
  std::string format = {};  ///< empty: follows the global --format
  bool lists_all = false;
  bool strict = false;  ///< undecided entries count as different
};

struct DiffFormat {
  std::string_view name;
  std::string (*text)(const DiffReport& report, const DiffOptions& options);
  bool shows_errors = false;  ///< the output contains the errors of systems that cannot be compared
};

constexpr std::array formats{
    DiffFormat{"text",
               [](const DiffReport& report, const DiffOptions& options) {
                 return to_text(report, options.lists_all);
               }},
    DiffFormat{"json",
               [](const DiffReport& report, const DiffOptions&) { return to_json(report); }},
    DiffFormat{"markdown",
               [](const DiffReport& report, const DiffOptions&) { return to_markdown(report); }},
    DiffFormat{"github",
               [](const DiffReport& report, const DiffOptions&) { return to_annotations(report); },
               true}};

const DiffFormat& output_format(const GlobalOptions& global, const DiffOptions& options) {
  const std::string_view name =
      options.format.empty() ? format_row(global.style.format).word : options.format;
  return *std::ranges::find(formats, name, &DiffFormat::name);
}

/// The renames that the texts OLD=NEW state. E913 if a text lacks "=", OLD or NEW.
Result<Renames> parse_renames(const std::vector<std::string>& texts) {
  Renames renames;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const bool is_pair = equals != std::string::npos && equals > 0 && equals + 1 < text.size();
    if (!is_pair) {
      return Diagnostic{
          Reason::no_rename, {}, fmt::format("{} is no rename", quote_text(text)), "write OLD=NEW"};
    }
    renames.emplace(text.substr(0, equals), text.substr(equals + 1));
  }
  return renames;
}

/// E913 for each name in --only that is an output of neither version. No error if no system has
/// changes.
Diagnostics unknown_output_errors(const DiffReport& report, const DiffOptions& options) {
  std::set<std::string> known;
  for (const SystemChange& system : report.systems) {
    for (const OutputChange& output : system.outputs) known.insert(output.name);
  }
  Diagnostics errors;
  const bool are_compared = std::ranges::any_of(report.systems, has_changes);
  for (const std::string& name : options.only) {
    if (!are_compared || known.count(name) > 0) continue;
    errors.push_back({Reason::unknown_changed_output,
                      {},
                      fmt::format("no version has an output {}", quote_text(name))});
  }
  return errors;
}

ExitCode run_diff(const GlobalOptions& given, const DiffOptions& options) {
  GlobalOptions global = given;
  for (const DiagnosticFormatRow& row : diagnostic_formats()) {
    if (row.word == options.format) global.style.format = row.format;
  }
  const DiffFormat& format = output_format(global, options);
  if (options.revision.empty() && options.inputs.size() != 2) {
    return report(global, {{Reason::compares_two,
                            {},
                            fmt::format("`diff` compares two, not {}", options.inputs.size()),
                            "write OLD NEW, or --against REV"}});
  }
  const Result<Renames> renames = parse_renames(options.renames);
  if (!renames) return report(global, renames.diagnostics);
  const CompareOptions comparing{
      *renames, {options.only.begin(), options.only.end()}, options.strict};
  const Result<DiffReport> found =
      options.revision.empty()
          ? compare_paths(options.inputs.front(), options.inputs.back(), comparing, global.limits)
          : compare_with_revision(options.revision, options.inputs, comparing, global.limits);
  if (!found) return report(global, found.diagnostics);
  const bool is_whole = !has_errors(found.diagnostics);
  const Diagnostics unknown = unknown_output_errors(*found, options);
  if (is_whole && !unknown.empty()) return report(global, unknown);
  if (!is_whole && !format.shows_errors) report(global, found.diagnostics);
  const ExitCode printed = print(global, format.text(*found, options));
  const bool is_allowed = impact_of(*found) <= *find_impact(options.allowed);
  return std::max(
      {exit_code(found.diagnostics), printed, is_allowed ? ExitCode::success : ExitCode::differs});
}

}  // namespace

void add_diff(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("diff", "compare the equations of two versions");
  const auto options = std::make_shared<DiffOptions>();
  command->add_option("inputs", options->inputs,
                      "OLD NEW: models, scenes, folders with them, or - (stdin)");
  command->add_option("--against", options->revision, "compare the inputs with this git revision")
      ->type_name("REV");
  command
      ->add_option("--allow", options->allowed,
                   "worst change with exit code 0: equal, values, extended, different or breaks")
      ->type_name("CHANGE")
      ->check(CLI::IsMember({"equal", "values", "extended", "different", "breaks"}));
  command->add_option("--rename", options->renames, "OLD has the name NEW in the new version")
      ->type_name("OLD=NEW")
      ->allow_extra_args(false);
  command->add_option("--only", options->only, "report only these outputs")
      ->type_name("OUTPUTS")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_flag(
      "--strict", options->strict,
      "count entries as different if they are equal at 64 points but not proved equal");
  command->add_flag("--list", options->lists_all, "list every key and every entry");
  command
      ->add_option("--format", options->format,
                   "text, json, markdown (for comments on pull requests) or github (annotations)")
      ->check(CLI::IsMember(column_words(formats, &DiffFormat::name)));
  set_action(*command, action, options, &run_diff);
}

}  // namespace elgen::cli
