// names_model, declares_model: what tells texts of scenes, models and others apart where no file
// name does.
#pragma once

#include <optional>

#include "elgen/source_text.hpp"

namespace elgen {

/// The value of `model = "…"`, where the text is TOML that has it: in a model file `model` is a
/// table.
[[nodiscard]] std::optional<Span> named_model(const SourceText& source);

/// Whether the text is TOML with a table [model].
[[nodiscard]] bool declares_model(const SourceText& source);

}  // namespace elgen
