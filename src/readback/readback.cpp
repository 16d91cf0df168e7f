// readback: which file is read how; the first mistake of each becomes a diagnostic.
#include "elgen/readback.hpp"

#include <algorithm>

#include "elgen/artifacts.hpp"
#include "elgen/wording.hpp"
#include "readback/batch_reader.hpp"
#include "readback/header_reader.hpp"
#include "readback/page_readers.hpp"

namespace elgen {
namespace {

class FilesReader {
 public:
  FilesReader(const std::vector<SourcePointer>& files, const CheckedModel& checked,
              const Program& program)
      : files_(files), origin_{checked.model, checked.scene, program}, equations_(origin_) {}

  Result<Readback> read() {
    for (const Artifact& artifact : artifacts_of(origin_.scene)) read(artifact);
    result_.equations = equations_.compared();
    if (!diagnostics_.empty()) return diagnostics_;
    return result_;
  }

 private:
  void read(const Artifact& artifact) {
    const auto found = std::find_if(files_.begin(), files_.end(), [&](const SourcePointer& file) {
      return file->path == artifact.path;
    });
    if (found == files_.end()) {
      diagnostics_.push_back({Code::E915, {}, in_backticks(artifact.path) + " is missing"});
      return;
    }
    try {
      (this->*readers[artifact.id])(**found);
      ++result_.files;
    } catch (const Mistake& mistake) {
      diagnostics_.push_back(mistake.diagnostic);
    }
  }

  void header(const SourceText& text) {
    TokenReader tokens(text);
    scope_.emplace(read_header(tokens, origin_, equations_));
    result_.functions += origin_.program.functions.size();
  }

  /// Its numbers are those of the other header.
  void eigen_header(const SourceText& text) {
    if (!scope_) return;
    TokenReader tokens(text);
    read_eigen_header(tokens, *scope_);
    result_.functions += origin_.program.functions.size();
  }

  void batch_header(const SourceText& text) {
    TokenReader tokens(text);
    read_batch_header(tokens, origin_);
  }

  void sidecar(const SourceText& text) { read_sidecar(text, origin_, equations_); }
  void page(const SourceText& text) { read_page(text, origin_, equations_); }

  using Read = void (FilesReader::*)(const SourceText& text);
  static constexpr PerArtifact<Read> readers{.cpp = &FilesReader::header,
                                             .eigen = &FilesReader::eigen_header,
                                             .batch = &FilesReader::batch_header,
                                             .c99 = &FilesReader::header,
                                             .sidecar = &FilesReader::sidecar,
                                             .page = &FilesReader::page};

  const std::vector<SourcePointer>& files_;
  Origin origin_;
  EquationReader equations_;
  std::optional<FileScope> scope_ = {};
  Readback result_ = {};
  Diagnostics diagnostics_ = {};
};

}  // namespace

Result<Readback> read_back(const std::vector<SourcePointer>& files, const CheckedModel& checked,
                           const Program& program) {
  return FilesReader(files, checked, program).read();
}

Diagnostics read_back_page(const SourcePointer& page, const CheckedModel& checked,
                           const Program& program) {
  const Origin origin{checked.model, checked.scene, program};
  EquationReader equations(origin);
  try {
    read_text(*page, origin, equations);
    return {};
  } catch (const Mistake& mistake) {
    return {mistake.diagnostic};
  }
}

std::string receipt(const Readback& readback) {
  return counted(readback.files, "file") + " read back";
}

}  // namespace elgen
