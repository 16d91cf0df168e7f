// generated_check: compares files byte by byte, in contrast to `elgen diff`, which compares
// equations. The sidecar of a folder states the sources of its files. A generated file is an orphan
// if no input generates it now.
#include "cli/generated_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "cli/files/output_files.hpp"
#include "cli/files/source_paths.hpp"
#include "elgen/scene.hpp"
#include "elgen/wording.hpp"

namespace elgen::cli {
namespace {

namespace fs = std::filesystem;

/// The paths in a folder, sorted by name.
std::vector<fs::path> sorted_entries(const fs::path& folder) {
  std::vector<fs::path> all;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) all.push_back(entry.path());
  std::ranges::sort(all);
  return all;
}

bool has_same_sources(const SourcePaths& x, const SourcePaths& y) {
  return x.model == y.model && x.scene == y.scene;
}

class OrphanSearch {
 public:
  OrphanSearch(const std::string& directory, const EmittedFiles& files,
               const std::vector<SourcePaths>& sources)
      : directory_(directory), sources_(sources) {
    for (const OutputFile& file : to_output_files(directory, files)) {
      written_.insert(fs::path(file.path).lexically_normal());
      folders_.insert(fs::path(file.path).lexically_normal().parent_path());
    }
  }

  std::vector<FileDifference> operator()() {
    for (const fs::path& folder : folders_) add_orphans(folder, "no input generates it");
    for (const fs::path& folder : sorted_entries(directory_)) {
      std::error_code error;
      const bool is_other =
          fs::is_directory(folder, error) && folders_.count(folder.lexically_normal()) == 0;
      if (!is_other) continue;
      if (const std::string reason = orphan_reason(folder); !reason.empty())
        add_orphans(folder, reason);
    }
    return std::move(found_);
  }

 private:
  void add_orphans(const fs::path& folder, const std::string& reason) {
    for (const fs::path& path : sorted_entries(folder)) {
      const bool is_ours =
          written_.count(path.lexically_normal()) == 0 && has_generated_marker(path.string());
      if (is_ours) found_.push_back({FileState::orphaned, path.generic_string(), reason});
    }
  }

  /// The reason why no input generates the files of the folder; "" if an input generates the files,
  /// or if the sources are unknown.
  std::string orphan_reason(const fs::path& folder) const {
    for (const fs::path& path : sorted_entries(folder)) {
      if (!path.filename().string().ends_with(sidecar_ending)) continue;
      const SourcePaths stated = stated_paths(read_existing_file(path.string()).value_or(""));
      const auto file = find_source_path(directory_, stated);
      if (!file) return {};
      std::error_code error;
      if (!fs::exists(*file, error)) return fmt::format("{} does not exist", *file);
      const bool is_renamed = std::ranges::any_of(sources_, [&stated](const SourcePaths& paths) {
        return has_same_sources(paths, stated);
      });
      return is_renamed ? fmt::format("{} is now generated under another name", *file) : "";
    }
    return {};
  }

  const std::string& directory_;
  const std::vector<SourcePaths>& sources_;
  std::set<fs::path> written_ = {};
  std::set<fs::path> folders_ = {};
  std::vector<FileDifference> found_ = {};
};

/// Finds orphans: generated files that no input generates now. In the folders of `files`, all
/// generated files except `files` are orphans. In another folder below `directory`, all generated
/// files are orphans if the source that the sidecar names does not exist, or is one of `sources`.
/// In the second case this source now generates files of another name.
std::vector<FileDifference> find_orphans(const std::string& directory, const EmittedFiles& files,
                                         const std::vector<SourcePaths>& sources) {
  return OrphanSearch(directory, files, sources)();
}

std::string difference_text(const GlobalOptions& global, const FileDifference& difference) {
  std::string words = difference.path;
  if (difference.state == FileState::edited) words += " (by hand)";
  if (difference.state == FileState::orphaned) words += ": " + difference.detail;
  std::string text = fmt::format("{:<13}{}\n", name_of(difference.state), words);
  if (global.verbose && difference.state != FileState::orphaned) text += difference.detail;
  return text;
}

std::string difference_text(const GlobalOptions& global,
                            const std::vector<FileDifference>& differences) {
  std::string text;
  for (const FileDifference& difference : differences) text += difference_text(global, difference);
  return text;
}

Diagnostics diagnostics_of(const std::vector<FileDifference>& differences) {
  Diagnostics all;
  for (const FileDifference& difference : differences) {
    const SourcePointer file =
        make_permanent_source(difference.path, read_existing_file(difference.path).value_or(""));
    const std::string reason =
        difference.state == FileState::orphaned ? ": " + difference.detail : std::string();
    all.push_back({Code::E715,
                   {file.get(), 0, 0},
                   fmt::format("{} is {}{}", quote_text(difference.path), name_of(difference.state),
                               reason)});
  }
  return all;
}

/// Reports one error for all files, with the commands that repair them and the command that
/// compares the equations.
ExitCode report_repairs(const GlobalOptions& global, const GeneratedSystems& systems,
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
                fmt::format("{} {} not current", count_text(differences.size(), "generated file"),
                            differences.size() == 1 ? "is" : "are"),
                is_written ? "to repair: " + systems.repair : ""}});
  if (is_stale && !systems.comparison.empty()) {
    print_message(global, "to compare the equations: " + systems.comparison);
  }
  for (const FileDifference& found : differences) {
    if (is_orphan(found)) print_message(global, "to repair: delete " + printable_path(found.path));
  }
  return reported;
}

}  // namespace

ExitCode check_generated(const GlobalOptions& global, const GeneratedSystems& systems) {
  std::vector<FileDifference> differences = compare_files(systems.directory, systems.files);
  const auto left = find_orphans(systems.directory, systems.files, systems.sources);
  differences.insert(differences.end(), left.begin(), left.end());
  if (differences.empty()) {
    print_message(global, "up to date");
    return ExitCode::success;
  }
  if (global.style.format != DiagnosticFormat::text) {
    return report(global, diagnostics_of(differences));
  }
  const ExitCode printed = print(global, difference_text(global, differences));
  return std::max(printed, report_repairs(global, systems, differences));
}

}  // namespace elgen::cli
