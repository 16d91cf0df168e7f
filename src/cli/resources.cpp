// setrlimit and signal handlers; handlers only write a prepared text and leave.
#include "resources.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <string>

namespace elgen::cli {

namespace {

/// The address sanitizer's shadow counts as memory: terabytes of it.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool has_shadow_memory = true;
#elif !defined(__has_feature)
constexpr bool has_shadow_memory = false;
#elif __has_feature(address_sanitizer)
constexpr bool has_shadow_memory = true;
#else
constexpr bool has_shadow_memory = false;
#endif

std::string& time_message() {
  static std::string message;
  return message;
}

void end_on_time(int /*signal*/) {
  const std::string& text = time_message();
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
  ::_exit(static_cast<int>(ExitCode::limit));
}

void end_on_interrupt(int /*signal*/) { ::_exit(static_cast<int>(ExitCode::interrupted)); }

void limit(int resource, std::uint64_t value) {
  rlimit both{};
  if (::getrlimit(static_cast<__rlimit_resource>(resource), &both) != 0) return;
  both.rlim_cur = std::min<rlim_t>(value, both.rlim_max);
  ::setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

}  // namespace

void set_resource_limits(const Limits& limits, const DiagnosticStyle& style) {
  time_message() = format({{Code::E909,
                            {},
                            fmt::format("{} s of processor time are over", limits.seconds),
                            "raised by --limit seconds=N"}},
                          style);
  std::signal(SIGXCPU, end_on_time);
  std::signal(SIGINT, end_on_interrupt);
  renew_time_limit(limits);
  if (!has_shadow_memory) limit(RLIMIT_AS, limits.memory_mib << 20U);
}

void renew_time_limit(const Limits& limits) {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  const auto seconds = static_cast<std::uint64_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec);
  limit(RLIMIT_CPU, seconds + limits.seconds);
}

Diagnostic out_of_memory(const Limits& limits) {
  return {Code::E910,
          {},
          fmt::format("{} MiB of memory are used up", limits.memory_mib),
          "raised by --limit memory_mib=N"};
}

}  // namespace elgen::cli
