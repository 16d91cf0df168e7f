// Diagnostics are values: a stable code, an exact span, the observed value, perhaps a suggestion.
//
// Every stage returns Result<T>: a value, diagnostics, or a value with warnings. format() is the
// only place that turns a diagnostic into text; error_codes.def is the list of codes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "elgen/source_text.hpp"

namespace elgen {

/// Process exit codes; the number is the interface.
enum class ExitCode : int {
  success = 0,       ///< done, nothing differs, all holds
  differs = 1,       ///< stale output, or a check does not hold
  invalid = 2,       ///< bad command line or an error with a position in an input
  limit = 3,         ///< derived limit reached, or the self-check failed
  inaccessible = 4,  ///< could not read or write, file without our marker, no compiler
  internal = 70,
  interrupted = 130,
};

enum class Code : unsigned short {
#define ELGEN_CODE(code) code,
#include "elgen/error_codes.def"
#undef ELGEN_CODE
};

enum class Severity : unsigned char { note, warning, error };

/// One row of src/base/error_texts.def.
struct CodeRow {
  Code code;
  Severity severity;
  ExitCode exit_code;
  std::string_view name;         ///< "E201"
  std::string_view title;        ///< "unknown name"
  std::string_view explanation;  ///< what it means and how to mend it; printed by `elgen explain`
};

[[nodiscard]] const std::vector<CodeRow>& code_table();
[[nodiscard]] const CodeRow& code_row(Code code);
[[nodiscard]] const CodeRow* find_code(std::string_view name);

/// `message` starts in lower case, ends without a period, puts user text in back-ticks, and names
/// the observed value first. `hint` (optional) stands beside the caret: "did you mean `m`?
/// (parameter, line 20)".
struct Diagnostic {
  Code code;
  Span span;
  std::string message;
  std::string hint = {};
  std::optional<Span> related =
      {};  ///< a second place that matters (where a bracket opened, the first declaration)
  std::string related_message = {};
};

using Diagnostics = std::vector<Diagnostic>;

/// The first error; null where there is none.
[[nodiscard]] const Diagnostic* find_error(const Diagnostics& diagnostics);
[[nodiscard]] bool has_errors(const Diagnostics& diagnostics);

/// Sorts by position (command line last) and removes repeats.
void sort_by_position(Diagnostics& diagnostics);

enum class DiagnosticFormat : unsigned char {
  text,    ///< for people
  json,    ///< an object a line, for programs: nothing else is said, nothing left out
  github,  ///< commands of a workflow, which annotate lines
};

/// How a process writes all that it says.
struct DiagnosticFormatRow {
  DiagnosticFormat format;
  std::string_view word;  ///< of --format
};

/// In the order of the enumeration.
[[nodiscard]] const std::vector<DiagnosticFormatRow>& diagnostic_formats();
[[nodiscard]] const DiagnosticFormatRow& format_row(DiagnosticFormat format);

struct DiagnosticStyle {
  DiagnosticFormat format = DiagnosticFormat::text;
  bool color = false;
  std::size_t maximum = 20;  ///< errors shown; the rest is counted in a last line
};

/// The one formatter:
///
///     model.toml:33:27: error[E201]: unknown name `mq`
///        33 | T = "1/2*M*v2(cart) + 1/2*mq*v2(bob)"
///           |                           ^~ did you mean `m`? (parameter, line 20)
[[nodiscard]] std::string format(const Diagnostics& diagnostics, const DiagnosticStyle& style = {});

/// The exit code of the worst diagnostic; `success` where there is no error.
[[nodiscard]] ExitCode exit_code(const Diagnostics& diagnostics);

/// The candidate nearest to `word` by edit distance (transpositions count one), empty if none is
/// near.
[[nodiscard]] std::string nearest(std::string_view word,
                                  const std::vector<std::string>& candidates);

/// A value with the warnings met, or the errors that prevented it.
template <class T>
struct Result {
  std::optional<T> value = {};
  Diagnostics diagnostics = {};

  Result() = default;
  Result(T result) : value(std::move(result)) {}
  Result(T result, Diagnostics warnings)
      : value(std::move(result)), diagnostics(std::move(warnings)) {}
  Result(Diagnostics errors) : diagnostics(std::move(errors)) {}
  Result(Diagnostic error) : diagnostics{std::move(error)} {}

  explicit operator bool() const { return value.has_value(); }
  T& operator*() { return *value; }
  const T& operator*() const { return *value; }
  T* operator->() { return &*value; }
  const T* operator->() const { return &*value; }
};

}  // namespace elgen
