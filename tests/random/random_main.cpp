// Searches for seeds on which elgen is wrong: elgen_random [SEEDS [FIRST_SEED [PROCESSES]]].
// Defaults: 1000 seeds from 1000, in as many processes as cores. $ELGEN_SEEDS, $ELGEN_FIRST_SEED
// and $ELGEN_PROCESSES set them too. Prints every failure with its seed and the smallest model
// found with the same failure, and writes that model to random_findings/SEED/. $ELGEN_MINIMISE
// limits the runs of elgen for the search; 0 disables it. The exit code is 1 if there was a
// failure.
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <thread>

#include "random/generator.hpp"
#include "random/minimise.hpp"
#include "random/trial.hpp"
#include "support/shell.hpp"

namespace {

using namespace elgen::test::random;

/// Limit of attempts to shrink a failing system; each attempt runs elgen.
constexpr int most_tries = 300;

struct Task {
  std::uint64_t first = 1000;
  std::uint64_t count = 1000;
  std::uint64_t processes = 1;
};

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
    // A system without true values does not fail in the same way.
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
  elgen::test::write_text("random_findings/" + std::to_string(seed) + "/finding.txt", text);
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
int work_on(const Task& task, std::uint64_t remainder) {
  int failures = 0;
  for (std::uint64_t i = remainder; i < task.count; i += task.processes) {
    if (!holds(task.first + i)) ++failures;
    if (i / task.processes % 20 == 19) {
      std::printf(
          "process %llu: %llu of %llu seeds, %d failures\n",
          static_cast<unsigned long long>(remainder),
          static_cast<unsigned long long>(i / task.processes + 1),
          static_cast<unsigned long long>((task.count + task.processes - 1) / task.processes),
          failures);
      std::fflush(stdout);
    }
  }
  return failures;
}

std::uint64_t number_from(int argc, char** argv, int index, const char* variable,
                          std::uint64_t otherwise) {
  const char* text = index < argc ? argv[index] : std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

}  // namespace

int main(int argc, char** argv) {
  Task task;
  task.count = number_from(argc, argv, 1, "ELGEN_SEEDS", task.count);
  task.first = number_from(argc, argv, 2, "ELGEN_FIRST_SEED", task.first);
  task.processes = number_from(argc, argv, 3, "ELGEN_PROCESSES",
                               std::max(1U, std::thread::hardware_concurrency()));
  for (std::uint64_t k = 0; k < task.processes; ++k) {
    if (fork() == 0) _exit(work_on(task, k) > 0 ? 1 : 0);
  }
  int worst = 0;
  int status = 0;
  while (wait(&status) > 0) {
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) worst = 1;
  }
  return worst;
}
