// Revisions: `git ls-tree` lists the objects, `git cat-file` prints their bytes. Both read
// committed objects unchanged: attributes, path specifications and the working tree have no effect
// on them.
//
// Two versions are compared by their lowered equations. Forms are chosen in two cases only: if
// emitted functions depend on them, or if the program is small.
#include "cli/versions/versions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "cli/process/resources.hpp"
#include "elgen/wording.hpp"
#include "toolchain/process.hpp"

namespace elgen::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t seconds_of_git = 60;
/// The largest list of files that is read, in bytes: about ten million paths.
constexpr std::size_t longest_list = 1U << 30U;
/// The largest number of links that Linux follows in a path.
constexpr int most_links = 40;
constexpr std::size_t longest_path = 4096;
constexpr std::string_view link_mode = "120000";
constexpr std::string_view submodule = "160000";

Diagnostic git_error(const std::string& what, const ProcessResult& result) {
  std::string words = sanitize_output(result.errors);
  while (words.ends_with('\n')) words.pop_back();
  if (result.ending == ProcessEnding::not_started) words = "git could not be run";
  if (result.ending == ProcessEnding::out_of_time) {
    words = fmt::format("git did not end within {} s", seconds_of_git);
  }
  return {Code::E713, {}, words.empty() ? what : fmt::format("{}: {}", what, words)};
}

ProcessResult run_git(std::vector<std::string> words, std::size_t most_output = longest_list) {
  words.insert(words.begin(), "git");
  return run_with_input(words, seconds_of_git, most_output);
}

/// The output without its final line end; a path may contain other line ends.
std::string line_of(const ProcessResult& result) {
  std::string line = result.output;
  if (line.ends_with('\n')) line.pop_back();
  return line;
}

bool is_object_id(const std::string& text) {
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  return text.size() >= 40 && std::ranges::all_of(text, is_digit);
}

/// The root of the working tree. E713 if only $GIT_DIR is set, because then git takes the working
/// directory as root.
Result<std::string> find_working_tree_root() {
  const ProcessResult top = run_git({"rev-parse", "--show-toplevel"});
  if (!top.succeeded()) return git_error("the working directory is in no repository", top);
  std::string root = line_of(top);
  std::error_code error;
  const bool is_guessed =
      std::getenv("GIT_DIR") != nullptr && std::getenv("GIT_WORK_TREE") == nullptr;
  if (is_guessed && !fs::exists(fs::path(root) / ".git", error)) {
    return Diagnostic{
        Code::E713,
        {},
        fmt::format("git takes {} for the root, because $GIT_DIR is set", quote_text(root)),
        "set $GIT_WORK_TREE, too"};
  }
  return root;
}

/// Choosing forms takes little time for programs of at most this many instructions. The model
/// panda7 has 29 000 instructions.
constexpr std::size_t max_chosen_instructions = 2'000;

/// True if an output is an integration step, which calls functions in their chosen forms.
bool needs_forms(const Scene& scene) {
  return std::ranges::any_of(
      scene.outputs, [](const OutputRequest& output) { return output_row(output.kind).is_step; });
}

bool is_small(const Program& program) {
  std::size_t instructions = 0;
  for (const Function& function : program.functions) instructions += function.instructions.size();
  return instructions <= max_chosen_instructions;
}

Products run_stages(const PipelineSources& inputs, const Limits& limits, Goal goal) {
  renew_time_limit(limits);
  Products all =
      run_pipeline(inputs, {.limits = limits, .goals = {goal}, .on_stage = set_stage_name});
  set_stage_name("");
  return all;
}

OperationsByName operations_of(const Program& program) {
  OperationsByName operations;
  for (const Function& function : program.functions) {
    operations.emplace(function.name, count_operations(function));
  }
  return operations;
}

}  // namespace

Result<Revision> Revision::open(const std::string& name) {
  const Result<std::string> root = find_working_tree_root();
  if (!root) return root.diagnostics;
  const ProcessResult known = run_git({"rev-parse", "--verify", name + "^{commit}"});
  const std::string commit = line_of(known);
  const std::string no_revision = fmt::format("{} is no revision", quote_text(name));
  if (!known.succeeded()) return git_error(no_revision, known);
  // rev-parse also accepts "^HEAD", which is no commit.
  if (!is_object_id(commit)) return Diagnostic{Code::E713, {}, no_revision};
  const ProcessResult list = run_git({"ls-tree", "-r", "-z", "--full-tree", commit});
  if (!list.succeeded() || list.output.size() == longest_list) {
    return git_error(fmt::format("{} was not read", quote_text(name)), list);
  }
  // Each row: MODE TYPE ID<tab>PATH<null>.
  Revision revision(name, *root);
  for (std::size_t begin = 0; begin < list.output.size();) {
    const std::size_t end = list.output.find('\0', begin);
    const std::string row = list.output.substr(begin, end - begin);
    const std::size_t tab = row.find('\t');
    const std::size_t type = row.find(' ');
    const std::size_t id = row.find(' ', type + 1) + 1;
    revision.objects_.emplace(row.substr(tab + 1),
                              Object{row.substr(0, type), row.substr(id, tab - id)});
    begin = end == std::string::npos ? list.output.size() : end + 1;
  }
  return revision;
}

