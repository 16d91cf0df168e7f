// Report: collects the diagnostics of one run without duplicates.
#include "base/report.hpp"

#include <algorithm>

#include "base/ascii.hpp"

namespace elgen {
namespace {

std::string without_digits(std::string text) {
  std::erase_if(text, is_digit);
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

bool Report::has(Code code) const {
  return std::ranges::count(diagnostics_, code, &Diagnostic::code) > 0;
}

void Report::add(Code code, const Span& span, std::string message, std::string hint) {
  add({code, span, std::move(message), std::move(hint)});
}

Diagnostics Report::sorted_diagnostics() const {
  Diagnostics result = diagnostics_;
  sort_by_position(result);
  return result;
}

}  // namespace elgen
