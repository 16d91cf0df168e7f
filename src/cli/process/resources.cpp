// Resource limits and signal handlers. Handlers only write a prepared text and end the process.
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

/// The address sanitizer reserves terabytes of shadow memory, which would exceed the limit of
/// memory.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool has_shadow_memory = true;
#elif !defined(__has_feature)
constexpr bool has_shadow_memory = false;
#elif __has_feature(address_sanitizer)
constexpr bool has_shadow_memory = true;
#else
constexpr bool has_shadow_memory = false;
#endif

/// The last messages of the process. They are formatted in advance, because signal handlers must
/// not allocate memory.
struct FinalMessages {
  DiagnosticStyle style = {};
  std::uint64_t seconds = 0;
  std::optional<std::string> stage = {};
  std::array<std::string, 2> processor_time = {};  ///< the current and the next message
  std::atomic<const std::string*> current_message = nullptr;
  std::string waiting = {};
  std::string memory = {};
};

/// The final messages; never destroyed, because a signal may arrive while the process exits.
FinalMessages& final_messages() {
  static FinalMessages& words = *new FinalMessages;
  return words;
}

[[noreturn]] void exit_with_message(const std::string& text) {
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
  ::_exit(static_cast<int>(ExitCode::limit));
}

void on_processor_time_limit(int /*signal*/) {
  exit_with_message(*final_messages().current_message);
}

void on_input_timeout(int /*signal*/) { exit_with_message(final_messages().waiting); }

void on_interrupt(int /*signal*/) { ::_exit(static_cast<int>(ExitCode::interrupted)); }

Diagnostic time_limit_error(std::string message) {
  return {Code::E909, {}, std::move(message), "`--limit seconds=N` raises the limit"};
}

/// Limits the real time to `seconds`, but at least to 1 s, because alarm(0) would set no limit.
void set_alarm(std::uint64_t seconds) {
  constexpr std::uint64_t longest = 1U << 30U;
  ::alarm(static_cast<unsigned>(std::clamp<std::uint64_t>(seconds, 1, longest)));
}

/// The handler of std::terminate, which C++ calls if a destructor throws. Destructors of libraries
/// throw if memory is exhausted.
[[noreturn]] void on_terminate() {
  try {
    if (std::current_exception() != nullptr) throw;
  } catch (const std::bad_alloc&) {
    exit_with_message(final_messages().memory);
  } catch (...) {
    std::abort();
  }
  std::abort();
}

/// Allocation functions for CLN and GMP that throw std::bad_alloc. By default, GMP aborts, and CLN
/// throws another exception, which make_page_or_code() would catch.
void* allocate(std::size_t size) {
  void* const memory = std::malloc(size);
  return memory == nullptr ? throw std::bad_alloc() : memory;
}

void* reallocate(void* old, std::size_t /*size*/, std::size_t size) {
  void* const memory = std::realloc(old, size);
  return memory == nullptr ? throw std::bad_alloc() : memory;
}

void deallocate(void* old, std::size_t /*size*/) { std::free(old); }

/// A template, because the type of a resource is an enumeration in glibc but int in musl.
template <class Resource>
void set_limit(Resource resource, std::uint64_t value) {
  rlimit both{};
  if (::getrlimit(resource, &both) != 0) return;
  both.rlim_cur = std::min<rlim_t>(value, both.rlim_max);
  ::setrlimit(resource, &both);
}

}  // namespace

void set_resource_limits(const Limits& limits, const DiagnosticStyle& style) {
  final_messages().style = style;
  final_messages().seconds = limits.seconds;
  final_messages().stage.reset();
  set_stage_name("");
  final_messages().memory = format({memory_limit_error(limits)}, style);
  std::set_terminate(on_terminate);
  cln::malloc_hook = allocate;
  ::mp_set_memory_functions(allocate, reallocate, deallocate);
  std::signal(SIGXCPU, on_processor_time_limit);
  std::signal(SIGALRM, on_input_timeout);
  std::signal(SIGXFSZ, SIG_IGN);  // a write beyond the file size limit then fails (E706) and does
                                  // not end the process
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (std::signal(signal, on_interrupt) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  renew_time_limit(limits);
  if (!has_shadow_memory) set_limit(RLIMIT_AS, limits.memory_mib << 20U);
}

void set_stage_name(const std::string& stage) {
  FinalMessages& words = final_messages();
  const std::string name = stage.substr(0, stage.find(','));  // "accuracy" of "accuracy, state 3"
  // Verification calls this at each of many states, so an unchanged name must cost little.
  if (words.stage == name) return;
  words.stage = name;
  std::string& next =
      words.processor_time[words.current_message == words.processor_time.data() ? 1 : 0];
  const std::string place = name.empty() ? "" : fmt::format(", in `{}`", name);
  next = format(
      {time_limit_error(fmt::format("{} s of processor time are used up{}", words.seconds, place))},
      words.style);
  words.current_message = &next;
}

void renew_time_limit(const Limits& limits) {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  const auto seconds = static_cast<std::uint64_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec);
  set_limit(RLIMIT_CPU, seconds + limits.seconds);
}

InputTimeout::InputTimeout(const Limits& limits, const std::string& path) {
  const Diagnostic late =
      time_limit_error(fmt::format("`{}` could not be read within {} s", path, limits.seconds));
  final_messages().waiting = format({late}, final_messages().style);
  set_alarm(limits.seconds);
}

InputTimeout::~InputTimeout() { ::alarm(0); }

Diagnostic memory_limit_error(const Limits& limits) {
  return {Code::E910,
          {},
          fmt::format("{} MiB of memory are used up", limits.memory_mib),
          "`--limit memory_mib=N` raises the limit"};
}

}  // namespace elgen::cli
