// names_model, declares_model: what tells texts of scenes, models and others apart where no file
// name does.
#pragma once

#include "elgen/source_text.hpp"

namespace elgen {

/// Whether the text is TOML with `model = "…"`; in a model file `model` is a table.
[[nodiscard]] bool names_model(const SourceText& source);

/// Whether the text is TOML with a table [model].
[[nodiscard]] bool declares_model(const SourceText& source);

}  // namespace elgen
