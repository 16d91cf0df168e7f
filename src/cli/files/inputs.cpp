// Reads the files that a command names. For a scene, also reads the model that the scene names.
#include "cli/files/inputs.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <set>
#include <system_error>
#include <vector>

#include "base/descriptor.hpp"
#include "base/reason.hpp"
#include "cli/process/resources.hpp"
#include "elgen/syntax.hpp"
#include "elgen/wording.hpp"

namespace elgen::cli {
namespace {

namespace fs = std::filesystem;

/// Device and inode: equal for all paths of the same file.
using FileIdentity = std::pair<dev_t, ino_t>;

FileIdentity file_identity(const struct stat& file) { return {file.st_dev, file.st_ino}; }

std::set<FileIdentity>& input_identities() {
  static std::set<FileIdentity> files;
  return files;
}

Diagnostic unreadable_error(const std::string& path, std::string_view reason) {
  return {Code::E707, {}, fmt::format("`{}` {}", printable_path(path), reason)};
}

Diagnostic unreadable(const std::string& path, int error) {
  return unreadable_error(path, "could not be read: " + std::generic_category().message(error));
}

/// The model or scene beside a missing file that has a near name: "base.toml" for "base" and
/// "basse.toml". "" if there is none.
std::string near_file(const fs::path& missing) {
  if (missing.has_extension() && missing.extension() != ".toml") return "";
  const fs::path folder = missing.parent_path();
  std::vector<std::string> stems;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, failed)) {
    if (entry.path().extension() == ".toml") stems.push_back(entry.path().stem().string());
  }
  std::ranges::sort(stems);
  const std::string near = nearest_word(missing.stem().string(), stems);
  return near.empty() ? "" : (folder / (near + ".toml")).string();
}

/// E111 if the file does not exist; E707 if stat() fails, or if the file is neither regular nor a
/// FIFO. Call this before open(), because opening a device may block or have effects.
std::optional<Diagnostic> missing_file_error(const std::string& path) {
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0) {
    if (errno != ENOENT && errno != ENOTDIR) return unreadable(path, errno);
    const std::string near = near_file(path);
    return Diagnostic{Code::E111,
                      {},
                      fmt::format("`{}` does not exist", printable_path(path)),
                      near.empty() ? "" : fmt::format("did you mean `{}`?", printable_path(near))};
  }
  const std::string_view kind = special_file_kind(found.st_mode);
  if (kind.empty() || S_ISFIFO(found.st_mode)) return std::nullopt;
  return unreadable_error(path, fmt::format("is {}, not a file", kind));
}

/// Reads an open file. Stops soon after `limits.file_bytes` bytes, with the error E901.
Result<SourcePointer> read_descriptor(const std::string& name, const FileDescriptor& file,
                                      const Limits& limits) {
  struct stat found {};
  if (::fstat(file.number(), &found) != 0) return unreadable(name, errno);
  input_identities().insert(file_identity(found));
  std::string text;
  std::array<char, 1U << 16U> part{};
  while (text.size() <= limits.file_bytes) {
    const ssize_t count = ::read(file.number(), part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return unreadable(name, errno);
    if (count == 0) break;
    text.append(part.data(), static_cast<std::size_t>(count));
  }
  return make_limited_source(name, std::move(text), limits);
}

Result<SourcePointer> read_stdin(const Limits& limits) {
  static bool is_read = false;
  const std::string name(stdin_name);
  if (std::exchange(is_read, true)) return unreadable_error(name, "can be read only once");
  const InputTimeout waiting(limits, name);
  return read_descriptor(name, FileDescriptor(::dup(STDIN_FILENO)), limits);
}

Result<SourcePointer> read_file(const std::string& path, const Limits& limits) {
  if (auto error = missing_file_error(path)) return *std::move(error);
  const InputTimeout waiting(limits, path);
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY));
  if (!file.is_open()) return unreadable(path, errno);
  return read_descriptor(path, file, limits);
}

bool is_scene(const SourceText& source) {
  if (source.path == stdin_name) return find_model_key(source).has_value();
  return source.path.size() > std::string_view(".scene.toml").size() &&
         source.path.ends_with(".scene.toml");
}

