// A limit that is met while diagnostics are written is told behind them, not inside of them.
#include "cli/process/messages.hpp"

#include <cstdio>

#include "base/no_interrupts.hpp"

namespace elgen::cli {

void say(const std::string& text) { std::fputs(text.c_str(), stderr); }

void say(const Diagnostics& diagnostics, const DiagnosticStyle& style) {
  // Memory is asked for before the first byte, and time has to wait for the last.
  const std::string text = format(diagnostics, style);
  const NoInterrupts until_written;
  say(text);
}

}  // namespace elgen::cli
