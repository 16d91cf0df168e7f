// TokenReader: E915, with the place in the text that would have been written.
#include "readback/token_reader.hpp"

#include <charconv>

#include "elgen/wording.hpp"

namespace elgen {

bool TokenReader::begins(const std::vector<CodeToken>& tokens) const {
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (at_ + i >= code_.tokens.size()) return false;
    const CodeToken& own = code_.tokens[at_ + i];
    if (own.kind != tokens[i].kind || own.text != tokens[i].text) return false;
  }
  return true;
}

bool TokenReader::begins_code(std::string_view code) const {
  std::vector<CodeToken> tokens = code_tokens(code).tokens;
  tokens.pop_back();  // the end
  return begins(tokens);
}

CodeToken TokenReader::advance() {
  const CodeToken token = current();
  if (token.kind != CodeTokenKind::end) ++at_;
  return token;
}

bool TokenReader::accept(std::string_view text) {
  if (!at(text)) return false;
  advance();
  return true;
}

void TokenReader::expect(std::string_view text) {
  if (!accept(text)) fail_expected(in_backticks(text));
}

void TokenReader::expect(const CodeToken& token) {
  const bool is_same = current().kind == token.kind && current().text == token.text;
  if (is_same) {
    advance();
  } else {
    fail_expected(token.text.empty() ? "the end of the line" : in_backticks(token.text));
  }
}

void TokenReader::expect_code(std::string_view code) {
  for (const CodeToken& token : code_tokens(code).tokens) {
    if (token.kind != CodeTokenKind::end) expect(token);
  }
}

std::string_view TokenReader::name() {
  if (!at(CodeTokenKind::name)) fail_expected("a name");
  return advance().text;
}

std::uint32_t TokenReader::integer() {
  const std::string_view text = current().text;
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_octal = text.size() > 1 && text.front() == '0';
  if (text.empty() || error != std::errc() || end != text.data() + text.size() || is_octal) {
    fail_expected("an integer");
  }
  advance();
  return value;
}

void TokenReader::expect_integer(std::size_t value) {
  if (!at(std::to_string(value))) fail_expected(in_backticks(std::to_string(value)));
  advance();
}

void TokenReader::expect_end() {
  if (!at(CodeTokenKind::end)) fail_expected("the end of the file");
}

std::vector<std::string_view> TokenReader::comments() const {
  const std::uint32_t first = at_ == 0 ? 0 : code_.tokens[at_ - 1].comments;
  return {code_.comments.begin() + first, code_.comments.begin() + current().comments};
}

Span TokenReader::span_from(const CodeToken& first) const {
  const CodeToken& last = at_ == 0 ? current() : code_.tokens[at_ - 1];
  return {&source_, first.begin, last.begin + static_cast<std::uint32_t>(last.text.size())};
}

Span TokenReader::span(const CodeToken& token) const {
  return {&source_, token.begin, token.begin + static_cast<std::uint32_t>(token.text.size())};
}

Span TokenReader::span(std::string_view part) const {
  const auto begin = static_cast<std::uint32_t>(part.data() - source_.text.data());
  return {&source_, begin, begin + static_cast<std::uint32_t>(part.size())};
}

void TokenReader::fail(const Span& span, const std::string& message) const {
  const std::string start = function_.empty() ? "" : in_backticks(function_) + ": ";
  throw Mistake{{Code::E915, span, start + message}};
}

void TokenReader::fail_expected(const std::string& what) const {
  const char* const nothing = at(CodeTokenKind::end) ? "the end of the file" : "the end of a line";
  const std::string found = current().text.empty() ? nothing : in_backticks(current().text);
  fail(span(current()), found + " instead of " + what);
}

}  // namespace elgen
