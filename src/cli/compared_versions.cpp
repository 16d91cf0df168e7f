// Pairs the files of two folders, or of a revision and the working tree, by their paths. Moved
// files are paired by the names of their systems.
#include "cli/compared_versions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string_view>
#include <utility>

#include "cli/files/inputs.hpp"
#include "cli/process/terminal.hpp"
#include "cli/versions/versions.hpp"
#include "elgen/wording.hpp"
#include "parse/toml_document.hpp"

namespace elgen::cli {

namespace {

namespace fs = std::filesystem;

bool has_same_text(const SourcePointer& x, const SourcePointer& y) {
  if (x == nullptr || y == nullptr) return x == y;
  return x->text == y->text;
}

/// True for a folder; false, without an exception, for a too long path or a circular link.
bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

bool path_exists(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

bool is_hidden(const fs::path& name) { return name.string().starts_with("."); }

/// Reads the files of one version, from the disk or from a revision.
struct VersionReader {
  SourceReader read;
  std::function<Result<PipelineSources>(const std::string& path)> read_inputs;
  /// The paths of all files below `folder`, relative to `folder`, without files in hidden folders.
  /// E707 if a folder cannot be read.
  std::function<Result<std::vector<std::string>>(const std::string& folder)> list_files;
};

Result<std::vector<std::string>> list_disk_files(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  fs::path last = folder;
  for (auto at = fs::recursive_directory_iterator(folder, error);
       !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
    last = at->path();
    // is_directory() returns false for a broken or circular link; the error code is not needed.
    std::error_code unknown;
    if (at->is_directory(unknown) && is_hidden(last.filename())) at.disable_recursion_pending();
    if (!at->is_regular_file(unknown)) continue;
    files.push_back(last.lexically_relative(folder).generic_string());
  }
  if (!error) return files;
  return Diagnostic{
      Code::E707,
      {},
      fmt::format("{} could not be read: {}", quote_text(last.string()), error.message())};
}

VersionReader disk_reader(const Limits& limits) {
  return {[&limits](const std::string& path) { return read_source(path, limits); },
          [&limits](const std::string& path) { return read_inputs(path, limits); },
          &list_disk_files};
}

VersionReader revision_reader(const Revision& revision, const Limits& limits) {
  const SourceReader read = [&](const std::string& path) {
    return revision.read_source(path, limits);
  };
  return {read,
          [&limits, read](const std::string& path) { return read_inputs(path, limits, read); },
          [&revision](const std::string& folder) {
            std::vector<std::string> files = revision.list_files(folder);
            std::erase_if(files, [](const fs::path& file) {
              const fs::path folders = file.parent_path();
              return std::any_of(folders.begin(), folders.end(), is_hidden);
            });
            return files;
          }};
}

/// The systems (models and scenes) of a folder, and its other TOML files. Paths are relative to the
/// folder, so that equal paths pair the files of two folders.
struct FolderFiles {
  std::set<std::string> systems = {};
  std::set<std::string> others = {};
  std::set<std::string> doubtful = {};  ///< the subset of `others` that may be models with errors
};

std::string join_paths(const std::string& folder, const std::string& inside) {
  return (fs::path(folder) / inside).lexically_normal().generic_string();
}

/// The role of a TOML file in the comparison of two folders.
enum class FileRole : std::uint8_t {
  system,    ///< a model or a scene, or a file that cannot be read
  doubtful,  ///< may be a model with errors
  other,
};

bool has_entry(const TomlValue& root, std::string_view key, TomlKind kind) {
  const TomlEntry* const entry = find_entry(root.entries, key);
  return entry != nullptr && entry->value.kind == kind;
}

/// The role of the file at `path`. A file is doubtful in two cases: it has [[coordinate]] but no
/// table [model]; or it is invalid TOML, but its text contains [model] or [[coordinate]].
FileRole role_of(const VersionReader& side, const std::string& path) {
  if (path.ends_with(".scene.toml")) return FileRole::system;
  const Result<SourcePointer> source = side.read(path);
  if (!source) return FileRole::system;
  const Result<TomlValue> root = read_toml(**source);
  if (!root) {
    const std::string& text = (*source)->text;
    const bool has_header = text.find("[model]") != std::string::npos ||
                            text.find("[[coordinate]]") != std::string::npos;
    return has_header ? FileRole::doubtful : FileRole::other;
  }
  if (has_entry(*root, "model", TomlKind::table)) return FileRole::system;
  return has_entry(*root, "coordinate", TomlKind::array) ? FileRole::doubtful : FileRole::other;
}

/// The models, scenes and other TOML files below a folder.
Result<FolderFiles> find_systems(const VersionReader& side, const std::string& folder) {
  const Result<std::vector<std::string>> found = side.list_files(folder);
  if (!found) return found.diagnostics;
  FolderFiles files;
  for (const std::string& inside : *found) {
    if (fs::path(inside).extension() != ".toml") continue;
    const FileRole role = role_of(side, join_paths(folder, inside));
    (role == FileRole::system ? files.systems : files.others).insert(inside);
    if (role == FileRole::doubtful) files.doubtful.insert(inside);
  }
  return files;
}

/// A file that only one of the two versions has.
struct UnpairedFile {
  const VersionReader* reader = nullptr;
  std::string path = {};  ///< the path in the version that has the file
  std::string report_path = {};
};

class VersionComparison {
 public:
  VersionComparison(const CompareOptions& options, const Limits& limits)
      : options_(options), limits_(limits) {}

  /// Adds the changes between two files to the report, or the errors of the files.
  void compare(const VersionReader& old_side, const std::string& old_path,
               const VersionReader& new_side, const std::string& new_path) {
    const Progress progress(new_path);
    progress.show_stage("compare");
    const Result<PipelineSources> before = old_side.read_inputs(old_path);
    const Result<PipelineSources> after = new_side.read_inputs(new_path);
    const bool is_read =
        keep_errors(new_path, before.diagnostics) && keep_errors(new_path, after.diagnostics);
    if (!is_read || !before || !after) return;
    const bool is_same =
        has_same_text(before->model, after->model) && has_same_text(before->scene, after->scene);
    if (is_same) {
      keep_input_errors(new_path, *after);
      return;
    }
    const Result<LoadedVersion> old = load_version(*before, limits_);
    const Result<LoadedVersion> now = load_version(*after, limits_);
    keep_errors(new_path, old.diagnostics);
    keep_errors(new_path, now.diagnostics);
    if (!old || !now) return;
    SystemChange& found =
        report_.systems.emplace_back(elgen::compare(old->version(), now->version(), options_));
    found.path = printable_path(new_path);
  }

  void compare_folders(const VersionReader& old_side, const std::string& old_folder,
                       const VersionReader& new_side, const std::string& new_folder) {
    const Result<FolderFiles> olds = find_systems(old_side, old_folder);
    const Result<FolderFiles> news = find_systems(new_side, new_folder);
    if (!keep_errors(new_folder, olds.diagnostics) || !keep_errors(new_folder, news.diagnostics))
      return;
    const auto compare_both = [&](const std::string& inside) {
      compare(old_side, join_paths(old_folder, inside), new_side, join_paths(new_folder, inside));
    };
    for (const std::string& inside : news->systems) {
      if (olds->systems.count(inside) + olds->others.count(inside) > 0) {
        compare_both(inside);
      } else {
        note_added(new_side, join_paths(new_folder, inside));
      }
    }
    for (const std::string& inside : olds->systems) {
      if (news->systems.count(inside) > 0) continue;
      if (news->others.count(inside) > 0) {
        compare_both(inside);
      } else {
        note_removed(old_side, join_paths(old_folder, inside), inside);
      }
    }
    for (const std::string& inside : news->doubtful) {
      if (olds->doubtful.count(inside) > 0) {
        compare_both(inside);
      } else if (olds->systems.count(inside) + olds->others.count(inside) == 0) {
        note_added(new_side, join_paths(new_folder, inside));
      }
    }
  }

  /// Notes a file that only the new side has.
  void note_added(const VersionReader& side, const std::string& path) {
    added_.push_back({&side, path, path});
  }

  /// Notes a file that only the old side has.
  void note_removed(const VersionReader& side, const std::string& path, const std::string& shown) {
    removed_.push_back({&side, path, shown});
  }

  Result<DiffReport> finish() {
    compare_moved();
    for (const UnpairedFile& file : added_) {
      const Result<PipelineSources> inputs = file.reader->read_inputs(file.path);
      const bool is_read = keep_errors(file.path, inputs.diagnostics) && inputs;
      if (is_read && keep_input_errors(file.path, *inputs)) {
        report_.added.push_back(printable_path(file.report_path));
      }
    }
    for (const UnpairedFile& file : removed_)
      report_.removed.push_back(printable_path(file.report_path));
    sort_by_position(diagnostics_);
    return {std::move(report_), std::move(diagnostics_)};
  }

 private:
  [[nodiscard]] std::string name_of(const UnpairedFile& file) const {
    const Result<PipelineSources> inputs = file.reader->read_inputs(file.path);
    return inputs ? system_name(*inputs, limits_) : std::string();
  }

  /// Compares each added system with the removed system of the same name, if there is one.
  void compare_moved() {
    if (added_.empty() || removed_.empty()) return;
    std::vector<std::string> old_names;
    for (const UnpairedFile& file : removed_) old_names.push_back(name_of(file));
    for (const UnpairedFile& now : std::exchange(added_, {})) {
      const std::string name = name_of(now);
      const auto found = std::ranges::find(old_names, name);
      if (name.empty() || found == old_names.end()) {
        added_.push_back(now);
        continue;
      }
      const auto old = removed_.begin() + (found - old_names.begin());
      compare(*old->reader, old->path, *now.reader, now.path);
      removed_.erase(old);
      old_names.erase(found);
    }
  }

  /// Adds to the report the errors of a file that is not compared; true if the file has no errors.
  bool keep_input_errors(const std::string& path, const PipelineSources& inputs) {
    return keep_errors(path, inspection_diagnostics(inputs, limits_));
  }

  /// Adds the errors in `found` to the report; true if there are none. Warnings are dropped,
  /// because `generate` reports them.
  bool keep_errors(const std::string& path, const Diagnostics& found) {
    for (const Diagnostic& diagnostic : found) {
      if (code_row(diagnostic.code).severity != Severity::error) continue;
      diagnostics_.push_back(diagnostic);
      std::vector<UnreadableSystem>& unreadable = report_.unreadable;
      const bool is_known = !unreadable.empty() && unreadable.back().path == printable_path(path);
      if (!is_known) unreadable.push_back({printable_path(path), diagnostic});
    }
    return !has_errors(found);
  }

  const CompareOptions& options_;
  const Limits& limits_;
  DiffReport report_ = {};
  std::vector<UnpairedFile> added_ = {};
  std::vector<UnpairedFile> removed_ = {};
  Diagnostics diagnostics_ = {};
};

}  // namespace

Result<DiffReport> compare_paths(const std::string& before, const std::string& after,
                                 const CompareOptions& options, const Limits& limits) {
  const VersionReader files = disk_reader(limits);
  VersionComparison comparing(options, limits);
  if (is_folder(before) && is_folder(after)) {
    comparing.compare_folders(files, before, files, after);
  } else {
    comparing.compare(files, before, files, after);
  }
  return comparing.finish();
}

Result<DiffReport> compare_with_revision(const std::string& name, std::vector<std::string> paths,
                                         const CompareOptions& options, const Limits& limits) {
  const Result<Revision> revision = Revision::open(name);
  if (!revision) return revision.diagnostics;
  const VersionReader committed = revision_reader(*revision, limits);
  const VersionReader files = disk_reader(limits);
  if (paths.empty()) paths = {"."};
  VersionComparison comparing(options, limits);
  for (const std::string& path : paths) {
    const Result<std::string> old = revision->repository_path(path);
    if (!old) return old.diagnostics;
    const bool was_there = revision->contains(*old);
    if (is_folder(path)) {
      comparing.compare_folders(committed, *old, files, path);
    } else if (was_there == path_exists(path)) {
      comparing.compare(committed, *old, files, path);
    } else if (was_there) {
      comparing.note_removed(committed, *old, path);
    } else {
      comparing.note_added(files, path);
    }
  }
  return comparing.finish();
}

}  // namespace elgen::cli
