// Versions: the files of a revision of git, read from its objects; and a model or scene, loaded for
// a comparison.
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

/// Paths are relative to the root of the repository. An error of git becomes E713 with its message.
class Revision {
 public:
  /// A commit of the repository that contains the working directory.
  [[nodiscard]] static Result<Revision> open(const std::string& name);

  /// The path of a file or folder of the working tree. E713 outside of the tree, and in a
  /// submodule.
  [[nodiscard]] Result<std::string> path_of(const std::string& path) const;

  [[nodiscard]] bool has(const std::string& path) const { return objects_.count(path) > 0; }

  /// The files below a folder, with paths relative to it; "" is the root. Links that lead to no
  /// file are omitted.
  [[nodiscard]] std::vector<std::string> files_below(const std::string& folder) const;

  /// Messages call the source NAME:PATH. Links lead to files of the same revision. E111 if there is
  /// no such file.
  [[nodiscard]] Result<SourcePointer> read(const std::string& path, const Limits& limits) const;

 private:
  struct Object {
    std::string mode = {};  ///< "100644"; "120000": a link; "160000": a submodule
    std::string id = {};
  };

  /// The object at the end of all links; null if it is no file of the revision.
  [[nodiscard]] Result<const Object*> resolve_links(const std::string& path) const;

  /// The first `most` bytes; `path` is for messages.
  [[nodiscard]] Result<std::string> bytes(const Object& object, const std::string& path,
                                          std::size_t most) const;

  Revision(std::string name, std::string root) : name_(std::move(name)), root_(std::move(root)) {}

  std::string name_;
  std::string root_;
  std::map<std::string, Object> objects_ = {};
};

/// A model or scene with its equations, and the syntax trees that these point into.
struct LoadedVersion {
  Inputs inputs = {};
  FileSyntax model = {};
  std::optional<FileSyntax> scene = {};
  Products products = {};
  OperationsByName operations = {};

  [[nodiscard]] Version version() const;
};

/// The base name of the system's files: MODEL, or MODEL_SCENE. "" if it has errors.
[[nodiscard]] std::string system_name(const Inputs& inputs, const Limits& limits);

/// Errors and warnings of the stages before the equations are derived.
[[nodiscard]] Diagnostics mistakes(const Inputs& inputs, const Limits& limits);

/// Errors of the stages up to the equations.
[[nodiscard]] Result<LoadedVersion> load_version(const Inputs& inputs, const Limits& limits);

}  // namespace elgen::cli
