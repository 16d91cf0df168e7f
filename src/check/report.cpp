// Report: collects the diagnostics of one run, each once, and quotes user text in messages.
#include "report.hpp"

#include <algorithm>

namespace elgen::checking {
namespace {

/// As many bytes of `text` as fit, without cutting a UTF-8 sequence.
std::string_view shortened(std::string_view text, std::size_t length) {
  while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) {
    --length;
  }
  return text.substr(0, length);
}

std::string without_digits(std::string text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  text.erase(std::remove_if(text.begin(), text.end(), is_digit), text.end());
  return text;
}

}  // namespace

void Report::add(Diagnostic diagnostic) {
  const Span& span = diagnostic.span;
  if (!seen_
           .insert({span.source, span.begin, span.end, diagnostic.code,
                    without_digits(diagnostic.message)})
           .second) {
    return;
  }
  errors_ += code_row(diagnostic.code).severity == Severity::error ? 1 : 0;
  diagnostics_.push_back(std::move(diagnostic));
}

void Report::add(Code code, const Span& span, std::string message, std::string hint) {
  Diagnostic diagnostic{code, span, std::move(message)};
  diagnostic.hint = std::move(hint);
  add(std::move(diagnostic));
}

Diagnostics Report::sorted() const {
  Diagnostics result = diagnostics_;
  sort_by_position(result);
  return result;
}

std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 60;
  if (text.size() <= longest) {
    return "`" + std::string(text) + "`";
  }
  return "`" + std::string(shortened(text, longest)) + "…`";
}

std::string counted(std::size_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

std::string quoted(const Span& span) { return quoted(covered_text(span)); }

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string near = nearest(word, candidates);
  return near.empty() ? "" : "did you mean `" + near + "`?";
}

}  // namespace elgen::checking
