// Options: --outputs, --fix and --size, split into parts that point into the option's text.
#include "check/expressions/options.hpp"

#include <cln/integer.h>

#include <charconv>

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

void read_size(const OptionWord& word, std::vector<SizeOverride>& sizes, Report& report) {
  const Assignment assignment = split_assignment(word);
  const std::string text(covered_text(assignment.value));
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::invalid_argument || stop != text.data() + text.size()) {
    report.add(Code::E606, word.span, quoted(word.text) + " is not of the form `n=20`");
    return;
  }
  if (error != std::errc{} || value < -largest_integer || value > largest_integer) {
    report.add(Code::E606, assignment.value,
               quoted(text) + " is beyond " + std::to_string(largest_integer));
    return;
  }
  sizes.push_back({assignment.name.text, value, assignment.name.span});
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

std::vector<SizeOverride> size_overrides(const FileSyntax* scene, const SceneOptions& options,
                                         Report& report) {
  std::vector<SizeOverride> sizes;
  if (const EntrySyntax* entry = find_entry(scene, "sizes")) {
    for (const KeySyntax& key : entry->keys) {
      const Sizes nothing;
      const auto value = integer_value(key.value.expression, Scope(nothing), report);
      if (value) {
        sizes.push_back({key.key, *value, key.key_span});
      }
    }
  }
  for (const OptionWord& word : words_of(options.sizes)) {
    read_size(word, sizes, report);
  }
  return sizes;
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
