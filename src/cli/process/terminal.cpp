// terminal: asked of the system where the stream is one, else of the environment.
#include "cli/process/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>

namespace elgen::cli {

namespace {

constexpr std::size_t usual_columns = 80;
constexpr std::size_t least_columns = 40;  ///< narrower ones wrap

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// The first that is set decides, as in setlocale(3).
bool is_utf8() {
  for (const char* const name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    std::string value = variable(name);
    if (value.empty()) continue;
    std::ranges::transform(value, value.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return value.find("utf-8") != std::string::npos || value.find("utf8") != std::string::npos;
  }
  return false;
}

}  // namespace

bool is_terminal(std::FILE* stream) { return ::isatty(::fileno(stream)) != 0; }

Screen screen_of(std::FILE* stream) {
  Screen screen{usual_columns, Alphabet::ascii};
  if (!is_terminal(stream)) return screen;
  winsize size{};
  const bool is_known = ::ioctl(::fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  if (is_known) screen.columns = std::max<std::size_t>(size.ws_col, least_columns);
  const std::string kind = variable("TERM");
  if (is_utf8() && kind != "dumb" && kind != "linux") screen.alphabet = Alphabet::unicode;
  return screen;
}

}  // namespace elgen::cli
