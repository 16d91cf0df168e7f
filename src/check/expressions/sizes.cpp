// Sizes: the integers repetitions run to, as the model has them or as a scene overrides them.
#include <charconv>

#include "check/expressions/options.hpp"
#include "check/expressions/values.hpp"

namespace elgen {
namespace {

void declare_size(Context& context, const KeySyntax& key) {
  const Scope nothing(context.sizes);
  const auto value = integer_value(key.value.expression, nothing, context.report);
  if (!value ||
      !context.symbols.declare({key.key, {}, key.key_span}, SymbolKind::size, 0, context.report)) {
    return;
  }
  context.sizes[key.key] = *value;
}

void override_size(Context& context, const std::string& size, std::int64_t number,
                   const Span& span) {
  const auto found = context.sizes.find(size);
  if (found != context.sizes.end()) {
    found->second = number;
    return;
  }
  std::vector<std::string> names;
  for (const auto& [name, value] : context.sizes) {
    names.push_back(name);
  }
  context.report.add(Code::E605, span, "unknown size " + in_backticks(size),
                     suggestion(size, names));
}

/// "n=20"
void read_option(Context& context, const OptionWord& word) {
  const Assignment assignment = split_assignment(word);
  const std::string text(covered_text(assignment.value));
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::invalid_argument || stop != text.data() + text.size()) {
    context.report.add(Code::E606, word.span,
                       in_backticks(word.text) + " is not of the form `n=20`");
    return;
  }
  if (error != std::errc{} || value < -largest_integer || value > largest_integer) {
    context.report.add(Code::E606, assignment.value,
                       in_backticks(text) + " is beyond " + std::to_string(largest_integer));
    return;
  }
  override_size(context, assignment.name.text, value, assignment.name.span);
}

}  // namespace

void read_sizes(Context& context, const FileSyntax& model, const FileSyntax* scene,
                const SceneOptions& options) {
  for (const KeySyntax& key : keys_of(&model, "sizes")) declare_size(context, key);
  for (const KeySyntax& key : keys_of(scene, "sizes")) {
    const Sizes nothing;
    const auto value = integer_value(key.value.expression, Scope(nothing), context.report);
    if (value) override_size(context, key.key, *value, key.key_span);
  }
  for (const OptionWord& word : words_of(options.sizes)) read_option(context, word);
}

}  // namespace elgen
