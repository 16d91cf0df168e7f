// The parent waits for children by id. A child ends with the object that owns it. Forked work is
// completed or its failure is reported, and no process is left running.
#include "toolchain/forked.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <stdexcept>

#include "base/no_interrupts.hpp"

using elgen::ProcessEnding;

namespace {

void nothing() {}

/// Uses processor time forever.
void compute() {
  for (;;) (void)::getppid();
}

/// Runs `work` in a process that leads its own group.
template <class Work>
pid_t forked(const Work& work) {
  const pid_t id = ::fork();
  if (id != 0) return id;
  (void)::setpgid(0, 0);
  work();
  ::_exit(3);
}

}  // namespace

TEST_CASE("every part runs in a process of its own, and its result is in shared memory") {
  elgen::SharedArray<int> found(3);
  elgen::SharedArray<pid_t> process(3);
  const auto ending = elgen::run_forked(
      3,
      [&](std::size_t i) {
        found[i] = static_cast<int>(10 + i);
        process[i] = ::getpid();
      },
      nothing);
  CHECK(ending.succeeded());
  for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] == static_cast<int>(10 + i));
  CHECK(process[0] != ::getpid());
  CHECK(process[0] != process[1]);
}

TEST_CASE("a failure is reported, and the other processes are ended") {
  const auto with = [](const std::function<void()>& fail) {
    elgen::SharedArray<pid_t> waiting(1);
    const auto ending = elgen::run_forked(
        2,
        [&](std::size_t i) {
          waiting[0] = i == 0 ? ::getpid() : waiting[0];
          if (i == 0) ::sleep(100);
          while (waiting[0] == 0) ::usleep(1'000);
          fail();
        },
        nothing);
    CHECK_FALSE(ending.succeeded());
    CHECK(::kill(waiting[0], 0) != 0);
    return ending;
  };
  const auto thrown = with([] { throw std::runtime_error("no"); });
  CHECK(thrown.ending == ProcessEnding::exited);
  CHECK(thrown.status == 70);
  const auto crashed = with([] { (void)::raise(SIGSEGV); });
  CHECK(crashed.ending == ProcessEnding::signalled);
  CHECK(crashed.status == 128 + SIGSEGV);
  const auto late = with([] {
    const rlimit second{1, 2};
    (void)::setrlimit(RLIMIT_CPU, &second);
    compute();
  });
  CHECK(late.ending == ProcessEnding::out_of_time);
}

TEST_CASE(
    "work that stops, sleeps or computes on is ended at the time limit on the parent's clock") {
  const auto in_a_second = [](const std::function<void()>& work) {
    elgen::SharedArray<pid_t> child(1);
    const auto ending = elgen::run_forked(
        1,
        [&](std::size_t) {
          child[0] = ::getpid();
          work();
        },
        nothing, 1);
    CHECK(child[0] > 0);
    CHECK(::kill(child[0], 0) != 0);
    return ending.ending;
  };
  CHECK(in_a_second([] { (void)::raise(SIGSTOP); }) == ProcessEnding::out_of_time);
  CHECK(in_a_second([] {
          (void)::signal(SIGALRM, SIG_IGN);
          for (;;) ::sleep(1000);
        }) == ProcessEnding::out_of_time);
  CHECK(in_a_second(compute) == ProcessEnding::out_of_time);
  CHECK(in_a_second([] { ::usleep(1'000); }) == ProcessEnding::exited);
}

TEST_CASE("the parent is asked regularly while the children run") {
  std::size_t asked = 0;
  const auto ending = elgen::run_forked(
      1, [](std::size_t) { ::usleep(500'000); }, [&asked] { ++asked; });
  CHECK(ending.succeeded());
  CHECK(asked >= 2);
}

TEST_CASE("an interrupt ends all children and is then delivered") {
  static volatile std::sig_atomic_t arrived = 0;
  const auto before = ::signal(SIGTERM, [](int) { arrived = arrived + 1; });
  elgen::SharedArray<pid_t> child(1);
  const auto ending = elgen::run_forked(
      1,
      [&](std::size_t) {
        child[0] = ::getpid();
        (void)::kill(::getppid(), SIGTERM);
        ::sleep(100);
      },
      nothing);
  (void)::signal(SIGTERM, before);
  CHECK(ending.ending == ProcessEnding::interrupted);
  CHECK(arrived == 1);
  CHECK(::kill(child[0], 0) != 0);
}

TEST_CASE("a child that ends by itself has a status, without a child the status is -1") {
  const elgen::SignalBlocker waiting;
  const elgen::ChildSignalBlock end_of_child;
  const elgen::FileDescriptor signals = elgen::open_signal_descriptor();
  elgen::Child child(forked([] { ::usleep(20'000); }));
  CHECK(child.status() == -1);
  while (!child.has_ended()) (void)elgen::read_interrupt(signals);
  CHECK(child.ending() == elgen::ProcessEnding::exited);
  CHECK(child.status() == 3);
}

TEST_CASE("a running child is ended with its owner") {
  pid_t id = 0;
  {
    id = forked([] { ::sleep(100); });
    (void)::setpgid(id, id);
    const elgen::Child child(id);
  }
  CHECK(::kill(id, 0) != 0);
}

TEST_CASE("a signal that ended a child is reported") {
  const elgen::SignalBlocker waiting;
  elgen::Child child(forked([] { (void)::raise(SIGKILL); }));
  while (!child.has_ended()) ::usleep(1'000);
  CHECK(child.ending() == elgen::ProcessEnding::signalled);
  CHECK(child.status() == 128 + SIGKILL);
}

TEST_CASE("an interrupt is taken and stays pending") {
  {
    const elgen::SignalBlocker waiting;
    const elgen::FileDescriptor signals = elgen::open_signal_descriptor();
    CHECK_FALSE(elgen::read_interrupt(signals));
    REQUIRE(::raise(SIGHUP) == 0);
    CHECK(elgen::read_interrupt(signals));
    CHECK(elgen::has_pending_interrupt());
    CHECK(elgen::read_interrupt(signals));  // the pending interrupt was sent again
    const auto ignore = ::signal(SIGHUP, SIG_IGN);
    (void)::signal(SIGHUP, ignore == SIG_ERR ? SIG_DFL : SIG_IGN);
  }
  (void)::signal(SIGHUP, SIG_DFL);
}
