// Model texts -> checked models, for the tests of every stage after check.
#pragma once

#include <stdexcept>
#include <string>

#include "elgen/scene.hpp"

namespace elgen::test {

/// parse and check; throws the formatted errors. `scene` may be null.
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

/// The model in a scene of which `rest` is what follows the name.
inline CheckedModel checked_scene(const std::string& text, const std::string& rest) {
  const SourcePointer source = make_source(
      "test.scene.toml", "format = 1\nmodel = \"test.toml\"\nname = \"scene\"\n" + rest);
  Result<FileSyntax> scene = parse_scene(source, Limits{});
  if (!scene) throw std::runtime_error(format(scene.diagnostics));
  return checked_model(text, &*scene, SceneOptions{});
}

/// A scene that expands, by the lines of its `[approximate]`.
inline CheckedModel approximated(const std::string& model, const std::string& lines) {
  return checked_scene(model, "[approximate]\n" + lines + "\n");
}

/// A model of the given coordinates (unit 1 apart, nothing checked) and the rest of the file as
/// written.
inline std::string model_text(const std::string& name, const std::string& rest) {
  return "format = 1\n[model]\nname = \"" + name + "\"\n" + rest;
}

}  // namespace elgen::test
