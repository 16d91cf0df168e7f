// Searches for seeds on which elgen is wrong: elgen_random [SEEDS [FIRST_SEED [PROCESSES]]].
// $ELGEN_SEEDS, $ELGEN_FIRST_SEED and $ELGEN_PROCESSES replace absent arguments. Defaults: 1000
// seeds from 1000, in as many processes as cores. Prints every failure with its seed and the
// smallest model found with the same failure, and writes that model to random_findings/SEED/.
// $ELGEN_MINIMISE limits the runs of elgen that make a model smaller; 0 keeps the first model. The
// exit code is 1 if there was a failure.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>

#include "random/generator.hpp"
#include "random/minimise.hpp"
#include "random/processes.hpp"
#include "random/trial.hpp"
#include "support/shell.hpp"

namespace {

using namespace elgen::test;
using namespace elgen::test::random;

/// Limit of attempts to shrink a failing system; each attempt runs elgen.
constexpr int most_tries = 300;

std::string written(const System& system) {
  std::string text = text_of(system.model);
  if (system.scene.is_present) text += "# scene\n" + text_of(system.scene, system.model);
  return text;
}

bool shows(const System& system, std::uint64_t seed, const std::string& kind) {
  try {
    for (const Finding& finding : all_findings(system, seed)) {
      if (finding.kind == kind) return true;
    }
  } catch (const std::exception&) {
    // A system without true values does not show the failure `kind`.
  }
  return false;
}

void report(std::uint64_t seed, const System& system, const std::vector<Finding>& findings) {
  const std::string kind = findings[0].kind;
  int tries = 0;
  const char* const wanted = std::getenv("ELGEN_MINIMISE");
  const int most = wanted == nullptr ? most_tries : std::atoi(wanted);
  const System small = minimised(system, [&](const System& candidate) {
    return ++tries <= most && shows(candidate, seed, kind);
  });
  std::string text = "seed " + std::to_string(seed) + ": " + kind + "\n" + findings[0].text;
  text += "smallest that fails alike:\n" + written(small);
  write_files(small, "random_findings/" + std::to_string(seed));
  write_text("random_findings/" + std::to_string(seed) + "/finding.txt", text);
  std::printf("%s\n", text.c_str());
  std::fflush(stdout);
}

/// True if elgen is right for the seed.
bool holds(std::uint64_t seed) {
  const System system = Generator(seed).system();
  try {
    const std::vector<Finding> findings = all_findings(system, seed);
    if (findings.empty()) return true;
    report(seed, system, findings);
  } catch (const std::exception& error) {
    std::printf("seed %llu: the test itself fails: %s\n", static_cast<unsigned long long>(seed),
                error.what());
    std::fflush(stdout);
    write_files(system, "random_findings/" + std::to_string(seed));
  }
  return false;
}

/// Tests every seed with this remainder and returns the number of failures.
int work_on(const SearchRange& range, std::uint64_t remainder) {
  int failures = 0;
  for (std::uint64_t i = remainder; i < range.count; i += range.processes) {
    if (!holds(range.first + i)) ++failures;
    if (i / range.processes % 20 == 19) {
      std::printf(
          "process %llu: %llu of %llu seeds, %d failures\n",
          static_cast<unsigned long long>(remainder),
          static_cast<unsigned long long>(i / range.processes + 1),
          static_cast<unsigned long long>((range.count + range.processes - 1) / range.processes),
          failures);
      std::fflush(stdout);
    }
  }
  return failures;
}

}  // namespace

int main(int argc, char** argv) {
  const SearchRange range = read_range(argc, argv, "SEED", 1000);
  return run_in_processes(range, [&](std::uint64_t k) { return work_on(range, k) == 0; });
}