Result<std::string> Revision::repository_path(const std::string& path) const {
  std::error_code error;
  const fs::path root = fs::weakly_canonical(root_, error);
  // A link to a file is itself a file of the tree, wherever the link points. Links to folders, and
  // links among the parent folders, are resolved.
  const fs::path full = fs::absolute(path, error).lexically_normal();
  const bool is_folder = fs::is_directory(full, error) || !full.has_filename();
  const fs::path real = is_folder
                            ? fs::weakly_canonical(full, error)
                            : fs::weakly_canonical(full.parent_path(), error) / full.filename();
  const fs::path inside = real.lexically_relative(root);
  if (error || inside.empty() || *inside.begin() == "..") {
    return Diagnostic{Code::E713,
                      {},
                      fmt::format("{} is outside of the repository {}", quote_text(path),
                                  quote_text(root.string()))};
  }
  fs::path above;
  for (const fs::path& part : inside) {
    above /= part;
    const auto object = objects_.find(above.generic_string());
    if (object == objects_.end() || object->second.mode != submodule) continue;
    return Diagnostic{Code::E713,
                      {},
                      fmt::format("{} is in the submodule {}, which has its own revisions",
                                  quote_text(path), quote_text(above.generic_string()))};
  }
  return inside == "." ? "" : inside.generic_string();
}

std::vector<std::string> Revision::list_files(const std::string& folder) const {
  const std::string start = folder.empty() ? "" : folder + "/";
  std::vector<std::string> files;
  for (auto at = objects_.lower_bound(start); at != objects_.end(); ++at) {
    if (!at->first.starts_with(start)) break;
    const Result<const Object*> object = resolve_links(at->first);
    if (!object || *object != nullptr) files.push_back(at->first.substr(start.size()));
  }
  return files;
}

Result<const Revision::Object*> Revision::resolve_links(const std::string& path) const {
  std::string at = path;
  for (int link = 0; link < most_links; ++link) {
    const auto object = objects_.find(at);
    if (object == objects_.end() || object->second.mode == submodule) break;
    if (object->second.mode != link_mode) return &object->second;
    const Result<std::string> target = read_bytes(object->second, at, longest_path);
    if (!target) return target.diagnostics;
    at = (fs::path(at).parent_path() / *target).lexically_normal().generic_string();
  }
  return nullptr;
}

Result<std::string> Revision::read_bytes(const Object& object, const std::string& path,
                                         std::size_t most) const {
  ProcessResult blob = run_git({"cat-file", "blob", object.id}, most);
  if (blob.succeeded()) return std::move(blob.output);
  return git_error(fmt::format("{} was not read", quote_text(name_ + ":" + path)), blob);
}

Result<SourcePointer> Revision::read_source(const std::string& path, const Limits& limits) const {
  const std::string shown = name_ + ":" + path;
  const Result<const Object*> object = resolve_links(path);
  if (!object) return object.diagnostics;
  if (*object == nullptr) {
    return Diagnostic{Code::E111, {}, fmt::format("`{}` does not exist", printable_path(shown))};
  }
  Result<std::string> text = read_bytes(**object, path, std::size_t{limits.file_bytes} + 1);
  if (!text) return text.diagnostics;
  return make_limited_source(shown, *std::move(text), limits);
}

Version LoadedVersion::version() const {
  return {model,
          scene ? &*scene : nullptr,
          *products.checked,
          products.program ? *products.program : *products.lowered,
          products.diagnostics,
          operations.empty() ? nullptr : &operations};
}

std::string system_name(const PipelineSources& inputs, const Limits& limits) {
  const Products checked = run_stages(inputs, limits, Goal::check);
  return checked.checked ? checked.checked->scene.base_name : std::string();
}

Diagnostics inspection_diagnostics(const PipelineSources& inputs, const Limits& limits) {
  return run_stages(inputs, limits, Goal::inspect).diagnostics;
}

Result<LoadedVersion> load_version(const PipelineSources& inputs, const Limits& limits) {
  LoadedVersion loaded{inputs};
  loaded.products = run_stages(inputs, limits, Goal::lower);
  if (!loaded.products.lowered) return loaded.products.diagnostics;
  const bool is_emitted_otherwise = needs_forms(loaded.products.checked->scene);
  if (is_emitted_otherwise || is_small(*loaded.products.lowered)) {
    Products chosen = run_stages(inputs, limits, Goal::choose);
    if (chosen.program) loaded.operations = operations_of(*chosen.program);
    if (is_emitted_otherwise) loaded.products = std::move(chosen);
  }
  Diagnostics found = loaded.products.diagnostics;
  if (!loaded.products.lowered && !loaded.products.program) return found;
  loaded.model = *parse_model(inputs.model, limits);
  if (inputs.scene != nullptr) loaded.scene = *parse_scene(inputs.scene, limits);
  return {std::move(loaded), std::move(found)};
}

}  // namespace elgen::cli
