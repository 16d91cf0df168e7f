// Malformed TOML: the description without its preamble, and a hint where the mistake is a usual one
// (numbers wider than TOML's, expressions without quotes, strings that are not closed).
#include "parse/toml_error.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "elgen/wording.hpp"

namespace elgen {

namespace {

bool is_token_character(char c) { return is_word_character(c) || c == '.' || c == '+' || c == '-'; }

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// "Error while parsing key-value pair: cannot redefine existing integer 'a'" to
/// "cannot redefine existing integer `a`".
std::string message_of(std::string_view description) {
  const std::size_t colon = description.find(": ");
  std::string message(colon == std::string_view::npos ? description
                                                      : description.substr(colon + 2));
  std::replace(message.begin(), message.end(), '\'', '`');
  return message;
}

/// The word at `offset` or just before it: toml++ stops in or after a number it cannot hold.
Span word_at(const SourceText& source, std::uint32_t offset) {
  std::uint32_t begin = offset;
  std::uint32_t end = offset;
  while (begin > 0 && is_token_character(source.text[begin - 1])) --begin;
  while (end < source.text.size() && is_token_character(source.text[end])) ++end;
  return {&source, begin, end};
}

/// One character, or nothing at the end of the file.
Span character_at(const SourceText& source, std::uint32_t offset) {
  if (offset >= source.text.size()) return {&source, offset, offset};
  const std::size_t bytes = std::max<std::size_t>(1, code_point_at(source.text, offset).bytes);
  return {&source, offset, offset + static_cast<std::uint32_t>(bytes)};
}

/// toml++ points at the second value of a key; the key says more. Headers stay as they are.
Span redefined(const SourceText& source, std::uint32_t offset) {
  std::uint32_t end = offset;
  while (end > 0 && (source.text[end - 1] == ' ' || source.text[end - 1] == '=')) --end;
  const Span key = word_at(source, end);
  return end < offset && key.begin < key.end ? key : character_at(source, offset);
}

/// The same key earlier in its table, at the start of a line.
std::optional<Span> first_definition(const SourceText& source, const Span& key) {
  const std::string_view name = covered_text(key);
  std::optional<Span> found;
  for (std::size_t line = 0; line < key.begin; ++line) {
    const std::size_t begin =
        std::min(source.text.find_first_not_of(" \t", line), source.text.size());
    const std::string_view rest = std::string_view(source.text).substr(begin);
    const std::string_view after = rest.substr(std::min(name.size(), rest.size()));
    if (rest.starts_with('[')) found = std::nullopt;
    if (begin < key.begin && rest.starts_with(name) &&
        after.substr(std::min(after.find_first_not_of(" \t"), after.size())).starts_with('=')) {
      const auto first = static_cast<std::uint32_t>(begin);
      found = Span{&source, first, first + static_cast<std::uint32_t>(name.size())};
    }
    line = std::min(source.text.find('\n', line), source.text.size());
  }
  return found;
}

Diagnostic redefinition(const SourceText& source, std::uint32_t offset,
                        std::string_view description) {
  Diagnostic error{Code::E101, redefined(source, offset), message_of(description)};
  if (const auto first = first_definition(source, error.span)) {
    error.hint = "give one of them another name";
    error.related = *first;
    error.related_message = "first given here";
  }
  return error;
}

bool at_line_end(const SourceText& source, std::uint32_t offset) {
  return offset >= source.text.size() || source.text[offset] == '\n' || source.text[offset] == '\r';
}

bool is_too_wide(std::string_view description) {
  return contains(description, "not representable") || contains(description, "length limit") ||
         contains(description, "could not be interpreted") || contains(description, "too long");
}

bool is_unquoted_value(std::string_view description) {
  return contains(description, "decimal integer") || contains(description, "floating-point") ||
         contains(description, "could not determine value type");
}

}  // namespace

bool is_decimal_token(std::string_view token) {
  const std::size_t sign = token.substr(0, 1) == "+" || token.substr(0, 1) == "-" ? 1 : 0;
  const std::string_view digits = token.substr(sign);
  const bool radix = digits.size() > 1 && digits[0] == '0' &&
                     (digits[1] == 'x' || digits[1] == 'o' || digits[1] == 'b');
  constexpr std::string_view characters = "0123456789_.eE+-";
  return !digits.empty() && is_digit(digits[0]) && !radix &&
         digits.find_first_not_of(characters) == std::string_view::npos;
}

Diagnostic toml_error(const SourceText& source, std::uint32_t offset,
                      std::string_view description) {
  const Span word = word_at(source, offset);
  if (is_too_wide(description) && is_decimal_token(covered_text(word))) {
    return {Code::E109, word, in_backticks(covered_text(word)) + " is wider than TOML's numbers",
            "write it as a string, in quotes"};
  }
  if (contains(description, "parsing string") && at_line_end(source, offset)) {
    return {Code::E101, character_at(source, offset), "string is not closed",
            "a string over several lines has three quotes at each end"};
  }
  if (contains(description, "cannot redefine")) return redefinition(source, offset, description);
  return {Code::E101, character_at(source, offset), message_of(description),
          is_unquoted_value(description) ? "texts and expressions are written in quotes" : ""};
}

}  // namespace elgen
