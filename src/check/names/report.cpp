// Report: collects the diagnostics of one run, each once.
#include "check/names/report.hpp"

#include <algorithm>

namespace elgen {
namespace {

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
  add({code, span, std::move(message), std::move(hint)});
}

Diagnostics Report::sorted() const {
  Diagnostics result = diagnostics_;
  sort_by_position(result);
  return result;
}

}  // namespace elgen
