// A child is waited for by id, and ended with its owner.
#include "toolchain/child.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>

#include "base/no_interrupts.hpp"

namespace {

/// A process that does `work` as the leader of a group.
template <class Work>
pid_t forked(const Work& work) {
  const pid_t id = ::fork();
  if (id != 0) return id;
  (void)::setpgid(0, 0);
  work();
  ::_exit(3);
}

}  // namespace

TEST_CASE("a child that ends by itself has its status, without any there is -1") {
  const elgen::NoInterrupts waiting;
  const elgen::ChildSignal end_of_child;
  const elgen::Descriptor signals = elgen::signals_to_wait_for();
  elgen::Child child(forked([] { ::usleep(20'000); }));
  CHECK(child.status() == -1);
  while (!child.has_ended()) (void)elgen::take_interrupt(signals);
  CHECK(child.ending() == elgen::Ending::exited);
  CHECK(child.status() == 3);
}

TEST_CASE("a child that still runs is ended with its owner") {
  pid_t id = 0;
  {
    id = forked([] { ::sleep(100); });
    (void)::setpgid(id, id);
    const elgen::Child child(id);
  }
  CHECK(::kill(id, 0) != 0);
}

TEST_CASE("a signal that ends a child is told") {
  const elgen::NoInterrupts waiting;
  elgen::Child child(forked([] { (void)::raise(SIGKILL); }));
  while (!child.has_ended()) ::usleep(1'000);
  CHECK(child.ending() == elgen::Ending::signalled);
  CHECK(child.status() == 128 + SIGKILL);
}

TEST_CASE("an interrupt is taken and waits on") {
  {
    const elgen::NoInterrupts waiting;
    const elgen::Descriptor signals = elgen::signals_to_wait_for();
    CHECK_FALSE(elgen::take_interrupt(signals));
    REQUIRE(::raise(SIGHUP) == 0);
    CHECK(elgen::take_interrupt(signals));
    CHECK(elgen::interrupt_waits());
    CHECK(elgen::take_interrupt(signals));  // it was sent again
    const auto ignore = ::signal(SIGHUP, SIG_IGN);
    (void)::signal(SIGHUP, ignore == SIG_ERR ? SIG_DFL : SIG_IGN);
  }
  (void)::signal(SIGHUP, SIG_DFL);
}
