// Options: --outputs, --fix and --size, split into parts that point into the option's text.
#include "check/expressions/options.hpp"

#include <charconv>
#include <set>

#include "check/expressions/values.hpp"

namespace elgen {
namespace {

Span trimmed(Span span) {
  const std::string& text = span.source->text;
  while (span.begin < span.end && text[span.begin] == ' ') ++span.begin;
  while (span.begin < span.end && text[span.end - 1] == ' ') --span.end;
  return span;
}

OptionWord word_at(const Span& span) {
  const Span inner = trimmed(span);
  return {std::string(covered_text(inner)), inner};
}

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

std::vector<OptionWord> split_at_commas(const Span& text) {
  std::vector<OptionWord> words;
  int depth = 0;
  std::uint32_t begin = text.begin;
  for (std::uint32_t i = text.begin; i < text.end; ++i) {
    const char letter = text.source->text[i];
    if (letter == '(' || letter == '[') ++depth;
    if (letter == ')' || letter == ']') --depth;
    if (letter != ',' || depth > 0) continue;
    words.push_back(word_at({text.source, begin, i}));
    begin = i + 1;
  }
  words.push_back(word_at({text.source, begin, text.end}));
  return words;
}

std::vector<OptionWord> words_of(const std::vector<SourcePointer>& options) {
  std::vector<OptionWord> words;
  for (const SourcePointer& option : options) {
    const auto size = static_cast<std::uint32_t>(option->text.size());
    for (OptionWord& word : split_at_commas({option.get(), 0, size})) {
      words.push_back(std::move(word));
    }
  }
  return words;
}

std::vector<OptionWord> words_of(const std::vector<SourcePointer>& options, Report& report) {
  std::vector<OptionWord> words = words_of(options);
  std::set<std::string> names;
  for (const OptionWord& word : words) {
    OptionWord name = split_assignment(word).name;
    std::erase(name.text, ' ');
    if (names.insert(name.text).second) continue;
    report.add(Code::E606, name.span, in_backticks(name.text) + " is given twice");
  }
  return words;
}

Assignment split_assignment(const OptionWord& word) {
  const std::size_t equals = word.text.find('=');
  if (equals == std::string::npos) {
    return {word, {word.span.source, word.span.end, word.span.end}};
  }
  const std::uint32_t at = word.span.begin + static_cast<std::uint32_t>(equals);
  return {word_at({word.span.source, word.span.begin, at}),
          trimmed({word.span.source, at + 1, word.span.end})};
}

std::string canonical_text(const FileSyntax* scene, const SceneOptions& options) {
  std::string text = scene == nullptr ? "" : dump(*scene);
  for (const auto& [name, list] :
       {std::pair("outputs", &options.outputs), std::pair("fix", &options.fixed),
        std::pair("size", &options.sizes)}) {
    for (OptionWord& word : words_of(*list)) {
      std::erase(word.text, ' ');
      text += "--" + std::string(name) + " " + word.text + "\n";
    }
  }
  return text;
}

void read_sizes(Context& context, const FileSyntax& model, const FileSyntax* scene,
                const SceneOptions& options) {
  for (const KeySyntax& key : keys_of(&model, "sizes")) declare_size(context, key);
  for (const KeySyntax& key : keys_of(scene, "sizes")) {
    const Sizes nothing;
    const auto value = integer_value(key.value.expression, Scope(nothing), context.report);
    if (value) override_size(context, key.key, *value, key.key_span);
  }
  for (const OptionWord& word : words_of(options.sizes, context.report)) {
    read_option(context, word);
  }
}

}  // namespace elgen
