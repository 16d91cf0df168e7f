// Revision: `git ls-tree` lists the objects, `git cat-file` gives their bytes. Both take what is
// committed as it is: attributes, path specifications and the working tree mean nothing to them.
#include "cli/versions/revision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "elgen/wording.hpp"
#include "toolchain/process.hpp"

namespace elgen::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t seconds_of_git = 60;
/// Paths of some ten million files.
constexpr std::size_t longest_list = 1U << 30U;
/// As many as Linux follows.
constexpr int most_links = 40;
constexpr std::size_t longest_path = 4096;
constexpr std::string_view link_mode = "120000";
constexpr std::string_view submodule = "160000";

Diagnostic refused(const std::string& what, const ProcessResult& result) {
  std::string words = plain_text(result.errors);
  while (words.ends_with('\n')) words.pop_back();
  if (result.ending == Ending::not_started) words = "git could not be run";
  if (result.ending == Ending::out_of_time) {
    words = fmt::format("git did not end within {} s", seconds_of_git);
  }
  return {Code::E713, {}, words.empty() ? what : fmt::format("{}: {}", what, words)};
}

ProcessResult git(std::vector<std::string> words, std::size_t most_output = longest_list) {
  words.insert(words.begin(), "git");
  return run_apart(words, seconds_of_git, most_output);
}

/// Without the line end behind it; a path may have others.
std::string line_of(const ProcessResult& result) {
  std::string line = result.output;
  if (line.ends_with('\n')) line.pop_back();
  return line;
}

bool is_object_id(const std::string& text) {
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  return text.size() >= 40 && std::ranges::all_of(text, is_digit);
}

/// The root of the working tree. Where $GIT_DIR alone is given, git takes the current folder for
/// it, whatever that is.
Result<std::string> root_of_tree() {
  const ProcessResult top = git({"rev-parse", "--show-toplevel"});
  if (!top.succeeded()) return refused("there is no repository here", top);
  std::string root = line_of(top);
  std::error_code error;
  const bool is_guessed =
      std::getenv("GIT_DIR") != nullptr && std::getenv("GIT_WORK_TREE") == nullptr;
  if (is_guessed && !fs::exists(fs::path(root) / ".git", error)) {
    return Diagnostic{
        Code::E713,
        {},
        fmt::format("git takes {} for the root, because $GIT_DIR is set", in_backticks(root)),
        "set $GIT_WORK_TREE, too"};
  }
  return root;
}

}  // namespace

Result<Revision> Revision::open(const std::string& name) {
  const Result<std::string> root = root_of_tree();
  if (!root) return root.diagnostics;
  const ProcessResult known = git({"rev-parse", "--verify", name + "^{commit}"});
  const std::string commit = line_of(known);
  const std::string no_revision = fmt::format("{} is no revision", in_backticks(name));
  if (!known.succeeded()) return refused(no_revision, known);
  // "^HEAD" is all but HEAD.
  if (!is_object_id(commit)) return Diagnostic{Code::E713, {}, no_revision};
  const ProcessResult list = git({"ls-tree", "-r", "-z", "--full-tree", commit});
  if (!list.succeeded() || list.output.size() == longest_list) {
    return refused(fmt::format("{} was not read", in_backticks(name)), list);
  }
  // MODE TYPE ID<tab>PATH<null>
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

Result<std::string> Revision::path_of(const std::string& path) const {
  std::error_code error;
  const fs::path root = fs::weakly_canonical(root_, error);
  // A link is a file of the tree, wherever it leads; the folders above it are real.
  const fs::path full = fs::absolute(path, error).lexically_normal();
  const bool is_folder = fs::is_directory(full, error) || !full.has_filename();
  const fs::path real = is_folder
                            ? fs::weakly_canonical(full, error)
                            : fs::weakly_canonical(full.parent_path(), error) / full.filename();
  const fs::path inside = real.lexically_relative(root);
  if (error || inside.empty() || *inside.begin() == "..") {
    return Diagnostic{Code::E713,
                      {},
                      fmt::format("{} is outside of the repository {}", in_backticks(path),
                                  in_backticks(root.string()))};
  }
  fs::path above;
  for (const fs::path& part : inside) {
    above /= part;
    const auto object = objects_.find(above.generic_string());
    if (object == objects_.end() || object->second.mode != submodule) continue;
    return Diagnostic{Code::E713,
                      {},
                      fmt::format("{} is in the submodule {}, which has revisions of its own",
                                  in_backticks(path), in_backticks(above.generic_string()))};
  }
  return inside == "." ? "" : inside.generic_string();
}

std::vector<std::string> Revision::files_below(const std::string& folder) const {
  const std::string start = folder.empty() ? "" : folder + "/";
  std::vector<std::string> files;
  for (auto at = objects_.lower_bound(start); at != objects_.end(); ++at) {
    if (!at->first.starts_with(start)) break;
    const Result<const Object*> object = followed(at->first);
    if (!object || *object != nullptr) files.push_back(at->first.substr(start.size()));
  }
  return files;
}

Result<const Revision::Object*> Revision::followed(const std::string& path) const {
  std::string at = path;
  for (int link = 0; link < most_links; ++link) {
    const auto object = objects_.find(at);
    if (object == objects_.end() || object->second.mode == submodule) break;
    if (object->second.mode != link_mode) return &object->second;
    const Result<std::string> target = bytes(object->second, at, longest_path);
    if (!target) return target.diagnostics;
    at = (fs::path(at).parent_path() / *target).lexically_normal().generic_string();
  }
  return nullptr;
}

Result<std::string> Revision::bytes(const Object& object, const std::string& path,
                                    std::size_t most) const {
  ProcessResult blob = git({"cat-file", "blob", object.id}, most);
  if (blob.succeeded()) return std::move(blob.output);
  return refused(fmt::format("{} was not read", in_backticks(name_ + ":" + path)), blob);
}

Result<SourcePointer> Revision::read(const std::string& path, const Limits& limits) const {
  const std::string shown = name_ + ":" + path;
  const Result<const Object*> object = followed(path);
  if (!object) return object.diagnostics;
  if (*object == nullptr) {
    return Diagnostic{Code::E111, {}, fmt::format("`{}` does not exist", shown_path(shown))};
  }
  Result<std::string> text = bytes(**object, path, std::size_t{limits.file_bytes} + 1);
  if (!text) return text.diagnostics;
  return kept_source(shown, *std::move(text), limits);
}

}  // namespace elgen::cli
