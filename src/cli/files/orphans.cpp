// orphans: sidecars say what their folders were made from.
#include "cli/files/orphans.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "cli/files/source_paths.hpp"

namespace elgen::cli {

namespace {

namespace fs = std::filesystem;

/// In the order of their names.
std::vector<fs::path> entries_in(const fs::path& folder) {
  std::vector<fs::path> all;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) all.push_back(entry.path());
  std::ranges::sort(all);
  return all;
}

bool same_sources(const SourcePaths& x, const SourcePaths& y) {
  return x.model == y.model && x.scene == y.scene;
}

class OrphanSearch {
 public:
  OrphanSearch(const std::string& directory, const EmittedFiles& files,
               const std::vector<SourcePaths>& sources)
      : directory_(directory), sources_(sources) {
    for (const OutputFile& file : files_in(directory, files)) {
      written_.insert(fs::path(file.path).lexically_normal());
      folders_.insert(fs::path(file.path).lexically_normal().parent_path());
    }
  }

  std::vector<FileDifference> operator()() {
    for (const fs::path& folder : folders_) add(folder, "nothing generates it");
    for (const fs::path& folder : entries_in(directory_)) {
      std::error_code error;
      const bool is_other =
          fs::is_directory(folder, error) && folders_.count(folder.lexically_normal()) == 0;
      if (!is_other) continue;
      if (const std::string reason = reason_of(folder); !reason.empty()) add(folder, reason);
    }
    return std::move(found_);
  }

 private:
  void add(const fs::path& folder, const std::string& reason) {
    for (const fs::path& path : entries_in(folder)) {
      const bool is_ours =
          written_.count(path.lexically_normal()) == 0 && bears_marker(path.string());
      if (is_ours) found_.push_back({FileState::orphaned, path.generic_string(), reason});
    }
  }

  /// Why nothing generates the files of a folder; "" where something does, or nobody knows.
  std::string reason_of(const fs::path& folder) const {
    for (const fs::path& path : entries_in(folder)) {
      if (!path.filename().string().ends_with(sidecar_ending)) continue;
      const SourcePaths stated = stated_paths(existing_text(path.string()).value_or(""));
      const std::string& source = stated.scene.empty() ? stated.model : stated.scene;
      const auto file = source_file(directory_, source);
      if (!file) return {};
      std::error_code error;
      if (!fs::exists(*file, error)) return fmt::format("there is no {}", *file);
      const bool is_renamed = std::ranges::any_of(
          sources_, [&stated](const SourcePaths& paths) { return same_sources(paths, stated); });
      return is_renamed ? fmt::format("{} has another name now", *file) : "";
    }
    return {};
  }

  const std::string& directory_;
  const std::vector<SourcePaths>& sources_;
  std::set<fs::path> written_ = {};
  std::set<fs::path> folders_ = {};
  std::vector<FileDifference> found_ = {};
};

}  // namespace

std::vector<FileDifference> orphans(const std::string& directory, const EmittedFiles& files,
                                    const std::vector<SourcePaths>& sources) {
  return OrphanSearch(directory, files, sources)();
}

}  // namespace elgen::cli
