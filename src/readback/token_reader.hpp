// TokenReader: the tokens of one file, read from the first to the last; what should stand there and
// does not is thrown as a Mistake.
#pragma once

#include <string>
#include <string_view>

#include "elgen/diagnostic.hpp"
#include "readback/code_tokens.hpp"

namespace elgen {

/// The first difference between a text and what it should say. It leaves this folder as a
/// Diagnostic.
struct Mistake {
  Diagnostic diagnostic;
};

class TokenReader {
 public:
  explicit TokenReader(const SourceText& source)
      : source_(source), code_(code_tokens(source.text)) {}

  [[nodiscard]] const CodeToken& current() const { return code_.tokens[at_]; }
  [[nodiscard]] bool at(std::string_view text) const { return current().text == text; }
  [[nodiscard]] bool at(CodeTokenKind kind) const { return current().kind == kind; }
  /// Whether exactly these tokens come next.
  [[nodiscard]] bool begins(const std::vector<CodeToken>& tokens) const;
  [[nodiscard]] bool begins_code(std::string_view code) const;

  CodeToken advance();
  /// Steps over the token where it is this one.
  bool accept(std::string_view text);
  void expect(std::string_view text);
  void expect(const CodeToken& token);
  /// Every token of `code`: "const Scalar".
  void expect_code(std::string_view code);
  std::string_view name();
  /// The value of a decimal integer without sign.
  std::uint32_t integer();
  void expect_integer(std::size_t value);
  void expect_end();

  /// The comments directly before the current token.
  [[nodiscard]] std::vector<std::string_view> comments() const;

  /// What messages begin with: the function that is read; "" outside of functions.
  void set_function(std::string function) { function_ = std::move(function); }

  /// From this token to the one before the current.
  [[nodiscard]] Span span_from(const CodeToken& first) const;
  [[nodiscard]] Span span(const CodeToken& token) const;
  [[nodiscard]] Span span(std::string_view part) const;
  [[noreturn]] void fail(const Span& span, const std::string& message) const;
  /// The current token stands where something else should.
  [[noreturn]] void fail_expected(const std::string& what) const;

 private:
  const SourceText& source_;
  CodeText code_;
  std::size_t at_ = 0;
  std::string function_;
};

}  // namespace elgen
