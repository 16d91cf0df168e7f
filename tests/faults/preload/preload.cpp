// A library for LD_PRELOAD: one system call fails, or a signal arrives before one system call.
//
//     ELGEN_FAULT="KIND NUMBER ACTION"    write 3 28: the third write fails with errno 28
//                                         any 7 -9: signal 9 arrives before the seventh call
//     ELGEN_FAULT_COUNTS=FILE             write the number of calls of each kind to FILE
//
// Kinds are open, write, rename, mkdir, spawn, memory, and any; `any` counts all kinds except
// memory. Counting starts at main, because the loader and the runtime make calls before.
#include <dlfcn.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
}

namespace {

enum Kind { open_call, write_call, rename_call, mkdir_call, spawn_call, memory_call, any_call };
constexpr int kinds = 7;
constexpr const char* names[kinds] = {"open", "write", "rename", "mkdir", "spawn", "memory", "any"};

std::atomic<long> counts[kinds];
bool is_armed = false;
int fault_kind = -1;
long fault_number = 0;
int fault_action = 0;

void read_fault() {
  const char* const text = std::getenv("ELGEN_FAULT");
  char name[16] = "";
  if (text == nullptr) return;
  if (std::sscanf(text, "%15s %ld %d", name, &fault_number, &fault_action) != 3) std::abort();
  for (int kind = 0; kind < kinds; ++kind) {
    if (std::strcmp(name, names[kind]) == 0) fault_kind = kind;
  }
}

void write_counts() {
  is_armed = false;
  const char* const path = std::getenv("ELGEN_FAULT_COUNTS");
  std::FILE* const file = path == nullptr ? nullptr : std::fopen(path, "w");
  if (file == nullptr) return;
  for (int kind = 0; kind < kinds; ++kind) {
    std::fprintf(file, "%s %ld\n", names[kind], counts[kind].load());
  }
  std::fclose(file);
}

/// True if this call must fail. A signal is raised here; the call itself then succeeds.
bool is_fault_due(Kind kind) {
  if (++counts[kind] != fault_number || kind != fault_kind) return false;
  if (fault_action > 0) {
    errno = fault_action;
    return true;
  }
  ::raise(-fault_action);
  return false;
}

bool fails(Kind kind) {
  if (!is_armed) return false;
  const bool by_any = kind != memory_call && is_fault_due(any_call);
  return is_fault_due(kind) || by_any;
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

using Main = int(int, char**, char**);
Main* real_main = nullptr;

int counted_main(int count, char** words, char** environment) {
  read_fault();
  ::unsetenv("LD_PRELOAD");  // child processes run without this library
  std::atexit(write_counts);
  is_armed = true;
  return real_main(count, words, environment);
}

}  // namespace

extern "C" {

int __libc_start_main(Main* main, int count, char** words, void (*init)(), void (*fini)(),
                      void (*rtld_fini)(), void* stack_end) {
  real_main = main;
  return next<int(Main*, int, char**, void (*)(), void (*)(), void (*)(), void*)>(
      "__libc_start_main")(counted_main, count, words, init, fini, rtld_fini, stack_end);
}

int open(const char* path, int flags, ...) {
  std::va_list rest;
  va_start(rest, flags);
  const auto mode = va_arg(rest, mode_t);
  va_end(rest);
  if (fails(open_call)) return -1;
  return next<int(const char*, int, mode_t)>("open")(path, flags, mode);
}

std::FILE* fopen(const char* path, const char* mode) {
  if (fails(open_call)) return nullptr;
  return next<std::FILE*(const char*, const char*)>("fopen")(path, mode);
}

std::FILE* fopen64(const char* path, const char* mode) { return fopen(path, mode); }

ssize_t write(int file, const void* data, std::size_t size) {
  if (fails(write_call)) return -1;
  return next<ssize_t(int, const void*, std::size_t)>("write")(file, data, size);
}

ssize_t writev(int file, const iovec* parts, int count) {
  if (fails(write_call)) return -1;
  return next<ssize_t(int, const iovec*, int)>("writev")(file, parts, count);
}

int rename(const char* from, const char* to) noexcept {
  if (fails(rename_call)) return -1;
  return next<int(const char*, const char*)>("rename")(from, to);
}

int link(const char* from, const char* to) noexcept {
  if (fails(rename_call)) return -1;
  return next<int(const char*, const char*)>("link")(from, to);
}

int mkdir(const char* path, mode_t mode) noexcept {
  if (fails(mkdir_call)) return -1;
  return next<int(const char*, mode_t)>("mkdir")(path, mode);
}

char* mkdtemp(char* pattern) noexcept {
  if (fails(mkdir_call)) return nullptr;
  return next<char*(char*)>("mkdtemp")(pattern);
}

int posix_spawnp(pid_t* child, const char* file, const posix_spawn_file_actions_t* actions,
                 const posix_spawnattr_t* attributes, char* const* words,
                 char* const* environment) {
  if (fails(spawn_call)) return errno;
  using Spawn = int(pid_t*, const char*, const posix_spawn_file_actions_t*,
                    const posix_spawnattr_t*, char* const*, char* const*);
  return next<Spawn>("posix_spawnp")(child, file, actions, attributes, words, environment);
}

void* malloc(std::size_t size) { return fails(memory_call) ? nullptr : __libc_malloc(size); }

void* calloc(std::size_t count, std::size_t size) {
  return fails(memory_call) ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* block, std::size_t size) {
  return fails(memory_call) ? nullptr : __libc_realloc(block, size);
}

}  // extern "C"
