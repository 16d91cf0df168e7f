// Whether something was said is known to signal handlers, too.
#include "cli/process/messages.hpp"

#include <unistd.h>

#include <atomic>
#include <cstdio>

#include "base/no_interrupts.hpp"

namespace elgen::cli {

namespace {

std::atomic<bool> something_was_said{false};
static_assert(std::atomic<bool>::is_always_lock_free);

std::string opening(const DiagnosticFormatRow& row) {
  return row.opening == nullptr ? std::string() : row.opening();
}

}  // namespace

void say(const std::string& text) { std::fputs(text.c_str(), stderr); }

void say(const Diagnostics& diagnostics, const DiagnosticStyle& style) {
  const std::string text = format(diagnostics, style);
  if (text.empty()) return;
  const DiagnosticFormatRow& row = format_row(style.format);
  // A limit that is met here is told behind this message, not inside of it: memory is asked for
  // before the first byte, and time has to wait for the last.
  const std::string first = opening(row) + text;
  const std::string next = std::string(row.separator) + text;
  const NoInterrupts until_written;
  say(something_was_said.exchange(true) ? next : first);
}

void say_no_more(DiagnosticFormat format) {
  const DiagnosticFormatRow& row = format_row(format);
  const std::string closing(row.closing);
  const std::string all = opening(row) + closing;
  // Nothing is told behind the end.
  static const NoInterrupts& for_ever = *new NoInterrupts;
  (void)for_ever;
  say(something_was_said.exchange(true) ? closing : all);
}

LastMessage::LastMessage(const Diagnostic& diagnostic, const DiagnosticStyle& style) {
  const DiagnosticFormatRow& row = format_row(style.format);
  const std::string rest = format({diagnostic}, style) + std::string(row.closing);
  first_ = opening(row) + rest;
  next_ = std::string(row.separator) + rest;
}

void LastMessage::say() const {
  const std::string& text = something_was_said ? next_ : first_;
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
}

}  // namespace elgen::cli
