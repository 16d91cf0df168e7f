// Options: --outputs, --fix and --size, split into parts that point into the option's text.
#pragma once

#include <string>
#include <vector>

#include "check/expressions/expand.hpp"
#include "check/names/report.hpp"
#include "elgen/scene.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// A word of an option, with where it stands.
struct OptionWord {
  std::string text;
  Span span;
};

/// "a,b" split at commas, spaces trimmed.
[[nodiscard]] std::vector<OptionWord> words_of(const std::vector<SourcePointer>& options);

/// "NAME=VALUE"; without "=" the value's span is empty.
struct Assignment {
  OptionWord name;
  Span value;
};
[[nodiscard]] Assignment split_assignment(const OptionWord& word);

/// Sizes of the scene, then of --size. E606.
[[nodiscard]] std::vector<SizeOverride> size_overrides(const FileSyntax* scene,
                                                       const SceneOptions& options, Report& report);

/// What a scene and options say of a model; "" where there is neither.
[[nodiscard]] std::string canonical_text(const FileSyntax* scene, const SceneOptions& options);

}  // namespace elgen
