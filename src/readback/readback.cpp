// readback: which file is read how; the first mistake of each becomes a diagnostic.
#include "elgen/readback.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "elgen/wording.hpp"
#include "header_reader.hpp"
#include "page_reader.hpp"
#include "sidecar_reader.hpp"
#include "text_reader.hpp"

namespace elgen {
namespace {

using namespace reading;

class Reading {
 public:
  Reading(const std::vector<SourcePointer>& files, const CheckedModel& checked,
          const Program& program)
      : files_(files), origin_{checked.model, checked.scene, program}, equations_(origin_) {}

  Result<Readback> read() {
    const Emission& emission = origin_.scene.emission;
    const std::string header(language_row(emission.language).ending);
    std::optional<FileScope> scope;
    read_file(".equations.json",
              [&](const SourceText& text) { read_sidecar(text, origin_, equations_); });
    read_file(header, [&](const SourceText& text) {
      TokenReader tokens(text);
      scope.emplace(read_header(tokens, origin_, equations_));
      result_.functions += origin_.program.functions.size();
    });
    if (emission.eigen && scope) {
      read_file("_eigen.hpp", [&](const SourceText& text) {
        TokenReader tokens(text);
        read_eigen_header(tokens, *scope);
        result_.functions += origin_.program.functions.size();
      });
    }
    read_file(".md", [&](const SourceText& text) { read_page(text, origin_, equations_); });
    result_.equations = equations_.compared();
    if (!diagnostics_.empty()) return diagnostics_;
    return result_;
  }

 private:
  template <class Reader>
  void read_file(const std::string& ending, const Reader& reader) {
    const std::string path = fmt::format("{0}/{0}{1}", origin_.scene.base_name, ending);
    const auto found = std::find_if(files_.begin(), files_.end(),
                                    [&](const SourcePointer& file) { return file->path == path; });
    if (found == files_.end()) {
      diagnostics_.push_back({Code::E915, {}, quoted(path) + " is missing"});
      return;
    }
    try {
      reader(**found);
      ++result_.files;
    } catch (const Mistake& mistake) {
      diagnostics_.push_back(mistake.diagnostic);
    }
  }

  const std::vector<SourcePointer>& files_;
  Origin origin_;
  EquationReader equations_;
  Readback result_ = {};
  Diagnostics diagnostics_ = {};
};

}  // namespace

Result<Readback> read_back(const std::vector<SourcePointer>& files, const CheckedModel& checked,
                           const Program& program) {
  return Reading(files, checked, program).read();
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

std::string dump(const Readback& readback) { return receipt(readback) + "\n"; }

}  // namespace elgen
