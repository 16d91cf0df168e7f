// Messages: what is said on stderr, in one format from the first diagnostic to the last.
#pragma once

#include <string>

#include "elgen/diagnostic.hpp"

namespace elgen::cli {

/// Where stderr cannot be written, nobody can be told.
void say(const std::string& text);

/// The first of all opens what its format opens.
void say(const Diagnostics& diagnostics, const DiagnosticStyle& style);

/// Closes that, to be called once at the end; where nothing was said, the whole says so.
void say_no_more(DiagnosticFormat format);

/// What a process says that ends while a signal is handled, prepared while memory may be asked for.
class LastMessage {
 public:
  LastMessage() = default;
  LastMessage(const Diagnostic& diagnostic, const DiagnosticStyle& style);

  /// Allocates nothing.
  void say() const;

 private:
  std::string first_ = {};  ///< where nothing was said before
  std::string next_ = {};
};

}  // namespace elgen::cli
