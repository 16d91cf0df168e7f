// elgen diff: models and scenes of two folders, or two files, as mathematics.
#include "elgen/diff.hpp"

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/compared_versions.hpp"
#include "elgen/wording.hpp"

namespace elgen::cli {

namespace {

struct DiffOptions {
  std::vector<std::string> inputs = {};
  std::string revision = {};  ///< of git; empty: there are two inputs
  std::string allowed = "text";
  std::vector<std::string> renames = {};
  std::string format = "text";
  bool lists_all = false;
};

/// "old=new"
Result<Renames> renames_of(const std::vector<std::string>& texts) {
  Renames renames;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const bool is_pair = equals != std::string::npos && equals > 0 && equals + 1 < text.size();
    if (!is_pair) {
      return Diagnostic{
          Code::E913, {}, fmt::format("{} is no rename", elgen::quoted(text)), "write OLD=NEW"};
    }
    renames.emplace(text.substr(0, equals), text.substr(equals + 1));
  }
  return renames;
}

ExitCode diff(const GlobalOptions& given, const DiffOptions& options) {
  GlobalOptions global = given;
  if (options.format == "json") global.style.format = DiagnosticFormat::json;
  if (options.revision.empty() && options.inputs.size() != 2) {
    return report(global, {{Code::E913,
                            {},
                            fmt::format("`diff` compares two, not {}", options.inputs.size()),
                            "write OLD NEW, or --against REV"}});
  }
  const Result<Renames> renames = renames_of(options.renames);
  if (!renames) return report(global, renames.diagnostics);
  Result<DiffReport> found =
      options.revision.empty()
          ? compared_paths(options.inputs.front(), options.inputs.back(), *renames, global.limits)
          : compared_with_revision(options.revision, options.inputs, *renames, global.limits);
  if (!found) return report(global, found.diagnostics);
  ExitCode worst = report(global, found.diagnostics);
  worst =
      std::max(worst, print(global, options.format == "json" ? to_json(*found)
                                                             : to_text(*found, options.lists_all)));
  const bool is_allowed =
      options.allowed == "all" || impact_of(*found) <= *find_impact(options.allowed);
  return std::max(worst, is_allowed ? ExitCode::success : ExitCode::differs);
}

}  // namespace

void add_diff(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("diff", "compare the equations of two versions");
  const auto options = std::make_shared<DiffOptions>();
  command->add_option("inputs", options->inputs, "OLD NEW: models, scenes or folders of them");
  command
      ->add_option("--against", options->revision,
                   "compare files and folders with this revision of git")
      ->type_name("REV");
  command
      ->add_option("--allow", options->allowed,
                   "worst change that exits with 0: text, equal, values, assumptions, extended, "
                   "different or all")
      ->type_name("CHANGE")
      ->check(CLI::IsMember(
          {"text", "equal", "values", "assumptions", "extended", "different", "all"}));
  command->add_option("--rename", options->renames, "a name that was given to the same thing")
      ->type_name("OLD=NEW")
      ->allow_extra_args(false);
  command->add_flag("--list", options->lists_all, "list every key and every entry");
  command->add_option("--format", options->format, "text or json")
      ->check(CLI::IsMember({"text", "json"}));
  set_action(*command, action, options, &diff);
}

}  // namespace elgen::cli
