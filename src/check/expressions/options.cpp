// Options: --outputs, --fix and --size, split into parts that point into the option's text.
#include "check/expressions/options.hpp"

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

}  // namespace elgen
