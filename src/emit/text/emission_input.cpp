// SPDX-License-Identifier: GPL-3.0-or-later
// emission_input: hashes and printed equations.
#include "emit/text/emission_input.hpp"

#include <fmt/format.h>

#include "base/content_hash.hpp"
#include "elgen/emitted_files.hpp"
#include "emit/text/layout.hpp"

namespace elgen {
namespace {

/// "cart_pole.toml", "cart_pole_balance.scene.toml of cart_pole.toml"
std::string sources(const SourcePaths& paths) {
  const std::string model = comment_text(paths.model);
  return paths.scene.empty() ? model : fmt::format("{} of {}", comment_text(paths.scene), model);
}

}  // namespace

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
          fmt::format("{} from {}. DO NOT EDIT.", generated_marker, sources(scene.paths)),
          content_hash(model.canonical),
          scene.canonical.empty() ? "full" : content_hash(scene.canonical)};
}

}  // namespace elgen
