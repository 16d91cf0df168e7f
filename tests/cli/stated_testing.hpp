// Models with one [[expect]] entry of a test in the place of their own.
#pragma once

#include <string>

#include "cli/cli_testing.hpp"

namespace elgen::test {

/// Row theta of models/cart_pole.toml, divided by m l.
inline const std::string pole_row = "\"l*dot(dot(theta)) + cos(theta)*dot(dot(x)) = g*sin(theta)\"";

/// Runs `command` on `model` after one [[expect]] entry with `keys` has replaced its [[expect]]
/// entries.
inline Outcome run_with(const std::string& model, const std::string& keys,
                        const std::string& command) {
  const Workspace workspace;
  workspace.write("expect.toml", "[[expect]]\n" + keys);
  workspace.prepare("sed '/^\\[\\[expect\\]\\]/,$d' " + models + "/" + model +
                    ".toml > model.toml && cat expect.toml >> model.toml");
  return workspace.run("elgen " + command + " model.toml");
}

}  // namespace elgen::test
