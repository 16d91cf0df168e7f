// forked: child processes, whose end is a signal; one poll waits for it and for interrupts.
// run_forked spreads work over processes, so that all cores compute, with memory that they share.
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

/// While this object exists, SIGCHLD is blocked, so that signalfd can report the end of a child.
class ChildSignal {
 public:
  ChildSignal();
  ChildSignal(const ChildSignal&) = delete;
  ChildSignal& operator=(const ChildSignal&) = delete;
  ~ChildSignal();

 private:
  struct sigaction action_ {};
  sigset_t mask_{};
};

/// A running child that leads a process group. The whole group is ended with the child, and by the
/// destructor.
class Child {
 public:
  explicit Child(pid_t id) : id_(id) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();

  [[nodiscard]] bool has_ended();
  [[nodiscard]] Ending ending() const;
  /// Exit status; 128 + signal if a signal ended the child; -1 while it runs.
  [[nodiscard]] int status() const;

 private:
  /// Ends the remaining processes of the group, and waits for the child.
  void end_group();

  pid_t id_;
  int state_ = 0;
  bool has_ended_ = false;
};

/// Readable when a child ends or an interrupt arrives; both signals must be blocked.
[[nodiscard]] Descriptor signals_to_wait_for();

/// Reads one signal. An interrupt is raised again, to be delivered once signals are unblocked. True
/// for an interrupt.
[[nodiscard]] bool read_interrupt(const Descriptor& signals);

/// `size` zeros in memory that forked processes write and this process reads after they end. T is
/// plain data, or a lock-free atomic of plain data.
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

/// The common ending of all processes: exit code 0, or the ending of the first process that failed.
struct ForkedEnding {
  Ending ending = Ending::exited;
  int status = 0;  ///< as in ProcessResult

  [[nodiscard]] bool succeeded() const { return ending == Ending::exited && status == 0; }
};

/// Calls work(0) ... work(count - 1), each in a fork of this process, and waits for all forks. If a
/// fork fails or an interrupt arrives, the other forks are ended. Forks return results in a
/// SharedArray, or in a file that is open before the call. `on_wait` is called about five times a
/// second. The ending is out_of_time after `seconds` of wall-clock time, or if a fork exhausts its
/// processor time. A fork that throws exits with 70.
[[nodiscard]] ForkedEnding run_forked(std::size_t count,
                                      const std::function<void(std::size_t)>& work,
                                      const std::function<void()>& on_wait,
                                      std::uint64_t seconds = max_run_seconds);

}  // namespace elgen
