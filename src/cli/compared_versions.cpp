// The files of a revision are unpacked into a temporary folder, where scenes find their models.
#include "cli/compared_versions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "cli/files/inputs.hpp"
#include "cli/files/output_files.hpp"
#include "cli/process/progress.hpp"
#include "cli/versions/loaded_version.hpp"
#include "cli/versions/revision.hpp"
#include "elgen/wording.hpp"
#include "parse/names_model.hpp"
#include "toolchain/temporary_directory.hpp"

namespace elgen::cli {

namespace {

namespace fs = std::filesystem;

SourcePointer with_path(const SourcePointer& source, const std::string& path) {
  return source == nullptr ? nullptr : make_source(path, source->text);
}

bool same_text(const SourcePointer& x, const SourcePointer& y) {
  if (x == nullptr || y == nullptr) return x == y;
  return x->text == y->text;
}

/// A folder whose files are called otherwise in messages.
struct Side {
  fs::path folder = {};
  std::string shown = {};  ///< in the place of the folder: "HEAD~1:"

  [[nodiscard]] Result<Inputs> read(const std::string& path, const Limits& limits) const {
    Result<Inputs> inputs = read_inputs(path, limits);
    if (!inputs || shown.empty()) return inputs;
    const auto named = [this](const SourcePointer& source) {
      if (source == nullptr) return source;
      const fs::path inside = fs::path(source->path).lexically_relative(folder);
      return with_path(source, shown + inside.generic_string());
    };
    return Inputs{named(inputs->model), named(inputs->scene)};
  }
};

/// Not of a path that is too long, or a link that leads round in a circle.
bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

/// Files by the paths by which those of two folders match.
using FilesByPath = std::map<std::string, fs::path>;

/// The systems of a folder, and its other TOML files, among them models that cannot be read.
struct FolderFiles {
  FilesByPath systems = {};
  FilesByPath others = {};
  Diagnostics errors = {};  ///< E707: a folder below it that cannot be read
};

bool is_system(const fs::path& path, const Limits& limits) {
  if (path.extension() != ".toml") return false;
  if (path.filename().string().ends_with(".scene.toml")) return true;
  const Result<SourcePointer> source = read_source(path.string(), limits);
  return !source || declares_model(**source);
}

/// The models and scenes below a folder; where it has none, the sidecars.
FolderFiles files_below(const fs::path& folder, const Limits& limits) {
  FolderFiles files;
  FilesByPath sidecars;
  std::error_code error;
  fs::path last = folder;
  for (auto at = fs::recursive_directory_iterator(folder, error);
       !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
    const fs::path& path = last = at->path();
    // Of a link that leads nowhere, or round in a circle, nothing is known.
    std::error_code unknown;
    if (at->is_directory(unknown) && path.filename().string().starts_with(".")) {
      at.disable_recursion_pending();
      continue;
    }
    if (!at->is_regular_file(unknown)) continue;
    const std::string inside = path.lexically_relative(folder).generic_string();
    FilesByPath& list = is_system(path, limits) ? files.systems : files.others;
    if (path.extension() == ".toml") list.emplace(inside, path.lexically_normal());
    if (inside.ends_with(sidecar_ending)) sidecars.emplace(inside, path.lexically_normal());
  }
  if (error) {
    files.errors.push_back(
        {Code::E707,
         {},
         fmt::format("{} could not be read: {}", in_backticks(last.string()), error.message())});
  }
  if (files.systems.empty()) files.systems = std::move(sidecars);
  return files;
}

class VersionPairs {
 public:
  VersionPairs(const CompareOptions& options, const Limits& limits)
      : options_(options), limits_(limits) {}

  /// Two files.
  void compare(const Side& old_side, const std::string& old_path, const Side& new_side,
               const std::string& new_path) {
    const Progress progress(new_path);
    progress.stage("compare");
    const Result<Inputs> before = old_side.read(old_path, limits_);
    const Result<Inputs> after = new_side.read(new_path, limits_);
    if (!keep(before.diagnostics) || !keep(after.diagnostics) || !before || !after) return;
    if (!are_of_one_kind(*before, *after)) return;
    const bool is_same =
        same_text(before->model, after->model) && same_text(before->scene, after->scene);
    if (is_same) return keep_mistakes(*after);
    const Result<LoadedVersion> old = load_version(*before, limits_);
    const Result<LoadedVersion> now = load_version(*after, limits_);
    sources_.insert(sources_.end(), {before->model, before->scene, after->model, after->scene});
    keep(old.diagnostics);
    keep(now.diagnostics);
    if (!old || !now) return;
    report_.systems.push_back(elgen::compare(version_of(*old), version_of(*now), options_));
  }

