// Signals that end the process arrive only at the end of a SignalBlocker scope.
#include "base/no_interrupts.hpp"

#include <catch2/catch.hpp>

namespace {

volatile std::sig_atomic_t arrived = 0;

void count(int /*signal*/) { arrived = arrived + 1; }

/// Sets the handler of a signal, and restores the previous handler on destruction.
class Disposition {
 public:
  Disposition(int signal, void (*handler)(int))
      : signal_(signal), before_(std::signal(signal, handler)) {}
  Disposition(const Disposition&) = delete;
  Disposition& operator=(const Disposition&) = delete;
  ~Disposition() { std::signal(signal_, before_); }

 private:
  int signal_;
  void (*before_)(int);
};

}  // namespace

TEST_CASE("an interrupt waits until the end of the scope") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) {
    const Disposition counted(signal, count);
    arrived = 0;
    {
      const elgen::SignalBlocker scope;
      CHECK_FALSE(elgen::has_pending_interrupt());
      std::raise(signal);
      CHECK(elgen::has_pending_interrupt());
      CHECK(arrived == 0);
    }
    CHECK(arrived == 1);
    CHECK_FALSE(elgen::has_pending_interrupt());
  }
}

TEST_CASE("a signal that the process ignores interrupts nothing") {
  const Disposition ignored(SIGHUP, SIG_IGN);
  const elgen::SignalBlocker scope;
  std::raise(SIGHUP);
  CHECK_FALSE(elgen::has_pending_interrupt());
  const sigset_t ending = elgen::termination_signals();
  CHECK(sigismember(&ending, SIGHUP) == 0);
  CHECK(sigismember(&ending, SIGINT) == 1);
}
