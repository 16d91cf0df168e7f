// elgen_mutations [RUNS [FIRST [PROCESSES]]]: runs elgen on mutated models, scenes and robots; by
// default 1000 runs from 0, with one process for each core. $ELGEN_RUNS, $ELGEN_FIRST_RUN and
// $ELGEN_PROCESSES set the same numbers; $ELGEN_ROBOTS names a folder with more robots. Failures
// are printed and saved with their commands in mutation_findings/RUN/. The exit code is 1 if a run
// failed.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "fuzz/command_line/trial.hpp"
#include "random/processes.hpp"

namespace {

using namespace elgen::test;

constexpr std::size_t random_models = 60;
/// Headers are compiled rarely, because compiling takes longer than everything else.
constexpr std::uint64_t runs_per_compiled_header = 20;

struct Counts {
  std::uint64_t runs = 0;
  std::uint64_t worked = 0;
  std::uint64_t findings = 0;
};

void work(const Corpus& corpus, std::uint64_t seed, Counts& counts) {
  const Trial trial = random_trial(corpus, seed);
  Verdict verdict;
  try {
    verdict = run_trial(trial, seed % runs_per_compiled_header == 0);
  } catch (const std::exception& error) {
    verdict.fault = std::string("the fuzzer itself fails: ") + error.what();
  }
  ++counts.runs;
  counts.worked += verdict.worked ? 1 : 0;
  if (verdict.fault.empty()) return;
  ++counts.findings;
  save(trial, verdict.fault, "mutation_findings/" + std::to_string(seed));
  std::printf("run %llu (%s): %s\n", static_cast<unsigned long long>(seed),
              trial.input.name.c_str(), verdict.fault.c_str());
  std::fflush(stdout);
}

void print(std::uint64_t process, const Counts& counts) {
  std::printf("process %llu: %llu runs, %llu worked, %llu findings\n",
              static_cast<unsigned long long>(process),
              static_cast<unsigned long long>(counts.runs),
              static_cast<unsigned long long>(counts.worked),
              static_cast<unsigned long long>(counts.findings));
  std::fflush(stdout);
}

/// Tries every range.processes-th run of `range` from offset `remainder`; false if a run failed.
bool search(const SearchRange& range, std::uint64_t remainder) {
  Corpus corpus(random_models);
  if (const char* const robots = std::getenv("ELGEN_ROBOTS")) corpus.add_robots(robots);
  Counts counts;
  for (std::uint64_t i = remainder; i < range.count; i += range.processes) {
    work(corpus, range.first + i, counts);
    if (counts.runs % 200 == 0) print(remainder, counts);
  }
  print(remainder, counts);
  return counts.findings == 0;
}

}  // namespace

int main(int argc, char** argv) {
  const SearchRange range = read_range(argc, argv, "RUN");
  return run_in_processes(range, [&](std::uint64_t k) { return search(range, k); });
}
