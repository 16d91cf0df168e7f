// Command-line options as keys of a table; every key and value has its span in the option:
//
//     "x=1, dot(x)=0, e=[1,0]"   ->   x = 1, "dot(x)" = 0, e = [1, 0]
//     "x=-1..2", "x=-1:2"        ->   x = [-1, 2]
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "elgen/syntax.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

Span trim(Span span) {
  const std::string& text = span.source->text;
  while (span.begin < span.end && text[span.begin] == ' ') ++span.begin;
  while (span.begin < span.end && text[span.end - 1] == ' ') --span.end;
  return span;
}

class OptionReader {
 public:
  OptionReader(KeyType type, const Limits& limits) : type_(type), limits_(limits) {}

  void read_word(const Span& word) {
    const std::string_view text = covered_text(word);
    const auto equals = static_cast<std::uint32_t>(std::min(text.find('='), text.size()));
    KeySyntax key;
    key.key_span = trim({word.source, word.begin, word.begin + equals});
    key.key = covered_text(key.key_span);
    std::erase(key.key, ' ');
    if (std::ranges::find(keys_, key.key, &KeySyntax::key) != keys_.end()) {
      return report_error(key.key_span, quote_text(key.key) + " is given twice");
    }
    key.value.span = {word.source, std::min(word.begin + equals + 1, word.end), word.end};
    key.value.span = trim(key.value.span);
    const bool is_alone = equals == text.size();
    if (is_alone && type_ == KeyType::boolean_or_expression) {
      key.value.kind = ValueKind::boolean;
      key.value.boolean = true;
    } else if (key.value.span.begin == key.value.span.end) {
      return report_error(word, in_backticks(word) + " has no value");
    } else if (!read_value(key.value)) {
      return;
    }
    keys_.push_back(std::move(key));
  }

  Result<std::vector<KeySyntax>> take_keys() { return {std::move(keys_), std::move(problems_)}; }

 private:
  void report_error(const Span& span, std::string message, std::string hint = {}) {
    problems_.push_back({Code::E606, span, std::move(message), std::move(hint)});
  }

  /// Reads `value` from the bytes of its span. False after an error.
  bool read_value(ValueSyntax& value) {
    if (type_ == KeyType::range) return read_range(value);
    const std::string_view text = covered_text(value.span);
    const bool is_list =
        type_ == KeyType::expression_or_list && text.starts_with('[') && text.ends_with(']');
    if (!is_list) return read_expression(value);
    const Span inside{value.span.source, value.span.begin + 1, value.span.end - 1};
    return read_items(value, split_at_commas(inside));
  }

  bool read_range(ValueSyntax& value) {
    const auto& [source, begin, end] = value.span;
    const std::string_view text = covered_text(value.span);
    const std::string_view separator = text.find("..") != std::string_view::npos ? ".." : ":";
    const std::size_t low_length = text.find(separator);
    if (low_length == std::string_view::npos) {
      report_error(value.span, in_backticks(value.span) + " is no range", "write NAME=LOW..HIGH");
      return false;
    }
    const std::uint32_t middle = begin + static_cast<std::uint32_t>(low_length);
    const std::uint32_t high = middle + static_cast<std::uint32_t>(separator.size());
    return read_items(value, {{source, begin, middle}, {source, high, end}});
  }

  bool read_items(ValueSyntax& value, const std::vector<Span>& items) {
    value.kind = ValueKind::list;
    bool is_read = true;
    for (const Span& item : items) {
      value.items.emplace_back().span = trim(item);
      is_read = read_expression(value.items.back()) && is_read;
    }
    return is_read;
  }

  bool read_expression(ValueSyntax& value) {
    value.kind = ValueKind::expression;
    value.text = covered_text(value.span);
    Result<ExpressionSyntax> read = parse_expression(value.span, limits_);
    problems_.insert(problems_.end(), read.diagnostics.begin(), read.diagnostics.end());
    if (read) value.expression = *std::move(read.value);
    return read.value.has_value();
  }

  KeyType type_;
  const Limits& limits_;
  std::vector<KeySyntax> keys_ = {};
  Diagnostics problems_ = {};
};

}  // namespace

std::vector<Span> split_at_commas(const Span& text) {
  std::vector<Span> words;
  int depth = 0;
  std::uint32_t begin = text.begin;
  for (std::uint32_t i = text.begin; i < text.end; ++i) {
    const char letter = text.source->text[i];
    if (letter == '(' || letter == '[') ++depth;
    if (letter == ')' || letter == ']') --depth;
    if (letter != ',' || depth > 0) continue;
    words.push_back(trim({text.source, begin, i}));
    begin = i + 1;
  }
  words.push_back(trim({text.source, begin, text.end}));
  return words;
}

std::vector<Span> option_words(const std::vector<SourcePointer>& options) {
  std::vector<Span> words;
  for (const SourcePointer& option : options) {
    const auto size = static_cast<std::uint32_t>(option->text.size());
    const std::vector<Span> more = split_at_commas({option.get(), 0, size});
    words.insert(words.end(), more.begin(), more.end());
  }
  return words;
}

Result<std::vector<KeySyntax>> parse_options(const std::vector<SourcePointer>& options,
                                             KeyType type, const Limits& limits) {
  OptionReader reader(type, limits);
  for (const Span& word : option_words(options)) reader.read_word(word);
  return reader.take_keys();
}

}  // namespace elgen