/// The error of a file whose name and content disagree: a robot description, a scene without the
/// ending of scenes, or a model with the ending of scenes. None otherwise.
std::optional<Diagnostic> misnamed_error(const SourceText& source) {
  const std::size_t first = source.text.find_first_not_of(" \t\r\n");
  const bool is_merge = source.text.starts_with("<<<<<<<");
  if (first != std::string::npos && source.text[first] == '<' && !is_merge) {
    const auto begin = static_cast<std::uint32_t>(first);
    return Diagnostic{Code::E101,
                      {&source, begin, begin + 1},
                      "XML where TOML is expected",
                      fmt::format("`elgen import {}` makes a model of a robot description",
                                  source.path == stdin_name ? "-" : source.path)};
  }
  if (is_scene(source) && declares_model(source)) {
    return Diagnostic{
        Reason::misnamed_file,
        {&source, 0, 0},
        fmt::format("{} contains a model: it has a table [model]", quote_text(source.path)),
        "a model is called NAME.toml, a scene NAME.scene.toml"};
  }
  const auto model = is_scene(source) ? std::nullopt : find_model_key(source);
  if (!model) return std::nullopt;
  return Diagnostic{Reason::misnamed_file, *model,
                    fmt::format("{} is a string, but [model] is a table", in_backticks(*model)),
                    "a scene is called NAME.scene.toml"};
}

/// The hint if a scene's model does not exist. To show a revision, git copies single files into a
/// temporary folder `git-blob-*`.
std::string hint_of_scene(const fs::path& scene, const fs::path& model) {
  const bool is_alone = scene.parent_path().filename().string().starts_with("git-blob-");
  if (is_alone)
    return "git passes the scene without its model; `elgen diff --against REV` reads both";
  const std::string near = fs::path(near_file(model)).filename().string();
  return near.empty() ? "the path is relative to the scene"
                      : fmt::format("did you mean `{}`?", near);
}

}  // namespace

Result<SourcePointer> make_limited_source(const std::string& path, std::string text,
                                          const Limits& limits) {
  const SourcePointer source = make_permanent_source(printable_path(path), std::move(text));
  if (source->text.size() <= limits.file_bytes) return source;
  const auto at = static_cast<std::uint32_t>(limits.file_bytes);  // the first byte beyond the limit
  return Diagnostic{Code::E901,
                    {source.get(), at, at},
                    fmt::format("`{}` has more than {} bytes", source->path, limits.file_bytes),
                    "`--limit file_bytes=N` raises the limit"};
}

bool is_read_file(const struct stat& file) {
  return input_identities().count(file_identity(file)) > 0;
}

Result<SourcePointer> read_source(const std::string& path, const Limits& limits) {
  return path == "-" ? read_stdin(limits) : read_file(path, limits);
}

Result<PipelineSources> read_inputs(const std::string& path, const Limits& limits) {
  return read_inputs(path, limits, [&](const std::string& file) {
    Result<SourcePointer> source = read_source(file, limits);
    if (!source && file != path) source.diagnostics.front().hint = hint_of_scene(path, file);
    return source;
  });
}

Result<PipelineSources> read_inputs(const std::string& path, const Limits& limits,
                                    const SourceReader& read) {
  Result<SourcePointer> source = read(path);
  if (!source) return source.diagnostics;
  if (auto mistake = misnamed_error(**source)) return *std::move(mistake);
  if (!is_scene(**source)) return PipelineSources{*source, nullptr};

  const Result<FileSyntax> scene = parse_scene(*source, limits);
  if (!scene) return scene.diagnostics;
  const KeySyntax* named = find_key(&*scene, "", "model");
  if (named == nullptr) return scene.diagnostics;  // parse_scene() has reported the missing key
  // Only files NAME.toml are read, so that no diagnostic quotes the text of other files.
  if (!named->value.text.ends_with(".toml")) {
    return Diagnostic{Reason::misnamed_file, named->value.span,
                      fmt::format("{} is no model", quote_text(named->value.text)),
                      "a model is called NAME.toml"};
  }
  const fs::path model = fs::path(path).parent_path() / named->value.text;
  Result<SourcePointer> model_source = read(model.lexically_normal().string());
  if (!model_source) {
    // The scene has the wrong path, so the diagnostic points into the scene.
    Diagnostics errors = model_source.diagnostics;
    errors.front().span = named->value.span;
    return errors;
  }
  return PipelineSources{*model_source, *source};
}

std::string_view special_file_kind(mode_t mode) {
  switch (mode & S_IFMT) {
    case S_IFREG:
      return {};
    case S_IFDIR:
      return "a folder";
    case S_IFCHR:
    case S_IFBLK:
      return "a device";
    case S_IFIFO:
      return "a FIFO";
    case S_IFSOCK:
      return "a socket";
    default:
      return "a symbolic link";
  }
}

}  // namespace elgen::cli
