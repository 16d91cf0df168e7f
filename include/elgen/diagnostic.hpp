// Diagnostics are values: a stable code, an exact span, the observed value, and an optional hint.
//
// Every stage returns Result<T>: a value, errors, or a value with warnings. Only format() turns a
// diagnostic into text; error_codes.def lists the codes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "elgen/source_text.hpp"

namespace elgen {

/// Exit codes of the process; the numbers are the interface.
enum class ExitCode : int {
  success = 0,       ///< done; nothing differs and every check holds
  differs = 1,       ///< stale output, or a check fails
  invalid = 2,       ///< bad command line or an error with a position in an input
  limit = 3,         ///< a limit (elgen/limits.hpp) is exceeded, or the self-check fails
  inaccessible = 4,  ///< unreadable or unwritable file, file without elgen's marker, no compiler
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
  std::string_view explanation;  ///< meaning and remedy; `elgen explain` prints it
};

[[nodiscard]] const std::vector<CodeRow>& code_table();
[[nodiscard]] const CodeRow& code_row(Code code);
[[nodiscard]] const CodeRow* find_code(std::string_view name);

/// `message` starts in lower case, has no final period, puts text of the user in back-ticks, and
/// names the observed value first. `hint` (optional) is printed next to the caret: "did you mean
/// `m`? (parameter, line 20)".
struct Diagnostic {
  Code code;
  Span span;
  std::string message;
  std::string hint = {};
  /// A second place that matters: an opening bracket, the first declaration.
  std::optional<Span> related = {};
  std::string related_message = {};
};

using Diagnostics = std::vector<Diagnostic>;

/// The first error; null if there is none.
[[nodiscard]] const Diagnostic* find_error(const Diagnostics& diagnostics);
[[nodiscard]] bool has_errors(const Diagnostics& diagnostics);

/// Sorts by position, the command line last, and removes duplicates.
void sort_by_position(Diagnostics& diagnostics);

enum class DiagnosticFormat : unsigned char {
  text,    ///< for people
  json,    ///< for programs: one object per line and no other text; `maximum` does not apply
  github,  ///< for GitHub Actions: workflow commands that annotate lines
};

/// One argument of --format. The format applies to all messages of the process.
struct DiagnosticFormatRow {
  DiagnosticFormat format;
  std::string_view word;  ///< the argument of --format
};

/// The rows of all formats, in the order of DiagnosticFormat.
[[nodiscard]] const std::vector<DiagnosticFormatRow>& diagnostic_formats();
[[nodiscard]] const DiagnosticFormatRow& format_row(DiagnosticFormat format);

struct DiagnosticStyle {
  DiagnosticFormat format = DiagnosticFormat::text;
  bool color = false;
  std::size_t maximum = 20;  ///< largest number of shown errors; a last line counts the others
};

/// `diagnostics` as text in the format of `style`:
///
///     model.toml:33:27: error[E201]: unknown name `mq`
///        33 | T = "1/2*M*v2(cart) + 1/2*mq*v2(bob)"
///           |                           ^~ did you mean `m`? (parameter, line 20)
[[nodiscard]] std::string format(const Diagnostics& diagnostics, const DiagnosticStyle& style = {});

/// The largest exit code of all `diagnostics`; `success` without errors.
[[nodiscard]] ExitCode exit_code(const Diagnostics& diagnostics);

/// The candidate with the least edit distance to `word` (a transposition counts 1); empty if no
/// candidate is close.
[[nodiscard]] std::string nearest_word(std::string_view word,
                                       const std::vector<std::string>& candidates);

/// A value with its warnings, or the errors that prevented the value.
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
