// workshop: makes temporary directories by mkdtemp under $TMPDIR or /tmp. The destructor removes
// them recursively. A failed removal is not reported, because nothing depends on the removal. If
// memory is exhausted, the removal is tried a second time. Files have the same relative paths as in
// the output folder.
#include "toolchain/workshop.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <new>
#include <string>
#include <system_error>
#include <utility>

namespace elgen {
namespace {

bool write_file(const std::filesystem::path& path, const std::string& text) {
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  stream.close();
  return stream.good();
}

bool write_sources(const std::filesystem::path& directory, const EmittedFiles& files,
                   const std::vector<SourceFile>& sources) {
  const bool headers = std::all_of(
      files.files.begin(), files.files.end(),
      [&directory](const auto& file) { return write_file(directory / file.first, file.second); });
  return headers &&
         std::all_of(sources.begin(), sources.end(), [&directory](const SourceFile& source) {
           return write_file(directory / source.file, source.text);
         });
}

Diagnostic error_without_span(Code code, std::string message) {
  return {code, {}, std::move(message)};
}

}  // namespace

Result<TemporaryDirectory> make_source_directory(const EmittedFiles& files,
                                                 const std::vector<SourceFile>& sources) {
  std::optional<TemporaryDirectory> directory = TemporaryDirectory::create();
  if (directory && write_sources(directory->path(), files, sources)) return std::move(*directory);
  return error_without_span(Code::E706,
                            "no temporary directory could be written; $TMPDIR names another");
}

std::optional<TemporaryDirectory> TemporaryDirectory::create() {
  const char* parent = std::getenv("TMPDIR");
  std::string name = (parent != nullptr && *parent != '\0') ? parent : "/tmp";
  name += "/elgen-XXXXXX";
  if (mkdtemp(name.data()) == nullptr) return std::nullopt;
  return TemporaryDirectory(name);
}

TemporaryDirectory::TemporaryDirectory(TemporaryDirectory&& other) noexcept
    : path_(std::exchange(other.path_, {})) {}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  for (int attempt = 0; attempt < 2 && !path_.empty(); ++attempt) {
    try {
      std::filesystem::remove_all(path_, ignored);
      path_.clear();
    } catch (const std::bad_alloc&) {
    }
  }
}

Result<CompilerSession> CompilerSession::open(const EmittedFiles& files,
                                              const std::vector<SourceFile>& sources,
                                              const Limits& limits) {
  Result<TemporaryDirectory> directory = make_source_directory(files, sources);
  if (!directory) return directory.diagnostics;
  Result<Compiler> compiler = find_compiler(limits.seconds);
  if (!compiler) return compiler.diagnostics;
  return CompilerSession(std::move(*directory), std::move(*compiler));
}

Result<SharedLibrary> CompilerSession::build(const SourceFile& source, BuildFlags build) const {
  const std::filesystem::path& directory = directory_.path();
  const std::filesystem::path object = directory / (source.file + ".so");
  const ProcessResult compiled = compile_shared(compiler_, build, directory / source.file, object);
  if (!compiled.succeeded()) return compile_error(compiler_, compiled, directory, source);
  SharedLibrary library(object);
  if (!library.is_loaded()) {
    return error_without_span(Code::E709,
                              fmt::format("the output of `{}` could not be loaded: {}",
                                          fmt::join(compiler_.command, " "), dlerror()));
  }
  return library;
}

bool CompilerSession::accepts_flags(BuildFlags build, const SourceFile& source) const {
  return accepts_probe(compiler_, build, directory_.path(), source);
}

Diagnostic missing_function_error() {
  return error_without_span(Code::E705, "a compiled function is missing from the loaded object");
}

}  // namespace elgen
