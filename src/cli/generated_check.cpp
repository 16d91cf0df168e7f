// generated_check: files are compared byte by byte; the equations are left to `elgen diff`.
#include "cli/generated_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/files/orphans.hpp"
#include "elgen/wording.hpp"

namespace elgen::cli {

namespace {

std::string text_of(const GlobalOptions& global, const FileDifference& difference) {
  std::string words = difference.path;
  if (difference.state == FileState::edited) words += " (by hand)";
  if (difference.state == FileState::orphaned) words += ": " + difference.detail;
  std::string text = fmt::format("{:<13}{}\n", name_of(difference.state), words);
  if (global.verbose && difference.state != FileState::orphaned) text += difference.detail;
  return text;
}

std::string text_of(const GlobalOptions& global, const std::vector<FileDifference>& differences) {
  std::string text;
  for (const FileDifference& difference : differences) text += text_of(global, difference);
  return text;
}

Diagnostics diagnostics_of(const std::vector<FileDifference>& differences) {
  static std::vector<SourcePointer> files;  // spans point into them
  Diagnostics all;
  for (const FileDifference& difference : differences) {
    files.push_back(make_source(difference.path, existing_text(difference.path).value_or("")));
    const std::string reason =
        difference.state == FileState::orphaned ? ": " + difference.detail : std::string();
    all.push_back({Code::E715,
                   {files.back().get(), 0, 0},
                   fmt::format("{} is {}{}", in_backticks(difference.path),
                               name_of(difference.state), reason)});
  }
  return all;
}

/// All of them in one sentence, with the commands that repair them and that compare the equations.
ExitCode report_all(const GlobalOptions& global, const GeneratedSystems& systems,
                    const std::vector<FileDifference>& differences) {
  const auto is_orphan = [](const FileDifference& found) {
    return found.state == FileState::orphaned;
  };
  const bool is_written = !std::ranges::all_of(differences, is_orphan);
  const bool is_stale =
      std::ranges::count(differences, FileState::stale, &FileDifference::state) > 0;
  const ExitCode reported = report(
      global, {{Code::E715,
                {},
                fmt::format("{} {} not current", counted(differences.size(), "generated file"),
                            differences.size() == 1 ? "is" : "are"),
                is_written ? "to repair: " + systems.repair : ""}});
  if (is_stale && !systems.comparison.empty()) {
    tell(global, "to compare the equations: " + systems.comparison);
  }
  for (const FileDifference& found : differences) {
    if (is_orphan(found)) tell(global, "to repair: delete " + found.path);
  }
  return reported;
}

}  // namespace

ExitCode check_generated(const GlobalOptions& global, const GeneratedSystems& systems) {
  std::vector<FileDifference> differences = compare_files(systems.directory, systems.files);
  const auto left = orphans(systems.directory, systems.files, systems.sources);
  differences.insert(differences.end(), left.begin(), left.end());
  if (differences.empty()) {
    tell(global, "up to date");
    return ExitCode::success;
  }
  if (global.style.format != DiagnosticFormat::text) {
    return report(global, diagnostics_of(differences));
  }
  const ExitCode printed = print(global, text_of(global, differences));
  return std::max(printed, report_all(global, systems, differences));
}

}  // namespace elgen::cli
