// emission_input: hashes and printed equations. Of the path of a model only the file name is used,
// so that the same model gives the same bytes in every folder.
#include "emit/text/emission_input.hpp"

#include <fmt/format.h>

#include "elgen/emitted_files.hpp"
#include "emit/text/layout.hpp"
#include "emit/text/stamp.hpp"

namespace elgen {
namespace {

std::string file_name(const SourcePointer& source) {
  if (source == nullptr) return "a model";
  const std::size_t slash = source->path.find_last_of("/\\");
  return comment_text(slash == std::string::npos ? source->path : source->path.substr(slash + 1));
}

}  // namespace

EmissionInput emission_input(const Model& model, const Scene& scene, const Program& program) {
  std::vector<FunctionEquations> printed;
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    printed.push_back(readable_equations(program, i));
  }
  return {model,
          scene,
          program,
          std::move(printed),
          fmt::format("{} from {}. DO NOT EDIT.", generated_marker, file_name(model.source)),
          content_hash(model.canonical),
          scene.canonical.empty() ? "full" : content_hash(scene.canonical)};
}

}  // namespace elgen
