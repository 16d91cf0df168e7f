// Child processes: their end and interrupts are signals that one poll waits for.
#pragma once

#include <sys/types.h>

#include <csignal>

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

/// A running child that leads a process group, which is ended with its owner if the child has not
/// ended by itself.
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
  pid_t id_;
  int state_ = 0;
  bool has_ended_ = false;
};

/// Readable when a child ends or an interrupt comes; both are blocked.
[[nodiscard]] Descriptor signals_to_wait_for();

/// Takes one signal; an ending one is sent again, to be there when nothing is half done any more.
/// Whether it was such.
[[nodiscard]] bool take_interrupt(const Descriptor& signals);

}  // namespace elgen
