// Helpers of the fuzz targets: an input as a source, and the required properties of every result.
//
// A target is a function of bytes that must return. Whatever a file contains, parsing ends with a
// value or with errors that can be printed, never with a crash, undefined behaviour or a hang.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <string>

#include "elgen/diagnostic.hpp"
#include "elgen/limits.hpp"
#include "elgen/source_text.hpp"

namespace elgen::test {

/// Aborts if `holds` is false, so that libFuzzer keeps the input.
inline void require(bool holds, const std::string& what) {
  if (holds) return;
  fmt::print(stderr, "does not hold: {}\n", what);
  std::abort();
}

inline SourcePointer source_of(const std::uint8_t* data, std::size_t size, std::string path) {
  std::string text(size, '\0');
  for (std::size_t i = 0; i < size; ++i) text[i] = static_cast<char>(data[i]);
  return make_source(std::move(path), std::move(text));
}

/// Limits so small that an input of a few kilobytes cannot take long.
inline Limits small_limits() {
  Limits limits;
  limits.file_bytes = 1U << 14U;
  limits.coordinates = 64;
  limits.definitions = 500;
  return limits;
}

/// Requires a value or at least one error. Every diagnostic must lie inside its source and be
/// printable.
template <class T>
void require_answer(const Result<T>& result) {
  require(result || has_errors(result.diagnostics), "no value without an error");
  for (const Diagnostic& diagnostic : result.diagnostics) {
    const Span& span = diagnostic.span;
    require(
        span.source == nullptr || (span.begin <= span.end && span.end <= span.source->text.size()),
        "a diagnostic lies inside its source: " + diagnostic.message);
    require(!diagnostic.message.empty(), "a diagnostic has a message");
  }
  DiagnosticStyle style;
  static_cast<void>(format(result.diagnostics, style));
  style.format = DiagnosticFormat::json;
  static_cast<void>(format(result.diagnostics, style));
}

}  // namespace elgen::test
