// emission_input: hashes and printed equations.
#include "emit/text/emission_input.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "base/content_hash.hpp"
#include "elgen/emitted_files.hpp"
#include "emit/text/layout.hpp"

namespace elgen {
namespace {

constexpr std::string_view scene_of_model = " of ";
constexpr std::string_view end_of_sources = ". DO NOT EDIT.";

/// "cart_pole.toml", "cart_pole_balance.scene.toml of cart_pole.toml"
std::string sources(const SourcePaths& paths) {
  const std::string model = comment_text(paths.model);
  return paths.scene.empty()
             ? model
             : fmt::format("{}{}{}", comment_text(paths.scene), scene_of_model, model);
}

}  // namespace

SourcePaths stated_paths(std::string_view text) {
  const std::string start = fmt::format("{} from ", generated_marker);
  const std::size_t at = text.find(start);
  if (at == std::string_view::npos) return {};
  std::string_view stated = text.substr(at + start.size());
  stated = stated.substr(0, stated.find(end_of_sources));
  for (const std::string scene_ending : {".scene.toml", "<stdin>"}) {
    const std::size_t found = stated.find(scene_ending + std::string(scene_of_model));
    if (found == std::string_view::npos) continue;
    const std::size_t end = found + scene_ending.size();
    return {std::string(stated.substr(end + scene_of_model.size())),
            std::string(stated.substr(0, end))};
  }
  return {std::string(stated), {}};
}

EmissionInput emission_input(const Model& model, const Scene& scene, const Program& program,
                             const Book& book) {
  std::vector<FunctionEquations> printed;
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    printed.push_back(readable_equations(program, i));
  }
  return {model,
          scene,
          program,
          book,
          std::move(printed),
          fmt::format("{} from {}{}", generated_marker, sources(scene.paths), end_of_sources),
          content_hash(model.canonical),
          scene.canonical.empty() ? "full" : content_hash(scene.canonical)};
}

}  // namespace elgen
