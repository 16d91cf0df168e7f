// names_model: what tells the text of a scene from that of a model where no file name does.
#pragma once

#include "elgen/source_text.hpp"

namespace elgen {

/// Whether the text is TOML with `model = "…"`; in a model file `model` is a table.
[[nodiscard]] bool names_model(const SourceText& source);

}  // namespace elgen
