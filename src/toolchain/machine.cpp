// this_machine: what the compiler, Linux and the C library say of themselves.
#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <sys/utsname.h>

#include <fstream>

#include "elgen/toolchain.hpp"
#include "toolchain/compiler.hpp"
#include "toolchain/plain_text.hpp"

namespace elgen {
namespace {

/// The line of /proc/cpuinfo that x86 has; elsewhere the architecture alone.
std::string processor_name() {
  constexpr std::string_view key = "model name";
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with(key) && colon != std::string::npos) return line.substr(colon + 2);
  }
  utsname system{};
  return ::uname(&system) == 0 ? system.machine : "";
}

}  // namespace

Result<Machine> this_machine(const Limits& limits) {
  const Result<Compiler> compiler = find_compiler(limits.seconds);
  if (!compiler) return compiler.diagnostics;
  return Machine{plain_text(compiler->version), processor_name(),
                 fmt::format("glibc {}", ::gnu_get_libc_version())};
}

}  // namespace elgen
