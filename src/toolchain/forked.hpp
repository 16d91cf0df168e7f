// Child processes: their end and interrupts are signals that one poll waits for. Forked: work in
// processes of its own, so that all cores compute, and the memory that they share.
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

/// While this lives, the end of a child is a signal that can be waited for.
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

/// A running child that leads a process group. The whole group is ended with the child, and with
/// its owner.
class Child {
 public:
  explicit Child(pid_t id) : id_(id) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();

  [[nodiscard]] bool has_ended();
  [[nodiscard]] Ending ending() const;
  /// Exit status; 128 + signal where a signal ended it, -1 where nothing has.
  [[nodiscard]] int status() const;

 private:
  /// Ends all that is left of the group, and waits for the child.
  void end_group();

  pid_t id_;
  int state_ = 0;
  bool has_ended_ = false;
};

/// Readable when a child ends or an interrupt comes; both are blocked.
[[nodiscard]] Descriptor signals_to_wait_for();

/// Takes one signal; an ending one is sent again, to be there when nothing is half done any more.
/// Whether it was such.
[[nodiscard]] bool take_interrupt(const Descriptor& signals);

/// `size` zeros that forked processes write to and this one reads when they have ended. T is plain
/// data, or a lock-free atomic of it.
template <class T>
class SharedArray {
 public:
  static_assert(std::is_trivially_destructible_v<T>);

  /// Throws std::bad_alloc where there is no such memory.
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

/// The ending of all processes: exited with 0, or how the first that failed has ended.
struct ForkedEnding {
  Ending ending = Ending::exited;
  int status = 0;  ///< as of a ProcessResult

  [[nodiscard]] bool succeeded() const { return ending == Ending::exited && status == 0; }
};

/// Calls work(0) ... work(count - 1), each in a fork of this process, and waits for all; where one
/// fails, or an interrupt comes, the others are ended. The forks leave their results in a
/// SharedArray, or in a file that is open before. `on_wait` is called five times a second
/// meanwhile. The ending is out_of_time after `seconds` by the clock of this process, and if a fork
/// uses up its processor time; a fork that throws exits 70.
[[nodiscard]] ForkedEnding run_forked(std::size_t count,
                                      const std::function<void(std::size_t)>& work,
                                      const std::function<void()>& on_wait,
                                      std::uint64_t seconds = longest_run);

}  // namespace elgen
