// The files of a revision are unpacked into a temporary folder, where scenes find their models.
#include "cli/compared_versions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "cli/files/inputs.hpp"
#include "cli/process/progress.hpp"
#include "cli/process/resources.hpp"
#include "elgen/wording.hpp"
#include "parse/names_model.hpp"
#include "toolchain/process.hpp"
#include "toolchain/temporary_directory.hpp"

namespace elgen::cli {

namespace {

namespace fs = std::filesystem;

/// One version of a system, with what it points into.
struct LoweredVersion {
  Inputs inputs = {};
  FileSyntax model = {};
  std::optional<FileSyntax> scene = {};
  Products products = {};

  [[nodiscard]] Version version() const {
    return {model, scene ? &*scene : nullptr, *products.checked,
            products.program ? *products.program : *products.lowered, products.diagnostics};
  }
};

/// Whether what is emitted is not what is lowered: terms are dropped from closed forms, and steps
/// are made of functions in their forms.
bool needs_forms(const Scene& scene) {
  return scene.dropping || std::ranges::any_of(scene.outputs, [](const OutputRequest& output) {
           return output_row(output.kind).steps;
         });
}

Result<LoweredVersion> load(Inputs inputs, const Limits& limits) {
  renew_time_limit(limits);
  LoweredVersion loaded{std::move(inputs)};
  PipelineOptions options;
  options.limits = limits;
  options.goals = {"lower"};
  loaded.products = run_pipeline(loaded.inputs, options);
  const bool is_lowered = loaded.products.lowered.has_value();
  if (is_lowered && needs_forms(loaded.products.checked->scene)) {
    options.goals = {"choose"};
    loaded.products = run_pipeline(loaded.inputs, options);
  }
  Diagnostics found = loaded.products.diagnostics;
  if (!loaded.products.lowered && !loaded.products.program) return found;
  loaded.model = *parse_model(loaded.inputs.model, limits);
  if (loaded.inputs.scene != nullptr) loaded.scene = *parse_scene(loaded.inputs.scene, limits);
  return {std::move(loaded), std::move(found)};
}

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

/// The models and scenes below a folder, by their paths in it.
std::set<std::string> systems_below(const fs::path& folder, const Limits& limits) {
  std::set<std::string> found;
  std::error_code error;
  for (auto at = fs::recursive_directory_iterator(folder, error);
       at != fs::recursive_directory_iterator(); at.increment(error)) {
    if (error) break;
    const fs::path& path = at->path();
    if (at->is_directory() && path.filename().string().starts_with(".")) {
      at.disable_recursion_pending();
      continue;
    }
    if (!at->is_regular_file() || path.extension() != ".toml") continue;
    const bool is_scene = path.filename().string().ends_with(".scene.toml");
    const Result<SourcePointer> source = read_source(path.string(), limits);
    if (!is_scene && (!source || !declares_model(**source))) continue;
    found.insert(path.lexically_relative(folder).generic_string());
  }
  return found;
}

class VersionPairs {
 public:
  VersionPairs(const Renames& renames, const Limits& limits) : renames_(renames), limits_(limits) {}

  /// Two files.
  void compare(const Side& old_side, const std::string& old_path, const Side& new_side,
               const std::string& new_path) {
    const Progress progress(new_path);
    progress.stage("compare");
    Result<Inputs> before = old_side.read(old_path, limits_);
    Result<Inputs> after = new_side.read(new_path, limits_);
    if (!keep(before.diagnostics) || !keep(after.diagnostics) || !before || !after) return;
    const bool is_same =
        same_text(before->model, after->model) && same_text(before->scene, after->scene);
    if (is_same) return;
    const Result<LoweredVersion> old = load(*before, limits_);
    const Result<LoweredVersion> now = load(*after, limits_);
    sources_.insert(sources_.end(), {before->model, before->scene, after->model, after->scene});
    keep(old.diagnostics);
    keep(now.diagnostics);
    if (!old || !now) return;
    report_.systems.push_back(elgen::compare(old->version(), now->version(), renames_));
  }

