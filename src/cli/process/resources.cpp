// setrlimit and signal handlers; handlers only write a prepared text and end the process.
#include "cli/process/resources.hpp"

#include <cln/malloc.h>
#include <fmt/format.h>
#include <gmp.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <optional>
#include <string>

namespace elgen::cli {

namespace {

/// The shadow memory of the address sanitizer counts as memory, and it takes terabytes.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool has_shadow_memory = true;
#elif !defined(__has_feature)
constexpr bool has_shadow_memory = false;
#elif __has_feature(address_sanitizer)
constexpr bool has_shadow_memory = true;
#else
constexpr bool has_shadow_memory = false;
#endif

/// The last messages of the process, formatted in advance because signal handlers may not allocate.
struct FinalMessages {
  DiagnosticStyle style = {};
  std::uint64_t seconds = 0;
  std::optional<std::string> stage = {};
  std::array<std::string, 2> processor_time = {};  ///< one is read while the other is written
  std::atomic<const std::string*> stage_now = nullptr;
  std::string waiting = {};
  std::string memory = {};
};

/// Never destroyed, because a signal may arrive while the process ends.
FinalMessages& last_words() {
  static FinalMessages& words = *new FinalMessages;
  return words;
}

[[noreturn]] void end_with(const std::string& text) {
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
  ::_exit(static_cast<int>(ExitCode::limit));
}

void end_on_time(int /*signal*/) { end_with(*last_words().stage_now); }

void end_waiting(int /*signal*/) { end_with(last_words().waiting); }

void end_on_interrupt(int /*signal*/) { ::_exit(static_cast<int>(ExitCode::interrupted)); }

Diagnostic out_of_time(std::string message) {
  return {Code::E909, {}, std::move(message), "`--limit seconds=N` raises the limit"};
}

/// Seconds of real time; alarm(0) would set no limit.
void set_alarm(std::uint64_t seconds) {
  constexpr std::uint64_t longest = 1U << 30U;
  ::alarm(static_cast<unsigned>(std::clamp<std::uint64_t>(seconds, 1, longest)));
}

/// Destructors of libraries allocate memory but may not throw.
[[noreturn]] void end_without_memory() {
  try {
    if (std::current_exception() != nullptr) throw;
  } catch (const std::bad_alloc&) {
    end_with(last_words().memory);
  } catch (...) {
    std::abort();
  }
  std::abort();
}

/// Memory functions that throw std::bad_alloc. Without them CLN throws another exception, after
/// which a page would continue, and GMP, which CLN uses, aborts.
void* allocate(std::size_t size) {
  void* const memory = std::malloc(size);
  return memory == nullptr ? throw std::bad_alloc() : memory;
}

void* reallocate(void* old, std::size_t /*size*/, std::size_t size) {
  void* const memory = std::realloc(old, size);
  return memory == nullptr ? throw std::bad_alloc() : memory;
}

void deallocate(void* old, std::size_t /*size*/) { std::free(old); }

/// The type of a resource is an enumeration in glibc and int in musl.
template <class Resource>
void limit(Resource resource, std::uint64_t value) {
  rlimit both{};
  if (::getrlimit(resource, &both) != 0) return;
  both.rlim_cur = std::min<rlim_t>(value, both.rlim_max);
  ::setrlimit(resource, &both);
}

}  // namespace

void set_resource_limits(const Limits& limits, const DiagnosticStyle& style) {
  last_words().style = style;
  last_words().seconds = limits.seconds;
  last_words().stage.reset();
  name_stage("");
  last_words().memory = format({out_of_memory(limits)}, style);
  std::set_terminate(end_without_memory);
  cln::malloc_hook = allocate;
  ::mp_set_memory_functions(allocate, reallocate, deallocate);
  std::signal(SIGXCPU, end_on_time);
  std::signal(SIGALRM, end_waiting);
  std::signal(SIGXFSZ, SIG_IGN);  // writing to a file that may not grow fails (E706)
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (std::signal(signal, end_on_interrupt) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  renew_time_limit(limits);
  if (!has_shadow_memory) limit(RLIMIT_AS, limits.memory_mib << 20U);
}

void name_stage(const std::string& stage) {
  FinalMessages& words = last_words();
  const std::string name = stage.substr(0, stage.find(','));  // "accuracy, state 3 of 8"
  // Returns early, because verify calls this for each of many states.
  if (words.stage == name) return;
  words.stage = name;
  std::string& next = words.processor_time[words.stage_now == words.processor_time.data() ? 1 : 0];
  const std::string place = name.empty() ? "" : fmt::format(", in `{}`", name);
  next = format(
      {out_of_time(fmt::format("{} s of processor time are used up{}", words.seconds, place))},
      words.style);
  words.stage_now = &next;
}

void renew_time_limit(const Limits& limits) {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  const auto seconds = static_cast<std::uint64_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec);
  limit(RLIMIT_CPU, seconds + limits.seconds);
}

WaitingLimit::WaitingLimit(const Limits& limits, const std::string& path) {
  const Diagnostic late =
      out_of_time(fmt::format("`{}` could not be read within {} s", path, limits.seconds));
  last_words().waiting = format({late}, last_words().style);
  set_alarm(limits.seconds);
}

WaitingLimit::~WaitingLimit() { ::alarm(0); }

Diagnostic out_of_memory(const Limits& limits) {
  return {Code::E910,
          {},
          fmt::format("{} MiB of memory are used up", limits.memory_mib),
          "`--limit memory_mib=N` raises the limit"};
}

}  // namespace elgen::cli
