// Everything for people goes to stderr, through here.
#include <fmt/format.h>

#include <cstdio>

#include "options.hpp"

namespace elgen::cli {

ExitCode report(const GlobalOptions& global, const Diagnostics& diagnostics) {
  fmt::print(stderr, "{}", format(diagnostics, global.style));
  return exit_code(diagnostics);
}

void tell(const GlobalOptions& global, const std::string& line) {
  if (!global.quiet) fmt::print(stderr, "{}\n", line);
}

void tell_times(const GlobalOptions& global, const Products& products) {
  if (!global.timings) return;
  double sum = 0.0;
  for (const StageTime& time : products.times) {
    fmt::print(stderr, "{:>12} {:9.2f} ms\n", time.stage, time.seconds * 1e3);
    sum += time.seconds;
  }
  fmt::print(stderr, "{:>12} {:9.2f} ms\n", "sum", sum * 1e3);
}

}  // namespace elgen::cli