  void compare_folders(const Side& old_side, const fs::path& old_folder, const Side& new_side,
                       const fs::path& new_folder) {
    const std::set<std::string> olds = systems_below(old_folder, limits_);
    const std::set<std::string> news = systems_below(new_folder, limits_);
    for (const std::string& path : news) {
      const std::string now = (new_folder / path).lexically_normal().string();
      if (olds.count(path) == 0) {
        report_.added.push_back(now);
      } else {
        compare(old_side, (old_folder / path).lexically_normal().string(), new_side, now);
      }
    }
    for (const std::string& path : olds) {
      if (news.count(path) == 0) report_.removed.push_back(path);
    }
  }

  void add(std::string path) { report_.added.push_back(std::move(path)); }

  Result<DiffReport> result() {
    sort_by_position(diagnostics_);
    if (has_errors(diagnostics_)) return std::move(diagnostics_);
    return {std::move(report_), std::move(diagnostics_)};
  }

 private:
  /// Whether there is no error among them. Warnings of the models are for `generate`.
  bool keep(const Diagnostics& found) {
    for (const Diagnostic& diagnostic : found) {
      if (code_row(diagnostic.code).severity == Severity::error) diagnostics_.push_back(diagnostic);
    }
    return !has_errors(found);
  }

  const Renames& renames_;
  const Limits& limits_;
  DiffReport report_ = {};
  Diagnostics diagnostics_ = {};
  static inline std::vector<SourcePointer> sources_ = {};  ///< that spans point into
};

constexpr std::uint64_t seconds_of_git = 60;

Diagnostic git_failed(const std::string& what, const ProcessResult& result) {
  if (result.ending == Ending::not_started) return {Code::E713, {}, "git could not be run"};
  return {Code::E713, {}, fmt::format("{}: {}", what, result.output)};
}

/// Unpacks the files NAME.toml of a revision of this repository; the path from its root to here.
Result<std::string> unpack(const std::string& revision, const fs::path& folder) {
  const ProcessResult root = run({"git", "rev-parse", "--show-prefix"}, seconds_of_git);
  if (!root.succeeded()) return git_failed("there is no repository here", root);
  const ProcessResult top = run({"git", "rev-parse", "--show-toplevel"}, seconds_of_git);
  const auto line = [](const std::string& text) { return text.substr(0, text.find('\n')); };
  const std::string archive = (folder / "archive.tar").string();
  const ProcessResult packed = run({"git", "-C", line(top.output), "archive", "--format=tar",
                                    "--output", archive, revision, "--", "*.toml"},
                                   seconds_of_git);
  if (!packed.succeeded()) {
    return git_failed(fmt::format("{} was not read", elgen::quoted(revision)), packed);
  }
  const ProcessResult unpacked =
      run({"tar", "-xf", archive, "-C", folder.string()}, seconds_of_git);
  if (!unpacked.succeeded()) return git_failed("the archive was not unpacked", unpacked);
  return line(root.output);
}

}  // namespace

Result<DiffReport> compared_paths(const std::string& before, const std::string& after,
                                  const Renames& renames, const Limits& limits) {
  VersionPairs comparing(renames, limits);
  if (fs::is_directory(before) && fs::is_directory(after)) {
    comparing.compare_folders({}, before, {}, after);
  } else {
    comparing.compare({}, before, {}, after);
  }
  return comparing.result();
}

Result<DiffReport> compared_with_revision(const std::string& revision,
                                          std::vector<std::string> paths, const Renames& renames,
                                          const Limits& limits) {
  const std::optional<TemporaryDirectory> temporary = TemporaryDirectory::create();
  if (!temporary) return Diagnostic{Code::E706, {}, "there is no temporary folder"};
  const Result<std::string> prefix = unpack(revision, temporary->path());
  if (!prefix) return prefix.diagnostics;
  const fs::path here = temporary->path() / *prefix;
  const Side old_side{temporary->path(), revision + ":"};
  if (paths.empty()) paths = {"."};
  VersionPairs comparing(renames, limits);
  for (const std::string& path : paths) {
    const fs::path old = (here / path).lexically_normal();
    if (fs::is_directory(path)) {
      comparing.compare_folders(old_side, old, {}, path);
    } else if (fs::exists(old) || !fs::exists(path)) {
      comparing.compare(old_side, old.string(), {}, path);
    } else {
      comparing.add(path);
    }
  }
  return comparing.result();
}

}  // namespace elgen::cli
