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

void split_at_commas(const SourceText& source, std::vector<OptionWord>& words) {
  const auto size = static_cast<std::uint32_t>(source.text.size());
  std::uint32_t begin = 0;
  while (begin <= size) {
    const std::size_t comma = source.text.find(',', begin);
    const auto end = comma == std::string::npos ? size : static_cast<std::uint32_t>(comma);
    words.push_back(word_at({&source, begin, end}));
    begin = end + 1;
  }
}

}  // namespace

std::vector<OptionWord> words_of(const std::vector<SourcePointer>& options) {
  std::vector<OptionWord> words;
  for (const SourcePointer& option : options) {
    split_at_commas(*option, words);
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
