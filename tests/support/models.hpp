// Checked models from model texts, for the tests of all stages after check.
#pragma once

#include <stdexcept>
#include <string>

#include "elgen/scene.hpp"
#include "support/text.hpp"

namespace elgen::test {

/// Parses and checks a model; throws the formatted errors. `scene` may be null.
inline CheckedModel checked_model(const std::string& text, const FileSyntax* scene,
                                  const SceneOptions& options) {
  const Limits limits;
  const SourcePointer source = make_source("test.toml", text);
  Result<FileSyntax> syntax = parse_model(source, limits);
  if (!syntax) throw std::runtime_error(format(syntax.diagnostics));
  Result<CheckedModel> checked = check(*syntax, scene, options, limits);
  if (!checked) throw std::runtime_error(format(checked.diagnostics));
  return *checked;
}

inline CheckedModel checked_model(const std::string& text, const SceneOptions& options = {}) {
  return checked_model(text, nullptr, options);
}

/// The model in a scene; `rest` follows the scene's name.
inline CheckedModel checked_scene(const std::string& text, const std::string& rest) {
  const SourcePointer source = make_source(
      "test.scene.toml", "format = 1\nmodel = \"test.toml\"\nname = \"scene\"\n" + rest);
  Result<FileSyntax> scene = parse_scene(source, Limits{});
  if (!scene) throw std::runtime_error(format(scene.diagnostics));
  return checked_model(text, &*scene, SceneOptions{});
}

/// The model in a scene with an expansion; `lines` are the lines of `[approximate]`.
inline CheckedModel approximated(const std::string& model, const std::string& lines) {
  return checked_scene(model, "[approximate]\n" + lines + "\n");
}

/// A model file with this name; `rest` is the other entries as written.
inline std::string model_text(const std::string& name, const std::string& rest) {
  return "format = 1\n[model]\nname = \"" + name + "\"\n" + rest;
}

}  // namespace elgen::test