  void compare_folders(const Side& old_side, const fs::path& old_folder, const Side& new_side,
                       const fs::path& new_folder) {
    const FolderFiles olds = files_below(old_folder, limits_);
    const FolderFiles news = files_below(new_folder, limits_);
    if (!keep(olds.errors) || !keep(news.errors)) return;
    for (const auto& [path, now] : news.systems) {
      const FilesByPath& list = olds.others.count(path) > 0 ? olds.others : olds.systems;
      const auto old = list.find(path);
      if (old == list.end()) {
        add(new_side, now.string());
      } else {
        compare(old_side, old->second.string(), new_side, now.string());
      }
    }
    for (const auto& [path, old] : olds.systems) {
      if (news.systems.count(path) > 0) continue;
      const auto unreadable = news.others.find(path);
      if (unreadable == news.others.end()) {
        report_.removed.push_back(path);
      } else {
        compare(old_side, old.string(), new_side, unreadable->second.string());
      }
    }
  }

  /// A file that only the newer side has.
  void add(const Side& side, const std::string& path) {
    const Result<Inputs> inputs = side.read(path, limits_);
    if (keep(inputs.diagnostics) && inputs) keep_mistakes(*inputs);
    report_.added.push_back(path);
  }

  Result<DiffReport> result() {
    sort_by_position(diagnostics_);
    if (has_errors(diagnostics_)) return std::move(diagnostics_);
    return {std::move(report_), std::move(diagnostics_)};
  }

 private:
  /// Of files that are not compared, in their syntax.
  void keep_mistakes(const Inputs& inputs) {
    sources_.insert(sources_.end(), {inputs.model, inputs.scene});
    if (is_sidecar(*inputs.model)) return;
    keep(parse_model(inputs.model, limits_).diagnostics);
    if (inputs.scene != nullptr) keep(parse_scene(inputs.scene, limits_).diagnostics);
  }

  /// A sidecar has no keys, a model nothing that is not in them.
  bool are_of_one_kind(const Inputs& before, const Inputs& after) {
    const bool is_after = is_sidecar(*after.model);
    if (is_sidecar(*before.model) == is_after) return true;
    const std::string& sidecar = (is_after ? after : before).model->path;
    keep({{Code::E913,
           {},
           fmt::format("{} is a sidecar of equations, which is compared with another one",
                       in_backticks(sidecar))}});
    return false;
  }

  /// Whether there is no error among them. Warnings of the models are for `generate`.
  bool keep(const Diagnostics& found) {
    for (const Diagnostic& diagnostic : found) {
      if (code_row(diagnostic.code).severity == Severity::error) diagnostics_.push_back(diagnostic);
    }
    return !has_errors(found);
  }

  const CompareOptions& options_;
  const Limits& limits_;
  DiffReport report_ = {};
  Diagnostics diagnostics_ = {};
  static inline std::vector<SourcePointer> sources_ = {};  ///< that spans point into
};

}  // namespace

Result<DiffReport> compared_paths(const std::string& before, const std::string& after,
                                  const CompareOptions& options, const Limits& limits) {
  VersionPairs comparing(options, limits);
  if (is_folder(before) && is_folder(after)) {
    comparing.compare_folders({}, before, {}, after);
  } else {
    comparing.compare({}, before, {}, after);
  }
  return comparing.result();
}

Result<DiffReport> compared_with_revision(const std::string& revision,
                                          std::vector<std::string> paths,
                                          const CompareOptions& options, const Limits& limits) {
  const std::optional<TemporaryDirectory> temporary = TemporaryDirectory::create();
  if (!temporary) return Diagnostic{Code::E706, {}, "there is no temporary folder"};
  const Result<std::string> prefix = unpack_revision(revision, temporary->path());
  if (!prefix) return prefix.diagnostics;
  const fs::path here = temporary->path() / *prefix;
  const Side old_side{temporary->path(), revision + ":"};
  if (paths.empty()) paths = {"."};
  VersionPairs comparing(options, limits);
  for (const std::string& path : paths) {
    const fs::path old = (here / path).lexically_normal();
    if (is_folder(path)) {
      comparing.compare_folders(old_side, old, {}, path);
    } else if (is_there(old) || !is_there(path)) {
      comparing.compare(old_side, old.string(), {}, path);
    } else {
      comparing.add({}, path);
    }
  }
  return comparing.result();
}

}  // namespace elgen::cli
