// A few runs of the fuzzer of the command line, and tests that it detects each kind of failure.
#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "fuzz/command_line/mutation.hpp"
#include "fuzz/command_line/trial.hpp"
#include "support/shell.hpp"

namespace elgen::test {

namespace {

/// The fault of a trial that runs the shell script `script` in place of elgen; empty if none.
std::string fault_of_script(const std::string& script) {
  const Trial trial{{"m.toml", {{"m.toml", "x"}}}, {"/bin/sh", "-c", script}};
  return run_trial(trial, false).fault;
}

}  // namespace

TEST_CASE("mutated inputs are refused in order or work") {
  const Corpus corpus(10);
  std::size_t worked = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const Trial trial = random_trial(corpus, seed);
    INFO("run " << seed << " of " << trial.input.name);
    const Verdict verdict = run_trial(trial, seed % 50 == 0);
    CHECK(verdict.fault == "");
    worked += verdict.worked ? 1 : 0;
  }
  CHECK(worked >
        15);  // otherwise the parser refuses most mutations, and later stages are not tested
}

TEST_CASE("a seed gives one mutation, which changes the text") {
  const std::string text = "[parameters]\na = 1.5\n[energy]\nV = \"a*x^2 + sin(x)\"\n";
  std::size_t changed = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Draw one(seed);
    Draw same(seed);
    const std::string result = mutate(text, one);
    CHECK(result == mutate(text, same));
    changed += result != text ? 1 : 0;
  }
  CHECK(changed > 80);
}

TEST_CASE("crashes, hangs and undocumented results are detected") {
  CHECK(fault_of_script("exit 0") == "");
  CHECK(fault_of_script("echo no >&2; exit 2") == "");
  CHECK(fault_of_script("exit 2") == "no word of why");
  CHECK(fault_of_script("kill -SEGV $$") == "signal 11");
  CHECK(fault_of_script("echo 'elgen: error[E912]: internal' >&2; exit 70") ==
        "exit 70: elgen: error[E912]: internal");
  CHECK(fault_of_script("echo 'error[E911]: off' >&2; exit 3") == "error[E911]: off");
  CHECK(fault_of_script("touch out.part; echo no >&2; exit 4") == "left behind: out.part");
  CHECK(fault_of_script("mkdir out; echo no >&2; exit 4") == "left behind: out");
  CHECK(fault_of_script("mkdir out; touch out/m.hpp") == "");
}

}  // namespace elgen::test
