// forked: child processes. One poll() waits for the end of a child and for interrupts. run_forked()
// distributes work over forked processes, which use all cores and share memory.
#pragma once

#include <sys/mman.h>
#include <sys/types.h>

#include <csignal>
#include <cstddef>
#include <functional>
#include <new>
#include <type_traits>

#include "base/descriptor.hpp"
#include "toolchain/process.hpp"

namespace elgen {

/// Blocks SIGCHLD during its lifetime, so that a signalfd can report the end of a child.
class ChildSignalBlock {
 public:
  ChildSignalBlock();
  ChildSignalBlock(const ChildSignalBlock&) = delete;
  ChildSignalBlock& operator=(const ChildSignalBlock&) = delete;
  ~ChildSignalBlock();

 private:
  struct sigaction action_ {};
  sigset_t mask_{};
};

/// A child that leads a process group. When the child ends, and in the destructor, the remaining
/// processes of the group are killed.
class Child {
 public:
  explicit Child(pid_t id) : id_(id) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();

  [[nodiscard]] bool has_ended();
  [[nodiscard]] ProcessEnding ending() const;
  /// The exit status; 128 + signal if a signal ended the child; -1 while the child runs.
  [[nodiscard]] int status() const;

 private:
  /// Kills the processes of the group, and waits for the child.
  void end_group();

  pid_t id_;
  int state_ = 0;
  bool has_ended_ = false;
};

/// A descriptor that becomes readable when a child ends or an interrupt arrives. SIGCHLD and the
/// termination signals must be blocked.
[[nodiscard]] FileDescriptor open_signal_descriptor();

/// Reads one signal. An interrupt is raised again, so that it is delivered when signals are
/// unblocked. True if the signal is an interrupt.
[[nodiscard]] bool read_interrupt(const FileDescriptor& signals);

/// An array of `size` zeros, which forked processes write, and which this process reads when they
/// have ended. T must be plain data, or a lock-free atomic of plain data.
template <class T>
class SharedArray {
 public:
  static_assert(std::is_trivially_destructible_v<T>);

  /// Throws std::bad_alloc if the memory cannot be mapped.
  explicit SharedArray(std::size_t size) : size_(size) {
    void* const memory = ::mmap(nullptr, size * sizeof(T), PROT_READ | PROT_WRITE,
                                MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    first_ = static_cast<T*>(memory);
  }
  SharedArray(const SharedArray&) = delete;
  SharedArray& operator=(const SharedArray&) = delete;
  ~SharedArray() { ::munmap(first_, size_ * sizeof(T)); }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] T& operator[](std::size_t i) { return first_[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return first_[i]; }

 private:
  T* first_ = nullptr;
  std::size_t size_;
};

/// The common ending of the forks: exit code 0 if all succeeded, otherwise the ending of the first
/// fork that failed.
struct ForkResult {
  ProcessEnding ending = ProcessEnding::exited;
  int status = 0;  ///< as in ProcessResult

  [[nodiscard]] bool succeeded() const { return ending == ProcessEnding::exited && status == 0; }
};

/// Calls work(0) ... work(count - 1), each in a fork of this process, and waits for all forks. If a
/// fork fails or an interrupt arrives, the other forks are killed. Forks return results in a
/// SharedArray, or in a file that was opened before the call. `on_wait` is called about five times
/// a second. The ending is out_of_time after `seconds` of wall-clock time, or if a fork exceeds its
/// limit of processor time. A fork that throws exits with 70.
[[nodiscard]] ForkResult run_forked(std::size_t count, const std::function<void(std::size_t)>& work,
                                    const std::function<void()>& on_wait,
                                    std::uint64_t seconds = max_run_seconds);

}  // namespace elgen
