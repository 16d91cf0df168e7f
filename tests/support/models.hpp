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

/// The model in a scene; `rest` is the text of the scene after its name.
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

/// The text of a model file with the name `name`; `rest` is the text after the name.
inline std::string model_text(const std::string& name, const std::string& rest) {
  return "format = 1\n[model]\nname = \"" + name + "\"\n" + rest;
}

/// The parameters that several arms share, without units.
inline const std::string& frame_parameters() {
  static const std::string text = R"toml(
[parameters]
m1 = 2
m2 = "3/2"
l = "7/10"
A = "3/10"
B = "2/5"
C = "1/2"
D = "1/20"
E = "3/100"
F = "-1/50"
Omega = "2/5"
g = 9.81
[gravity]
vector = ["g/10", "-g/7", "-g"]
)toml";
  return text;
}

inline std::string frame_model(const std::string& name, const std::string& coordinates,
                               const std::string& rest) {
  std::string text;
  std::string word;
  for (const char letter : coordinates + " ") {
    if (letter != ' ') {
      word += letter;
      continue;
    }
    text += "[[coordinate]]\nname = \"" + word + "\"\n";
    word.clear();
  }
  return model_text(name, text + frame_parameters() + rest);
}

}  // namespace elgen::test
