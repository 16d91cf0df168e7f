// Compares two versions of a model.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <utility>

#include "elgen/diff.hpp"
#include "elgen/pipeline.hpp"
#include "support/inputs.hpp"
#include "support/models.hpp"
#include "support/shell.hpp"

namespace elgen::test {

/// The parsed model and scene of one version, and the products of the pipeline.
struct LoweredVersion {
  FileSyntax model = {};
  std::optional<FileSyntax> scene = {};
  Products products = {};

  [[nodiscard]] Version version() const {
    return {model, scene ? &*scene : nullptr, *products.checked,
            products.program ? *products.program : *products.lowered, products.diagnostics};
  }
};

/// The model `text` with its products up to the stage `goal`; `scene` is the text after the scene's
/// name.
inline LoweredVersion lowered(const std::string& text, const std::string& scene = {},
                              Goal goal = Goal::lower) {
  PipelineOptions options;
  options.goals = {goal};
  const PipelineSources inputs = inputs_of(text, scene);
  static std::vector<SourcePointer> alive;  // spans of reports point into the sources
  alive.insert(alive.end(), {inputs.model, inputs.scene});
  LoweredVersion result{.products = run_pipeline(inputs, options)};
  INFO(format(result.products.diagnostics));
  REQUIRE((result.products.lowered || result.products.program));
  result.model = *parse_model(inputs.model, {});
  if (inputs.scene) result.scene = *parse_scene(inputs.scene, {});
  return result;
}

inline SystemChange compared(const std::string& before, const std::string& after,
                             const Renames& renames = {}) {
  const LoweredVersion old = lowered(before);
  const LoweredVersion now = lowered(after);
  return compare(old.version(), now.version(), {.renames = renames});
}

inline const std::string cart = model_file("cart_pole");

/// The entries of `output` that are not identical in the two versions.
inline std::vector<EntryChange> entries_of(const SystemChange& system, const std::string& output) {
  for (const OutputChange& change : system.outputs) {
    if (change.name == output) return change.entries;
  }
  return {};
}

/// The number of entries with `verdict`, summed over all outputs.
inline std::ptrdiff_t count_of(const SystemChange& system, EntryVerdict verdict) {
  std::ptrdiff_t all = 0;
  for (const OutputChange& output : system.outputs) {
    all += std::ranges::count(output.entries, verdict, &EntryChange::verdict);
  }
  return all;
}

/// True if the code of callers compiles, but with another meaning.
inline bool breaks_silently(const SystemChange& system) {
  return system.impact == Impact::breaks &&
         std::ranges::count(system.interface, true, &InterfaceChange::is_silent) > 0;
}

/// A model with three coordinates and the [[constraint]] entries `constraints`.
inline std::string held_plane(const std::string& constraints) {
  return model_text("held_plane", R"toml([[coordinate]]
name = "x"
start = { value = 1 }
[[coordinate]]
name = "y"
[[coordinate]]
name = "z"
[energy]
T = "dot(x)^2 + 2*dot(y)^2 + 3*dot(z)^2"
)toml" + constraints);
}

inline const std::string held_rod =
    "[[constraint]]\nname = \"rod\"\nequation = \"x^2 + y^2 = 1\"\n";
inline const std::string held_slot = "[[constraint]]\nname = \"slot\"\nequation = \"z = y\"\n";

/// A mass m on a spring k at x.
inline std::string spring(const std::string& potential = "1/2*k*x^2") {
  return model_text("spring", R"toml([[coordinate]]
name = "x"
[parameters]
m = { value = 2, assume = "positive" }
k = 3
[energy]
T = "1/2*m*dot(x)^2"
V = ")toml" + potential + "\"\n");
}

}  // namespace elgen::test
