// Versions: the files of a git revision, read from its objects; and a model or scene that is loaded
// for a comparison.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/files/inputs.hpp"
#include "elgen/diff.hpp"
#include "elgen/limits.hpp"
#include "elgen/pipeline.hpp"

namespace elgen::cli {

/// The files of a revision. Paths are relative to the root of the repository. An error of git is
/// reported as E713, with git's message.
class Revision {
 public:
  /// Opens a revision of the repository that contains the working directory.
  [[nodiscard]] static Result<Revision> open(const std::string& name);

  /// The path of a file or folder of the working tree, relative to the root of the repository. E713
  /// if `path` is outside of the working tree or in a submodule.
  [[nodiscard]] Result<std::string> repository_path(const std::string& path) const;

  [[nodiscard]] bool contains(const std::string& path) const { return objects_.count(path) > 0; }

  /// The files below a folder ("": the root), with paths relative to this folder. Omits submodules,
  /// and links that lead to no file of the revision.
  [[nodiscard]] std::vector<std::string> list_files(const std::string& folder) const;

  /// Reads a file. Messages call the file NAME:PATH. Links are followed inside the revision. E111
  /// if the revision has no file at the end of the links.
  [[nodiscard]] Result<SourcePointer> read_source(const std::string& path,
                                                  const Limits& limits) const;

 private:
  struct Object {
    std::string mode = {};  ///< "100644"; "120000" for a link, "160000" for a submodule
    std::string id = {};
  };

  /// The object at the end of all links from `path`; null if the last link leads to no file of the
  /// revision.
  [[nodiscard]] Result<const Object*> resolve_links(const std::string& path) const;

  /// The first `most` bytes of the object; `path` is for messages.
  [[nodiscard]] Result<std::string> read_bytes(const Object& object, const std::string& path,
                                               std::size_t most) const;

  Revision(std::string name, std::string root) : name_(std::move(name)), root_(std::move(root)) {}

  std::string name_;
  std::string root_;
  std::map<std::string, Object> objects_ = {};
};

/// A model or scene with its equations, and the syntax trees into which the diagnostics point.
struct LoadedVersion {
  PipelineSources inputs = {};
  FileSyntax model = {};
  std::optional<FileSyntax> scene = {};
  Products products = {};
  OperationsByName operations = {};

  [[nodiscard]] Version version() const;
};

/// The base name of the system's files: MODEL or MODEL_SCENE. "" if the system has errors.
[[nodiscard]] std::string system_name(const PipelineSources& inputs, const Limits& limits);

/// The diagnostics of the stages before the derivation.
[[nodiscard]] Diagnostics inspection_diagnostics(const PipelineSources& inputs,
                                                 const Limits& limits);

/// Loads a system and lowers its equations. Fails with the diagnostics of the stages up to lower.
[[nodiscard]] Result<LoadedVersion> load_version(const PipelineSources& inputs,
                                                 const Limits& limits);

}  // namespace elgen::cli
