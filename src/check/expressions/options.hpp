// Options: --outputs, --fix and --size, split into parts that point into the option's text; and the
// sizes of a model, which options are the last to set.
#pragma once

#include <string>
#include <vector>

#include "check/names/context.hpp"
#include "elgen/scene.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// A word of an option, with where it stands.
struct OptionWord {
  std::string text;
  Span span;
};

/// "a,[b,c]" split at commas outside of brackets, spaces trimmed.
[[nodiscard]] std::vector<OptionWord> split_at_commas(const Span& text);
[[nodiscard]] std::vector<OptionWord> words_of(const std::vector<SourcePointer>& options);
/// The options that say something of names: E606 where one has the name of an earlier one.
[[nodiscard]] std::vector<OptionWord> words_of(const std::vector<SourcePointer>& options,
                                               Report& report);

/// "NAME=VALUE"; without "=" the value's span is empty.
struct Assignment {
  OptionWord name;
  Span value;
};
[[nodiscard]] Assignment split_assignment(const OptionWord& word);

/// Declares the sizes of the model, then sets them as the scene and at last as the options say.
/// `scene` may be null. E605, E606.
void read_sizes(Context& context, const FileSyntax& model, const FileSyntax* scene,
                const SceneOptions& options);

/// The canonical text of a scene and options; "" where there is neither.
[[nodiscard]] std::string canonical_text(const FileSyntax* scene, const SceneOptions& options);

}  // namespace elgen
