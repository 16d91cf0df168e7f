// Model texts -> checked models, for the tests of every stage after check.
#pragma once

#include <stdexcept>
#include <string>

#include "elgen/scene.hpp"

namespace elgen::test {

/// parse and check; throws the formatted errors.
inline CheckedModel checked_model(const std::string& text, const SceneOptions& options = {}) {
  const Limits limits;
  const SourcePointer source = make_source("test.toml", text);
  Result<ModelSyntax> syntax = parse_model(source, limits);
  if (!syntax) throw std::runtime_error(format(syntax.diagnostics));
  Result<CheckedModel> checked = check(*syntax, nullptr, options, limits);
  if (!checked) throw std::runtime_error(format(checked.diagnostics));
  return *checked;
}

/// The same with the text of a scene file.
inline CheckedModel checked_scene(const std::string& model, const std::string& scene) {
  const Limits limits;
  const Result<ModelSyntax> syntax = parse_model(make_source("test.toml", model), limits);
  if (!syntax) throw std::runtime_error(format(syntax.diagnostics));
  const Result<SceneSyntax> wanted = parse_scene(make_source("test.scene.toml", scene), limits);
  if (!wanted) throw std::runtime_error(format(wanted.diagnostics));
  const Result<CheckedModel> checked = check(*syntax, &*wanted, {}, limits);
  if (!checked) throw std::runtime_error(format(checked.diagnostics));
  return *checked;
}

/// A scene that expands, by the lines of its `[approximate]`.
inline CheckedModel approximated(const std::string& model, const std::string& lines) {
  return checked_scene(model,
                       "format = 1\nmodel = \"test.toml\"\nname = \"near\"\n"
                       "[approximate]\n" +
                           lines + "\n");
}

/// A model of the given coordinates (unit 1 apart, nothing checked) and the rest of the file as
/// written.
inline std::string model_text(const std::string& name, const std::string& rest) {
  return "format = 1\n[model]\nname = \"" + name + "\"\n" + rest;
}

}  // namespace elgen::test
