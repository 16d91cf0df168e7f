// dumps: what a stage hands on -> its text for `--dump`, where the stage has none of its own.
#pragma once

#include <optional>
#include <string>

#include "elgen/certificate.hpp"
#include "elgen/scene.hpp"
#include "elgen/syntax.hpp"
#include "pipeline/readable_steps.hpp"

namespace elgen {

struct Syntaxes {
  FileSyntax model;
  std::optional<FileSyntax> scene;
};

/// inspect only reports; its dump is what it found.
struct Inspection {
  Diagnostics found;
};

[[nodiscard]] std::string dump(const Syntaxes& syntaxes);
[[nodiscard]] std::string dump(const CheckedModel& checked);
[[nodiscard]] std::string dump(const Inspection& inspection);
[[nodiscard]] std::string dump(const ReadableSteps& steps);
[[nodiscard]] std::string dump(const SelfCheck& check);

}  // namespace elgen
